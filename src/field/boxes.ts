/** Boxes along the axes; null is all of space. */
import type { Box } from '../skeleton/skeleton.ts';

export function unite(a: Box | null, b: Box | null): Box | null {
  if (!a || !b) return null;
  return {
    min: [Math.min(a.min[0], b.min[0]), Math.min(a.min[1], b.min[1]), Math.min(a.min[2], b.min[2])],
    max: [Math.max(a.max[0], b.max[0]), Math.max(a.max[1], b.max[1]), Math.max(a.max[2], b.max[2])],
  };
}

/** What both hold; of two that are apart a flat box between them. */
export function meet(a: Box | null, b: Box | null): Box | null {
  if (!a || !b) return a ?? b;
  const low = (i: 0 | 1 | 2) => Math.max(a.min[i], b.min[i]);
  const high = (i: 0 | 1 | 2) => Math.max(low(i), Math.min(a.max[i], b.max[i]));
  return { min: [low(0), low(1), low(2)], max: [high(0), high(1), high(2)] };
}

/** By `d` mm on all sides. */
export function grown({ min, max }: Box, d: number): Box {
  return { min: [min[0] - d, min[1] - d, min[2] - d], max: [max[0] + d, max[1] + d, max[2] + d] };
}

/** mm, of its sides. */
export const longest = ({ min, max }: Box): number =>
  Math.max(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
