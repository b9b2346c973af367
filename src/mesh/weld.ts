/**
 * Welding: vertices in the same place, bit for bit, become one. An open-addressed table over the float32 bits,
 * so that no key is ever made into a string or an object.
 */

export interface Weld {
  /** place of each vertex, 0 … count − 1, numbered in the order of first appearance */
  readonly ids: Uint32Array;
  readonly count: number;
}

/** `positions` is x y z per vertex. −0 and 0 are one place; NaN is never the same place as another. */
export function weld(positions: Float32Array): Weld {
  const vertices = positions.length / 3;
  const size = tableSize(vertices);
  // one more than the vertex that holds the slot; 0 = free
  const slots = new Uint32Array(size);
  const ids = new Uint32Array(vertices);
  const bits = new Uint32Array(Float32Array.from(positions, (x) => x + 0).buffer);
  let count = 0;
  for (let i = 0; i < vertices; i++) {
    let slot = hash(bits, 3 * i) & (size - 1);
    while (slots[slot]! !== 0 && !equal(positions, 3 * (slots[slot]! - 1), 3 * i)) {
      slot = (slot + 1) & (size - 1);
    }
    if (slots[slot]! === 0) {
      slots[slot] = i + 1;
      ids[i] = count++;
    } else {
      ids[i] = ids[slots[slot]! - 1]!;
    }
  }
  return { ids, count };
}

/** A power of two at least twice the number of entries. */
function tableSize(entries: number): number {
  let size = 16;
  while (size < 2 * entries) size *= 2;
  return size;
}

function hash(bits: Uint32Array, at: number): number {
  let h = Math.imul(bits[at]!, 0x9e3779b1);
  h = Math.imul(h ^ (h >>> 15) ^ bits[at + 1]!, 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13) ^ bits[at + 2]!, 0xc2b2ae35);
  return h ^ (h >>> 16);
}

function equal(positions: Float32Array, a: number, b: number): boolean {
  return (
    positions[a] === positions[b] &&
    positions[a + 1] === positions[b + 1] &&
    positions[a + 2] === positions[b + 2]
  );
}
