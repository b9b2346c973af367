/**
 * A sum of skels as it is within a cube: those from afar are added up once, as one polynomial of the second degree, and only the
 * others are asked at each point (SkelField.standIn). What that misses is bounded for each skel without an evaluation; least first they
 * are taken as long as the sum stays below the budget. Within a support that is not reached nothing is missed.
 *
 * Theory: a Taylor remainder by Gegenbauer's generating function (kernel/change.ts); budgets halve from a cube to the one
 * around it. Tried: polynomials of the first degree (lists twice as long, 1.5 × the work); a sort instead of halving a cut.
 */
import type { Vec3 } from '../math/vec.ts';
import { type FieldValue, SPREAD } from '../skeleton/skeleton.ts';
import { evaluateTaylor, shiftedTaylor, TAYLOR, taylorAt } from '../skeleton/taylor.ts';
import { TEST, WITH_GRADIENT } from '../skeleton/work.ts';
import { type BoundTerm, type Grain, UNSEEN } from './boundTerm.ts';
import { AROUND, closed, roundedHalf } from './closed.ts';
import type { LeafFrame } from './leafFrame.ts';
import {
  type Changes,
  type Corners,
  type Far,
  type LeafChange,
  type Near,
  type NearLeaf,
  type Ray,
  rangesApart,
  type Tally,
  type Way,
} from './near.ts';
import { type Colour, commonColour } from './node.ts';
import { SumSight } from './sumSight.ts';

/** A term with its number in the sum. */
interface NearTerm extends BoundTerm {
  readonly number: number;
}

/** What is the same for all cubes. */
interface Whole {
  readonly threshold: number;
  /** of the kernel in the world, mm */
  readonly width: number;
  /** of the field on the surface, nearly: T a millimetre */
  readonly steep: number;
  readonly leaf: number;
  readonly branch: number;
  readonly frame: LeafFrame | null;
  readonly tally: Tally;
  /** of all terms, where they have one */
  readonly plain: Colour | null;
  readonly first: Colour;
  readonly sight: SumSight;
}

/** of what is added up */
const ROUNDING = 4e-15;
/** how often the cut between near and far is halved, as a ratio */
const HALVINGS = 8;

const spread = new Float64Array(SPREAD);
const range = new Float64Array(2);
const ORIGIN: Vec3 = [0, 0, 0];

/** kernel widths between nodes at most: what is thinner would be missed between them */
const RESOLVED = 0.8;
/** of T, however large cells are: intervals want no more */
const MOST_MISSED = 1e-2;

/** The near list of the whole of space: all terms. */
export function nearSum(
  terms: readonly BoundTerm[],
  threshold: number,
  grain: Grain,
  frame: LeafFrame | null,
  tally: Tally,
): Near {
  const plain = commonColour(terms.map(({ colour }) => colour));
  const shrunk = frame?.reach(1) ?? 1;
  const whole = {
    threshold,
    width: grain.width / shrunk,
    steep: grain.slope * shrunk,
    leaf: tally.leaves++,
    branch: tally.branches++,
    frame,
    tally,
    plain,
    first: terms[0]!.colour,
    sight: new SumSight(frame, tally),
  };
  const taylor = new Float64Array(TAYLOR);
  taylor[0] = -threshold;
  const far = { centre: ORIGIN, taylor, colour: new Float64Array(4) };
  const numbered = terms.map((term, number) => ({ ...term, number }));
  return new NearSum(whole, numbered, far, 0, -Infinity, Infinity);
}

class NearSum implements Near {
  readonly low: number;
  readonly high: number;
  readonly error: number;
  readonly branches = 1;
  readonly #whole: Whole;
  readonly #terms: readonly NearTerm[];
  readonly #far: Far;

  constructor(whole: Whole, terms: readonly NearTerm[], far: Far, error: number, low: number, high: number) {
    this.#whole = whole;
    this.#terms = terms;
    this.#far = far;
    this.error = error;
    this.low = low;
    this.high = high;
  }

