/**
 * One ray, or a few, onto a field for which no bricks are there: all of its box is one brick, whose list is of all skels. Such a ray asks
 * some dozens of values of all of the field, a millisecond; bricks would take a tenth of a second before the first.
 */
import { type Box, FieldError } from '../skeleton/skeleton.ts';
import { longest } from './boxes.ts';
import { BRICK } from './lattice.ts';
import { Tally } from './near.ts';
import { PAGE } from './polygonize.ts';
import { Raycaster } from './raycast.ts';
import type { TreeField } from './treeField.ts';

/** of the box: rays are clipped half a cell within the border of the lattice, and the body may touch its box */
const AIR = 1.01;

/** of how far off a box is: sides, of which rays are polished to a part, have to be longer in float64 */
const DIGITS = 1e-10;

/** What has no end is cut off where meshes are. FieldError for a box that is not finite, or that numbers have no digits for. */
export function rayAlone(field: TreeField): Raycaster {
  const tally = new Tally();
  const near = field.near(tally);
  const { min, max } = field.box ?? { min: [-PAGE, -PAGE, -PAGE], max: [PAGE, PAGE, PAGE] };
  checkDigits({ min, max });
  const side = AIR * longest({ min, max });
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

function checkDigits(box: Box): void {
  const side = longest(box);
  const far = Math.max(...box.min.map(Math.abs), ...box.max.map(Math.abs));
  // squares of lengths are taken
  if (!(far * far < Infinity)) throw new FieldError('the body is not bounded by finite numbers');
  if (side < DIGITS * far) throw new FieldError('the body is too far off for its size');
}
