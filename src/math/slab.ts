/**
 * Many short arrays of numbers as views into long ones: an engine takes 800 ns for an array of more than eight numbers of its own, 40
 * for a view. As long as one of them is held, all of its slab are.
 */

/** numbers of a slab: 32 KiB */
const SLAB = 4096;

let slab = new Float64Array(SLAB);
let taken = 0;

/** Zeros; `count`: much less than a slab. */
export function shortArray(count: number): Float64Array<ArrayBuffer> {
  if (taken + count > SLAB) {
    slab = new Float64Array(SLAB);
    taken = 0;
  }
  taken += count;
  return slab.subarray(taken - count, taken);
}
