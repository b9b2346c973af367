/**
 * The cut between near and far of a sum within a cube. What a far skel's polynomial misses is bounded for each without an evaluation;
 * least first they are taken as long as the sum stays below the budget. Within a support that is not reached nothing is missed.
 *
 * Theory: a Taylor remainder by Gegenbauer's generating function (kernel/change.ts); budgets halve from a cube to the one
 * around it. What is below an even share of the budget is far whatever the others are, and is taken at once. Tried: polynomials of the
 * first degree (lists twice as long, 1.5 × the work); a sort instead of halving a cut.
 */
import { Slab } from '../math/slab.ts';
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
/** of T: intervals want no more */
export const MOST_MISSED = 1e-2;

/** A ball in the frame of the leaf, and the cube in it. */
export interface Cut {
  readonly at: Vec3;
  readonly radius: number;
  /** of the cube's edge, in the world */
  readonly half: number;
  /** what rounding does to places */
  readonly off: number;
}

/** The same for all cubes, one after the other. */
class Scratch {
  /** which terms are near */
  isNear = new Uint8Array(64);
  near = 0;
  /** missed of those that are far */
  error = 0.5;
  /** those that are left open, by their places in the list, and what they miss */
  places = new Int32Array(64);
  missed = new Float64Array(64);
  open = 0;

  fit(count: number): void {
    if (this.missed.length >= count) return;
    this.isNear = new Uint8Array(2 * count);
    this.places = new Int32Array(2 * count);
    this.missed = new Float64Array(2 * count);
  }
}

const scratch = new Scratch();
const slab = new Slab();
const spread = new Float64Array(SPREAD);
const range = new Float64Array(2);
const ball = new Ball();

/** What of `outer`, the list of a cube around, matters in a ball; the surface may be off by `allowed` mm, nearly. */
export function cut(whole: WholeSum, outer: NearList, cube: Cut, allowed: number): NearList {
  const { threshold, steep, tally } = whole;
  const { terms } = outer;
  const far = movedFar(whole, outer.far, cube.at);
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
  const { error } = scratch;
  const missed = error > 0 ? { at: cube.at, radius: cube.radius, error, outer: outer.missed } : outer.missed;
  return { terms: near, far, missed, ...ranged(whole, far, cube, outer.error + error) };
}

/** Sees to all terms that are surely near or far. */
function tell(whole: WholeSum, terms: readonly NearTerm[], budget: number, far: Far): void {
  const { isNear, places, missed } = scratch;
  const share = budget / terms.length;
  let near = 0;
  let open = 0;
  for (let i = 0; i < terms.length; i++) {
    const term = terms[i]!;
    const size = Math.abs(term.factor);
    const misses = size * term.field.missed(ball, budget / size);
    isNear[i] = 0;
    if (misses <= share) takeFar(whole, term, misses, far);
    else if (misses <= budget) {
      places[open] = i;
      missed[open++] = misses;
    } else {
      term.field.spread(ball, term.factor, spread);
      isNear[i] = 1;
      near++;
    }
  }
  scratch.near = near;
  scratch.open = open;
}

/** Sees to those that were left open. */
function settle(whole: WholeSum, terms: readonly NearTerm[], budget: number, far: Far): void {
  const { isNear, places, missed, open } = scratch;
  const most = cutFor(terms.length, budget);
  for (let k = 0; k < open; k++) {
    const i = places[k]!;
    const term = terms[i]!;
    if (missed[k]! <= most) takeFar(whole, term, missed[k]!, far);
    else {
      term.field.spread(ball, term.factor, spread);
      isNear[i] = 1;
      scratch.near++;
    }
  }
}

function takeFar(
  { threshold, tally, plain }: WholeSum,
  { field, factor, colour }: NearTerm,
  missed: number,
  far: Far,
): void {
  const { taylor } = far;
  const before = taylor[0]!;
  tally.work += field.standIn(ball, factor, taylor);
  const added = taylor[0]! - before;
  if (!plain) addColour(far.colour, added - UNSEEN * threshold, colour);
  scratch.error += missed + ROUNDING * Math.abs(added);
}

function movedFar({ plain }: WholeSum, { centre, taylor, colour }: Far, at: Vec3): Far {
  const moved = slab.take(TAYLOR);
  shiftTaylor(taylor, at[0] - centre[0], at[1] - centre[1], at[2] - centre[2], moved);
  return { centre: at, taylor: moved, colour: plain ? colour : colour.slice() };
}

function nearOf(terms: readonly NearTerm[]): readonly NearTerm[] {
  const { isNear } = scratch;
  const near = new Array<NearTerm>(scratch.near);
  let count = 0;
  for (let i = 0; i < terms.length; i++) if (isNear[i] === 1) near[count++] = terms[i]!;
  return near;
}

/** The largest cut for which all that is not above it adds up to no more than the budget, nearly. */
function cutFor(count: number, budget: number): number {
  const room = budget - scratch.error;
  if (openTo(budget) <= room) return budget;
  let low = budget / count;
  let high = budget;
  for (let i = 0; i < HALVINGS; i++) {
    const most = Math.sqrt(low * high);
    if (openTo(most) <= room) low = most;
    else high = most;
  }
  return low;
}

/** Of those left open all that miss no more than that, added up. */
function openTo(most: number): number {
  const { missed, open } = scratch;
  let sum = 0;
  for (let k = 0; k < open; k++) if (missed[k]! <= most) sum += missed[k]!;
  return sum;
}

/** From the spread of the near terms and the polynomial of the others. */
function ranged(
  { threshold, frame }: WholeSum,
  far: Far,
  { radius, half, off }: Cut,
  error: number,
): Pick<NearList, 'error' | 'low' | 'high'> {
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
  if (!frame) return { error, low, high };
  const rounded = ROUNDING * Math.max(Math.abs(low), Math.abs(high));
  const { scale } = frame;
  return { error, low: scale * (low - rounded), high: scale * (high + rounded) };
}

/** What the terms of the second degree may add to the value in the middle. */
function bendWithin(c: Float64Array, half: number): number {
  let sum = 0;
  for (let i = 4; i < TAYLOR; i++) sum += Math.abs(c[i]!);
  return half * half * sum;
}
