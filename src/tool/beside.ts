/** What is under the pen, or close beside it: thin parts must be found with a finger, too. */
import type { Pen } from './tool.ts';
import type { Hit, Viewport } from './viewport.ts';

const DIAGONAL = Math.SQRT1_2;
const AROUND = [
  [1, 0],
  [0, 1],
  [-1, 0],
  [0, -1],
  [DIAGONAL, DIAGONAL],
  [-DIAGONAL, DIAGONAL],
  [-DIAGONAL, -DIAGONAL],
  [DIAGONAL, -DIAGONAL],
] as const;

/** Eight ways round at each of the distances, px, nearest first. */
export function pickBeside({ x, y }: Pen, viewport: Viewport, distances: readonly number[]): Hit | null {
  const exact = viewport.pick(x, y);
  if (exact) return exact;
  for (const reach of distances)
    for (const [dx, dy] of AROUND) {
      const hit = viewport.pick(x + reach * dx, y + reach * dy);
      if (hit) return hit;
    }
  return null;
}
