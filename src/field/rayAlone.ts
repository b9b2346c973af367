/**
 * One ray, or a few, onto a field for which no bricks are there: all of its box is one brick, whose list is of all skels. Such a ray asks
 * some dozens of values of all of the field, a millisecond; bricks would take a tenth of a second before the first.
 */
import { BRICK } from './lattice.ts';
import { Tally } from './near.ts';
import { PAGE } from './polygonize.ts';
import { Raycaster } from './raycast.ts';
import type { TreeField } from './treeField.ts';

/** of the box: rays are clipped half a cell within the border of the lattice, and the body may touch its box */
const AIR = 1.01;

/** What has no end is cut off where meshes are. FieldError for a box that is not finite. */
export function rayAlone(field: TreeField): Raycaster {
  const tally = new Tally();
  const near = field.near(tally);
  const { min, max } = field.box ?? { min: [-PAGE, -PAGE, -PAGE], max: [PAGE, PAGE, PAGE] };
  const side = AIR * Math.max(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
  const step = side / (BRICK - 1);
  const first = (axis: 0 | 1 | 2) => 0.5 * (min[axis] + max[axis] - BRICK * step);
  const counts = [BRICK + 1, BRICK + 1, BRICK + 1] as const;
  const lattice = { origin: [first(0), first(1), first(2)] as const, step, counts };
  const active = [{ i: 0, j: 0, k: 0, near }];
  return new Raycaster({
    whole: near,
    tally,
    bricks: { lattice, active, counts: [1, 1, 1], grid: Int32Array.of(0) },
  });
}
