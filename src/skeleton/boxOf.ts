import type { Vec3 } from '../math/vec.ts';
import type { Box } from './skeleton.ts';

/** The smallest box around points. */
export function boxOf(points: readonly Vec3[]): Box {
  const bound = (of: (...numbers: number[]) => number, axis: 0 | 1 | 2) =>
    points.reduce((found, point) => of(found, point[axis]), points[0]![axis]);
  return {
    min: [bound(Math.min, 0), bound(Math.min, 1), bound(Math.min, 2)],
    max: [bound(Math.max, 0), bound(Math.max, 1), bound(Math.max, 2)],
  };
}
