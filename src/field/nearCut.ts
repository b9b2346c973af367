/**
 * The cut between near and far of a sum within a cube. What a far skel's polynomial misses is bounded for each without an evaluation;
 * least first they are taken as long as the sum stays below the budget. Within a support that is not reached nothing is missed.
 *
 * Theory: a Taylor remainder by Gegenbauer's generating function (kernel/change.ts); budgets halve from a cube to the one
 * around it. What is below an even share of the budget is far whatever the others are, and is taken at once. Tried: polynomials of the
 * first degree (lists twice as long, 1.5 × the work); a sort instead of halving a cut.
 */
import { shortArray } from '../math/slab.ts';
import type { Vec3 } from '../math/vec.ts';
import { Ball } from '../skeleton/ball.ts';
import { SPREAD } from '../skeleton/skeleton.ts';
import { shiftTaylor, TAYLOR } from '../skeleton/taylor.ts';
import { TEST, WITH_GRADIENT } from '../skeleton/work.ts';
import { UNSEEN } from './boundTerm.ts';
import { closed } from './closed.ts';
import type { Far } from './near.ts';
import { addColour, type NearList, type NearTerm, type WholeSum } from './nearList.ts';

/** of what is added up */
const ROUNDING = 4e-15;
/** how often the cut is halved, as a ratio */
const HALVINGS = 8;
/** of T, however large cells are: intervals want no more */
const MOST_MISSED = 1e-2;

/** A ball in the frame of the leaf, and the cube in it. */
export interface Cut {
  readonly at: Vec3;
  readonly radius: number;
  /** of the cube's edge, in the world */
  readonly half: number;
  /** what rounding does to places */
  readonly off: number;
}

/** What becomes of a term. */
const FAR = 0;
const OPEN = 1;
const NEAR = 2;

/** The same for all cubes, one after the other. */
class Scratch {
  missed = new Float64Array(64);
  fates = new Uint8Array(64);
  /** missed, of those that are far */
  error = 0.5;
  /** how many are open, and near */
  open = 0;
  near = 0;

  fit(count: number): void {
    if (this.missed.length >= count) return;
    this.missed = new Float64Array(2 * count);
    this.fates = new Uint8Array(2 * count);
  }
}

const scratch = new Scratch();
const spread = new Float64Array(SPREAD);
const range = new Float64Array(2);
const ball = new Ball();

/** What of `outer`, the list of a cube around, matters in a ball; the surface may be off by `allowed` mm, nearly. */
export function cut(whole: WholeSum, outer: NearList, cube: Cut, allowed: number): NearList {
  const { threshold, steep, tally } = whole;
  const { terms } = outer;
  const far = movedFar(outer.far, cube.at);
  const budget = Math.min(allowed * steep, MOST_MISSED * threshold) - outer.error;
  scratch.fit(terms.length);
  scratch.error = 0;
  spread.fill(0);
  ball.set(cube.at[0], cube.at[1], cube.at[2], cube.radius);
  tally.work += TEST * terms.length;
  tell(whole, terms, budget, far);
  if (scratch.open > 0) settle(whole, terms, budget, far);
  tally.work += (WITH_GRADIENT + TEST) * scratch.near;
  const near = scratch.near === terms.length ? terms : nearOf(terms);
  return ranged(whole, near, far, cube, outer.error + scratch.error);
}

/** Sees to all terms that are surely near or far. */
function tell(whole: WholeSum, terms: readonly NearTerm[], budget: number, far: Far): void {
  const { missed, fates } = scratch;
  const share = budget / terms.length;
  let open = 0;
  let near = 0;
  for (let i = 0; i < terms.length; i++) {
    const term = terms[i]!;
    const { field, factor } = term;
    const size = Math.abs(factor);
    const misses = size * field.missed(ball, budget / size);
    if (misses <= share) {
      takeFar(whole, term, misses, far);
      fates[i] = FAR;
    } else if (misses <= budget) {
      missed[i] = misses;
      fates[i] = OPEN;
      open++;
    } else {
      field.spread(ball, factor, spread);
      fates[i] = NEAR;
      near++;
    }
  }
  scratch.open = open;
  scratch.near = near;
}

