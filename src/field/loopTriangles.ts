/**
 * A loop of vertices as triangles: around the corner that leaves the shortest chords, or around a vertex in the middle where a
 * chord might lie in a face of the cube and be a chord of the neighbour's too.
 */

/** What is shorter by rounding alone is not: symmetric bodies have ties, and float32 is to find the same corners. */
const SHORTER = 0.999;

type Triangle = (a: number, b: number, c: number) => void;

/** `positions`: x, y, z of each vertex, as they were added. */
export function eachTriangle(
  ring: readonly number[],
  middle: number | null,
  positions: ArrayLike<number>,
  visit: Triangle,
): void {
  const n = ring.length;
  if (middle !== null) {
    for (let i = 0; i < n; i++) visit(middle, ring[i]!, ring[(i + 1) % n]!);
    return;
  }
  const first = n > 3 ? shortestFan(ring, positions) : 0;
  for (let i = 1; i < n - 1; i++) visit(ring[first]!, ring[(first + i) % n]!, ring[(first + i + 1) % n]!);
}

function shortestFan(ring: readonly number[], positions: ArrayLike<number>): number {
  let [best, least] = [0, Infinity];
  for (let first = 0; first < ring.length; first++) {
    let sum = 0;
    for (let i = 2; i < ring.length - 1; i++) {
      sum += squared(ring[first]!, ring[(first + i) % ring.length]!, positions);
    }
    if (sum < SHORTER * least) [best, least] = [first, sum];
  }
  return best;
}

function squared(a: number, b: number, positions: ArrayLike<number>): number {
  const x = positions[3 * a]! - positions[3 * b]!;
  const y = positions[3 * a + 1]! - positions[3 * b + 1]!;
  const z = positions[3 * a + 2]! - positions[3 * b + 2]!;
  return x * x + y * y + z * z;
}
