/**
 * By how much the field of a sum may change within a cube when some of its terms do: of what came less what went. Moved a little, both
 * hardly differ.
 */
import { Ball } from '../skeleton/ball.ts';
import { SPREAD } from '../skeleton/skeleton.ts';
import { TEST, WITH_GRADIENT } from '../skeleton/work.ts';
import { AROUND, closed, roundedHalf } from './closed.ts';
import type { LeafChange } from './near.ts';
import type { WholeSum } from './nearList.ts';

const spread = new Float64Array(SPREAD);
const range = new Float64Array(2);
const ball = new Ball();

/** In the cube about (x, y, z) with edges of 2 `cube`, in the world. */
export function changeWithin(
  { frame, tally }: WholeSum,
  change: NonNullable<LeafChange>,
  x: number,
  y: number,
  z: number,
  cube: number,
): number {
  const half = roundedHalf(x, y, z, cube);
  const off = frame?.off(x, y, z, AROUND * half) ?? 0;
  frame?.enter(x, y, z);
  const radius = (frame?.reach(AROUND * half) ?? AROUND * half) + off;
  ball.set(frame?.x ?? x, frame?.y ?? y, frame?.z ?? z, radius);
  spread.fill(0);
  for (const { field, factor } of change.added) field.spread(ball, factor, spread);
  for (const { field, factor } of change.removed) field.spread(ball, -factor, spread);
  tally.work += (WITH_GRADIENT + TEST) * (change.added.length + change.removed.length);
  frame?.turn(spread);
  closed(spread, half + off, range);
  const swing = Math.max(Math.abs(range[0]!), Math.abs(range[1]!));
  return (frame?.scale ?? 1) * Math.min(swing, movedApart(change));
}

/** Of terms that were replaced one by one, within `ball`. */
function movedApart({ removed, added }: NonNullable<LeafChange>): number {
  if (removed.length !== added.length) return Infinity;
  return removed.reduce((sum, { field, factor }, i) => {
    const other = added[i]!;
    return other.factor === factor ? sum + Math.abs(factor) * field.apart(other.field, ball) : Infinity;
  }, 0);
}