/** Sees to those that were left open. */
function settle(whole: WholeSum, terms: readonly NearTerm[], budget: number, far: Far): void {
  const { missed, fates } = scratch;
  const most = cutFor(terms.length, budget);
  for (let i = 0; i < terms.length; i++) {
    if (fates[i] !== OPEN) continue;
    const term = terms[i]!;
    if (missed[i]! <= most) takeFar(whole, term, missed[i]!, far);
    else {
      term.field.spread(ball, term.factor, spread);
      fates[i] = NEAR;
      scratch.near++;
    }
  }
}

function takeFar(
  { threshold, tally }: WholeSum,
  { field, factor, colour }: NearTerm,
  missed: number,
  far: Far,
): void {
  const { taylor } = far;
  const before = taylor[0]!;
  tally.work += field.standIn(ball, factor, taylor);
  const added = taylor[0]! - before;
  addColour(far.colour, added - UNSEEN * threshold, colour);
  scratch.error += missed + ROUNDING * Math.abs(added);
}

function movedFar({ centre, taylor, colour }: Far, at: Vec3): Far {
  const moved = shortArray(TAYLOR);
  shiftTaylor(taylor, at[0] - centre[0], at[1] - centre[1], at[2] - centre[2], moved);
  return {
    centre: at,
    taylor: moved,
    colour: Float64Array.of(colour[0]!, colour[1]!, colour[2]!, colour[3]!),
  };
}

function nearOf(terms: readonly NearTerm[]): readonly NearTerm[] {
  const { fates } = scratch;
  const near: NearTerm[] = [];
  for (let i = 0; i < terms.length; i++) if (fates[i] === NEAR) near.push(terms[i]!);
  return near;
}

/** The largest cut for which all that is not above it adds up to no more than the budget, nearly. */
function cutFor(count: number, budget: number): number {
  const room = budget - scratch.error;
  if (openTo(budget, count) <= room) return budget;
  let low = budget / count;
  let high = budget;
  for (let i = 0; i < HALVINGS; i++) {
    const most = Math.sqrt(low * high);
    if (openTo(most, count) <= room) low = most;
    else high = most;
  }
  return low;
}

/** Of those left open all that miss no more than that, added up. */
function openTo(most: number, count: number): number {
  const { missed, fates } = scratch;
  let sum = 0;
  for (let i = 0; i < count; i++) if (fates[i] === OPEN && missed[i]! <= most) sum += missed[i]!;
  return sum;
}

/** From the spread of the near terms and the polynomial of the others. */
function ranged(
  { threshold, frame }: WholeSum,
  terms: readonly NearTerm[],
  far: Far,
  { radius, half, off }: Cut,
  error: number,
): NearList {
  const { taylor } = far;
  const within = frame ? radius : half;
  const bent = bendWithin(taylor, within);
  const swing = within * (Math.abs(taylor[1]!) + Math.abs(taylor[2]!) + Math.abs(taylor[3]!)) + bent;
  const margin = error + ROUNDING * (threshold + Math.abs(taylor[0]!) + Math.abs(spread[0]!));
  for (let i = 0; i < 4; i++) spread[i] = spread[i]! + taylor[i]!;
  spread[5] = spread[5]! + taylor[0]! - swing - margin;
  spread[6] = spread[6]! + taylor[0]! + swing + margin;
  const slope = Math.abs(spread[1]!) + Math.abs(spread[2]!) + Math.abs(spread[3]!);
  spread[4] = spread[4]! + bent + margin + 2 * off * slope;
  frame?.turn(spread);
  closed(spread, half, range);
  const [low, high] = [range[0]!, range[1]!];
  if (!frame) return { terms, far, error, low, high };
  const rounded = ROUNDING * Math.max(Math.abs(low), Math.abs(high));
  const { scale } = frame;
  return { terms, far, error, low: scale * (low - rounded), high: scale * (high + rounded) };
}

/** What the terms of the second degree may add to the value in the middle. */
function bendWithin(c: Float64Array, half: number): number {
  let sum = 0;
  for (let i = 4; i < TAYLOR; i++) sum += Math.abs(c[i]!);
  return half * half * sum;
}
