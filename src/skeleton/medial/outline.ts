/** Outlines of regions: loops of places, the last joined to the first. */
import { length2, mix2, sub2 } from '../../math/tuple.ts';
import type { Vec2 } from '../../math/vec.ts';

/** mm, at least three places, none repeated */
export type Loop = readonly Vec2[];

/** x, y of both ends of each edge, one after the other: what is asked hundreds of times is asked of numbers in a row. */
export function edgesOf(loops: readonly Loop[]): Float64Array {
  const edges = new Float64Array(4 * loops.reduce((sum, loop) => sum + loop.length, 0));
  let at = 0;
  for (const loop of loops) {
    let before = loop.at(-1);
    for (const p of loop) {
      edges.set([before![0], before![1], p[0], p[1]], at);
      before = p;
      at += 4;
    }
  }
  return edges;
}

/** mm from the nearest edge. */
export function distanceFrom(edges: Float64Array, x: number, y: number): number {
  let least = Infinity;
  for (let k = 0; k < edges.length; k += 4) {
    const ax = edges[k]!;
    const ay = edges[k + 1]!;
    const ex = edges[k + 2]! - ax;
    const ey = edges[k + 3]! - ay;
    const dx = x - ax;
    const dy = y - ay;
    const dot = dx * ex + dy * ey;
    const size = ex * ex + ey * ey;
    const t = dot <= 0 ? 0 : dot >= size ? 1 : dot / size;
    const gx = dx - t * ex;
    const gy = dy - t * ey;
    const gap = gx * gx + gy * gy;
    if (gap < least) least = gap;
  }
  return Math.sqrt(least);
}

/** Inside an odd number of loops. */
export function isWithin(edges: Float64Array, x: number, y: number): boolean {
  let inside = false;
  for (let k = 0; k < edges.length; k += 4) {
    const ay = edges[k + 1]!;
    const by = edges[k + 3]!;
    if (ay > y === by > y) continue;
    const ax = edges[k]!;
    if (x < ax + ((y - ay) / (by - ay)) * (edges[k + 2]! - ax)) inside = !inside;
  }
  return inside;
}

export const distanceTo = ([x, y]: Vec2, loops: readonly Loop[]): number =>
  distanceFrom(edgesOf(loops), x, y);
export const isInside = ([x, y]: Vec2, loops: readonly Loop[]): boolean => isWithin(edgesOf(loops), x, y);

/** mm round all loops. */
export function roundOf(loops: readonly Loop[]): number {
  const edges = edgesOf(loops);
  let sum = 0;
  for (let k = 0; k < edges.length; k += 4) {
    const [ex, ey] = [edges[k + 2]! - edges[k]!, edges[k + 3]! - edges[k + 1]!];
    sum += Math.sqrt(ex * ex + ey * ey);
  }
  return sum;
}

/** mm: the longer side of the box about them. */
export function sizeOf(loops: readonly Loop[]): number {
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const loop of loops) {
    for (const [x, y] of loop) {
      if (x < left) left = x;
      if (x > right) right = x;
      if (y < low) low = y;
      if (y > high) high = y;
    }
  }
  return Math.max(right - left, high - low, 0);
}

/** About `count` places on all loops, as far apart on each, but no fewer than `least` on one: whatever its corners are. */
export function spaced(loops: readonly Loop[], count: number, least = 12): Loop[] {
  const step = roundOf(loops) / count;
  return loops.map((loop) => {
    const lengths = loop.map((p, i) => length2(sub2(p, loop.at(i - 1)!)));
    const round = lengths.reduce((a, b) => a + b, 0);
    const pieces = Math.max(least, Math.round(round / step));
    const places: Vec2[] = [];
    let [edge, before] = [0, 0];
    for (let k = 0; k < pieces; k++) {
      const at = (round * k) / pieces;
      while (edge < loop.length - 1 && before + lengths[edge]! < at) before += lengths[edge++]!;
      const t = Math.min((at - before) / (lengths[edge]! || 1), 1);
      places.push(mix2(loop.at(edge - 1)!, loop[edge]!, t));
    }
    return places;
  });
}

/** Places along the loops, no further apart than `step` mm, their corners among them. */
export function along(loops: readonly Loop[], step: number): Vec2[] {
  return loops.flatMap((loop) =>
    loop.flatMap((b, i) => {
      const a = loop.at(i - 1)!;
      const e = sub2(b, a);
      const pieces = Math.max(1, Math.ceil(length2(e) / step));
      return Array.from({ length: pieces }, (_, k): Vec2 => {
        const t = (k + 1) / pieces;
        return [a[0] + t * e[0], a[1] + t * e[1]];
      });
    }),
  );
}