  get plain(): Colour | null {
    return this.#whole.plain;
  }

  get asked(): number {
    return this.#terms.length;
  }

  value(x: number, y: number, z: number): number {
    const { frame, tally } = this.#whole;
    tally.work += this.#terms.length;
    if (!frame) return this.#value(x, y, z);
    frame.enter(x, y, z);
    return frame.scale * this.#value(frame.x, frame.y, frame.z);
  }

  evaluate(x: number, y: number, z: number, out: FieldValue): void {
    const { frame, tally } = this.#whole;
    tally.work += WITH_GRADIENT * this.#terms.length;
    if (!frame) {
      this.#evaluate(x, y, z, out);
      return;
    }
    frame.enter(x, y, z);
    this.#evaluate(frame.x, frame.y, frame.z, out);
    frame.leave(out);
  }

  colour(x: number, y: number, z: number, out: Float64Array): number {
    const { plain, frame, tally } = this.#whole;
    if (plain) {
      out.set(plain);
      return this.value(x, y, z);
    }
    tally.work += this.#terms.length;
    if (!frame) return this.#colour(x, y, z, out);
    frame.enter(x, y, z);
    return frame.scale * this.#colour(frame.x, frame.y, frame.z, out);
  }

  get span(): readonly [number, number] {
    const { branch } = this.#whole;
    return [branch, branch + 1];
  }

  branch(): number {
    return this.#whole.branch;
  }

  onBranch(_: number, x: number, y: number, z: number, out: FieldValue): void {
    this.evaluate(x, y, z, out);
  }

  corners(nodes: Corners, out: Float64Array): number {
    const { width, leaf, steep } = this.#whole;
    if (nodes.apart <= RESOLVED * width) return nodes.interpolated(this, leaf, out);
    return nodes.roughly ? nodes.halved(this, (2 * this.error) / steep, out) : nodes.exact(this, out);
  }

  get steep(): number {
    const { steep, frame } = this.#whole;
    return steep * (frame?.scale ?? 1);
  }

  get leaves(): readonly [number, number] {
    const { leaf } = this.#whole;
    return [leaf, leaf + 1];
  }

  look(ray: Ray, x: number, y: number, z: number, reach: number): number {
    return this.#whole.sight.look(this.#terms, this.#far, ray, x, y, z, reach);
  }

  clear(): number {
    return this.#whole.sight.clear(this);
  }

  ahead(t: number, out: Float64Array): void {
    this.#whole.sight.range(this, t, out);
  }

  /** Of what came less what went: moved a little, both hardly differ. */
  effect(newer: Near, changes: Changes, x: number, y: number, z: number, cube: number): number {
    const { leaf, frame, tally } = this.#whole;
    const change = changes.get(leaf);
    if (change === undefined) return 0;
    if (change === null) return rangesApart(this, newer.within(x, y, z, cube, 0));
    const half = roundedHalf(x, y, z, cube);
    const off = frame?.off(x, y, z, AROUND * half) ?? 0;
    frame?.enter(x, y, z);
    const [px, py, pz] = frame ? [frame.x, frame.y, frame.z] : [x, y, z];
    const radius = (frame?.reach(AROUND * half) ?? AROUND * half) + off;
    spread.fill(0);
    for (const { field, factor } of change.added) field.spread(px, py, pz, radius, factor, spread);
    for (const { field, factor } of change.removed) field.spread(px, py, pz, radius, -factor, spread);
    tally.work += (WITH_GRADIENT + TEST) * (change.added.length + change.removed.length);
    frame?.turn(spread);
    closed(spread, half + off, range);
    const swing = Math.max(Math.abs(range[0]!), Math.abs(range[1]!));
    return (frame?.scale ?? 1) * Math.min(swing, movedApart(change, px, py, pz, radius));
  }

