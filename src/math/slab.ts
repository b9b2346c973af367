/**
 * Many short arrays of numbers as views into long ones: an engine takes 800 ns for an array of more than eight numbers of its own, 40
 * for a view. As long as one of them is held, all of its slab are.
 */

/** numbers: 32 KiB */
const SIZE = 4096;

export class Slab {
  #numbers = new Float64Array(0);
  #taken = 0;

  /** Zeros; `count`: much less than a slab. */
  take(count: number): Float64Array<ArrayBuffer> {
    if (this.#taken + count > this.#numbers.length) {
      this.#numbers = new Float64Array(SIZE);
      this.#taken = 0;
    }
    this.#taken += count;
    return this.#numbers.subarray(this.#taken - count, this.#taken);
  }
}
