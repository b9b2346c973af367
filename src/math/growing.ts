/**
 * Numbers that are added one after the other: an array that grows by halves, of half or a quarter of the bytes that the engine's own lists of
 * numbers have.
 */

type Numbers = Float64Array<ArrayBuffer> | Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>;

/** numbers at first */
const FIRST = 3072;

export class Growing<A extends Numbers> {
  /** those up to `length` count; another one after each addition */
  array: A;
  length = 0;
  readonly #make: new (
    length: number,
  ) => A;

  constructor(make: new (length: number) => A) {
    this.#make = make;
    this.array = new make(FIRST);
  }

  push(a: number, b: number, c: number): void {
    if (this.length + 3 > this.array.length) this.#grow();
    const { array, length } = this;
    array[length] = a;
    array[length + 1] = b;
    array[length + 2] = c;
    this.length = length + 3;
  }

  /** Those that were added, no copy. */
  numbers(): A {
    return this.array.subarray(0, this.length) as A;
  }

  #grow(): void {
    const { array } = this;
    this.array = new this.#make(3 * Math.ceil(array.length / 2));
    this.array.set(array);
  }
}