  eachLeaf(visit: (leaf: NearLeaf) => void): void {
    const terms = this.#terms.map(({ number }) => number);
    visit({ leaf: this.#whole.leaf, dropped: null, terms, far: this.#far });
  }

  eachDropped(way: Way, visit: (leaf: NearLeaf) => void): void {
    visit({ leaf: this.#whole.leaf, dropped: way, terms: null, far: null });
  }

  within(x: number, y: number, z: number, cube: number, missed: number): Near {
    const whole = this.#whole;
    const { frame } = whole;
    const half = roundedHalf(x, y, z, cube);
    const radius = AROUND * half;
    if (!frame) return this.#cut([x, y, z], radius, half, 0, missed);
    frame.enter(x, y, z);
    const off = frame.off(x, y, z, radius);
    return this.#cut([frame.x, frame.y, frame.z], frame.reach(radius) + off, half, off, missed);
  }

  /** `radius`: of the ball in the leaf's frame, `half` of the cube in the world; `off`: what rounding does to places. */
  #cut(centre: Vec3, radius: number, half: number, off: number, allowed: number): Near {
    const [x, y, z] = centre;
    const { threshold, steep, tally, frame } = this.#whole;
    const old = this.#far;
    const taylor = shiftedTaylor(old.taylor, x - old.centre[0], y - old.centre[1], z - old.centre[2]);
    const colour = old.colour.slice();
    const terms = this.#terms;
    const budget = Math.min(allowed * steep, MOST_MISSED * threshold) - this.error;
    const missed = missedOf(terms.length);
    const near: NearTerm[] = [];
    spread.fill(0);
    for (let i = 0; i < terms.length; i++) {
      const term = terms[i]!;
      const size = Math.abs(term.factor);
      missed[i] = size * term.field.missed(x, y, z, radius, budget / size);
      if (missed[i]! <= budget) continue;
      near.push(term);
      term.field.spread(x, y, z, radius, term.factor, spread);
    }
    tally.work += TEST * terms.length;
    const cut = budget > 0 ? cutFor(missed, terms.length, budget) : 0;
    let error = this.error;
    let isSorted = true;
    for (let i = 0; i < terms.length; i++) {
      if (!(missed[i]! <= budget)) continue;
      const term = terms[i]!;
      const { field, factor } = term;
      if (missed[i]! <= cut) {
        const before = taylor[0]!;
        tally.work += field.standIn(x, y, z, radius, factor, taylor);
        addColour(colour, taylor[0]! - before - UNSEEN * threshold, term.colour);
        error += missed[i]! + ROUNDING * Math.abs(taylor[0]! - before);
      } else {
        near.push(term);
        isSorted = false;
        field.spread(x, y, z, radius, factor, spread);
      }
    }
    if (!isSorted) near.sort((a, b) => a.number - b.number);
    tally.work += (WITH_GRADIENT + TEST) * near.length;
    const scale = frame ? frame.scale : 1;
    this.#range(taylor, radius, half, off, error);
    const margin = frame ? ROUNDING * Math.max(Math.abs(range[0]!), Math.abs(range[1]!)) : 0;
    return new NearSum(
      this.#whole,
      near.length === terms.length ? terms : near,
      { centre, taylor, colour },
      error,
      scale * (range[0]! - margin),
      scale * (range[1]! + margin),
    );
  }

  /** From the spread of the near terms and the polynomial of the others. */
  #range(taylor: Float64Array, radius: number, half: number, off: number, error: number): void {
    const { threshold, frame } = this.#whole;
    const bent = bendWithin(taylor, frame ? radius : half);
    const slope = Math.abs(taylor[1]!) + Math.abs(taylor[2]!) + Math.abs(taylor[3]!);
    const swing = (frame ? radius : half) * slope + bent;
    const margin = error + ROUNDING * (threshold + Math.abs(taylor[0]!) + Math.abs(spread[0]!));
    for (let i = 0; i < 4; i++) spread[i] = spread[i]! + taylor[i]!;
    spread[5] = spread[5]! + taylor[0]! - swing - margin;
    spread[6] = spread[6]! + taylor[0]! + swing + margin;
    spread[4] =
      spread[4]! +
      bent +
      margin +
      2 * off * (Math.abs(spread[1]!) + Math.abs(spread[2]!) + Math.abs(spread[3]!));
    frame?.turn(spread);
    closed(spread, half, range);
  }

  #value(x: number, y: number, z: number): number {
    const { centre, taylor } = this.#far;
    const terms = this.#terms;
    let sum = taylorAt(taylor, x - centre[0], y - centre[1], z - centre[2]);
    for (let i = 0; i < terms.length; i++) {
      const term = terms[i]!;
      sum += term.factor * term.field.value(x, y, z);
    }
    return sum;
  }

  #evaluate(x: number, y: number, z: number, out: FieldValue): void {
    const { centre, taylor } = this.#far;
    const terms = this.#terms;
    evaluateTaylor(taylor, x - centre[0], y - centre[1], z - centre[2], out);
    for (let i = 0; i < terms.length; i++) {
      const term = terms[i]!;
      term.field.add(x, y, z, term.factor, out);
    }
  }

  #colour(x: number, y: number, z: number, out: Float64Array): number {
    const { centre, taylor, colour: far } = this.#far;
    const { threshold, first } = this.#whole;
    const mean = far.slice();
    let sum = taylorAt(taylor, x - centre[0], y - centre[1], z - centre[2]);
    for (const { field, factor, colour } of this.#terms) {
      const value = factor * field.value(x, y, z);
      sum += value;
      addColour(mean, value - UNSEEN * threshold, colour);
    }
    const weight = mean[0]!;
    for (let i = 0; i < 3; i++) out[i] = weight > 0 ? mean[i + 1]! / weight : first[i]!;
    return sum;
  }
}

/** Of terms that were replaced one by one. */
function movedApart(
  { removed, added }: NonNullable<LeafChange>,
  x: number,
  y: number,
  z: number,
  radius: number,
): number {
  if (removed.length !== added.length) return Infinity;
  return removed.reduce((sum, { field, factor }, i) => {
    const other = added[i]!;
    return other.factor === factor
      ? sum + Math.abs(factor) * field.apart(other.field, x, y, z, radius)
      : Infinity;
  }, 0);
}

/** A running sum that does not overflow where singular fields are large: what counts are ratios. */
function addColour(mean: Float64Array, seen: number, colour: Colour): void {
  if (!(seen > 0)) return;
  const weight = Math.min(seen, 1e100);
  mean[0] = mean[0]! + weight;
  for (let i = 0; i < 3; i++) mean[i + 1] = mean[i + 1]! + weight * colour[i]!;
}

let missedBuffer = new Float64Array(64);

/** For so many terms; the same for all cubes, one after the other. */
function missedOf(count: number): Float64Array {
  if (missedBuffer.length < count) missedBuffer = new Float64Array(2 * count);
  return missedBuffer;
}

/** The largest cut for which all that is not above it adds up to no more than the budget, nearly. */
function cutFor(missed: Float64Array, count: number, budget: number): number {
  const sumTo = (cut: number) => {
    let sum = 0;
    for (let i = 0; i < count; i++) if (missed[i]! <= cut) sum += missed[i]!;
    return sum;
  };
  let [low, high] = [budget / count, budget];
  if (sumTo(high) <= budget) return high;
  for (let i = 0; i < HALVINGS; i++) {
    const cut = Math.sqrt(low * high);
    if (sumTo(cut) <= budget) low = cut;
    else high = cut;
  }
  return low;
}

/** What the terms of the second degree may add to the value in the middle. */
function bendWithin(c: Float64Array, half: number): number {
  let sum = 0;
  for (let i = 4; i < TAYLOR; i++) sum += Math.abs(c[i]!);
  return half * half * sum;
}
