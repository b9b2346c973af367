/**
 * A sum of skels as it is within a cube: those from afar are added up once, as one polynomial of the second degree, and only the
 * others are asked at each point (nearCut.ts tells them apart).
 */
import type { Vec3 } from '../math/vec.ts';
import type { FieldValue } from '../skeleton/skeleton.ts';
import { evaluateTaylor, TAYLOR, taylorAt } from '../skeleton/taylor.ts';
import { WITH_GRADIENT } from '../skeleton/work.ts';
import { type BoundTerm, type Grain, UNSEEN } from './boundTerm.ts';
import { AROUND, roundedHalf } from './closed.ts';
import type { LeafFrame } from './leafFrame.ts';
import {
  type BrickCorners,
  branchOf,
  type Changes,
  isFaceOf,
  type Near,
  type NearLeaf,
  type Ray,
  rangesApart,
  type Tally,
  type Way,
} from './near.ts';
import { cut, MOST_MISSED } from './nearCut.ts';
import { addColour, missedAt, type NearList, type NearTerm, type WholeSum } from './nearList.ts';
import { type Colour, commonColour } from './node.ts';
import { changeWithin } from './sumChange.ts';
import { SumSight } from './sumSight.ts';

const ORIGIN: Vec3 = [0, 0, 0];

/** kernel widths between nodes at most: what is thinner would be missed between them */
const RESOLVED = 0.8;

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
    leaf: tally.leaf(),
    frame,
    tally,
    plain,
    isCubic: terms.every(({ field }) => field.isCubic),
    first: terms[0]!.colour,
    sight: new SumSight(frame, tally),
  };
  const taylor = new Float64Array(TAYLOR);
  taylor[0] = -threshold;
  const far = { centre: ORIGIN, taylor, colour: new Float64Array(4) };
  const numbered = terms.map((term, number): NearTerm => ({ ...term, number }));
  return new NearSum(whole, { terms: numbered, far, error: 0, missed: null, low: -Infinity, high: Infinity });
}

class NearSum implements Near {
  readonly branches = 1;
  readonly #whole: WholeSum;
  readonly #list: NearList;

  constructor(whole: WholeSum, list: NearList) {
    this.#whole = whole;
    this.#list = list;
  }

  get low(): number {
    return this.#list.low;
  }

  get high(): number {
    return this.#list.high;
  }

  get error(): number {
    return this.#list.error;
  }

  get plain(): Colour | null {
    return this.#whole.plain;
  }

  get asked(): number {
    return this.#list.terms.length;
  }

  errorAt(x: number, y: number, z: number): number {
    const { frame, isCubic } = this.#whole;
    if (!isCubic) return this.#list.error;
    if (!frame) return missedAt(this.#list.missed, x, y, z);
    frame.enter(x, y, z);
    return missedAt(this.#list.missed, frame.x, frame.y, frame.z);
  }

  value(x: number, y: number, z: number): number {
    const { frame, tally } = this.#whole;
    tally.work += this.#list.terms.length;
    if (!frame) return this.#value(x, y, z);
    frame.enter(x, y, z);
    return frame.scale * this.#value(frame.x, frame.y, frame.z);
  }

  evaluate(x: number, y: number, z: number, out: FieldValue): void {
    const { frame, tally } = this.#whole;
    tally.work += WITH_GRADIENT * this.#list.terms.length;
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
    tally.work += this.#list.terms.length;
    if (!frame) return this.#colour(x, y, z, out);
    frame.enter(x, y, z);
    return frame.scale * this.#colour(frame.x, frame.y, frame.z, out);
  }

  get node(): number {
    return this.#whole.leaf;
  }

  branch(): number {
    return branchOf(this.#whole.leaf);
  }

  holds(branch: number): boolean {
    return isFaceOf(this.#whole.leaf, branch);
  }

  onBranch(_: number, x: number, y: number, z: number, out: FieldValue): void {
    this.evaluate(x, y, z, out);
  }

  corners(nodes: BrickCorners, out: Float64Array): number {
    const { width, leaf, steep } = this.#whole;
    if (nodes.apart <= RESOLVED * width) return nodes.interpolated(this, leaf, out);
    return nodes.roughly ? nodes.halved(this, (2 * this.error) / steep, out) : nodes.exact(this, out);
  }

  get steep(): number {
    const { steep, frame } = this.#whole;
    return steep * (frame?.scale ?? 1);
  }

  get mostMissed(): number {
    const { threshold, steep } = this.#whole;
    return (MOST_MISSED * threshold) / steep;
  }

  look(ray: Ray, x: number, y: number, z: number, reach: number): number {
    return this.#whole.sight.look(this.#list, ray, x, y, z, reach);
  }

  clear(): number {
    return this.#whole.sight.clear(this);
  }

  reached(clear: number): number {
    return this.#whole.sight.reached(clear);
  }

  around(): number {
    return this.#whole.sight.around(this.#list);
  }

  ahead(t: number, out: Float64Array): void {
    this.#whole.sight.range(this, t, out);
  }

  effect(newer: Near, changes: Changes, x: number, y: number, z: number, cube: number): number {
    const change = changes.get(this.#whole.leaf);
    if (change === undefined) return 0;
    if (change === null) return rangesApart(this, newer.within(x, y, z, cube, 0));
    return changeWithin(this.#whole, change, x, y, z, cube);
  }

  eachLeaf(visit: (leaf: NearLeaf) => void): void {
    const { terms, far } = this.#list;
    const numbers = terms.map(({ number }) => number);
    const { leaf, steep } = this.#whole;
    visit({ leaf, dropped: null, terms: numbers, far, steep });
  }

  eachDropped(way: Way, visit: (leaf: NearLeaf) => void): void {
    visit({ leaf: this.#whole.leaf, dropped: way, terms: null, far: null });
  }

  within(x: number, y: number, z: number, cube: number, missed: number): Near {
    const whole = this.#whole;
    const { frame } = whole;
    const half = roundedHalf(x, y, z, cube);
    const radius = AROUND * half;
    if (!frame) {
      return new NearSum(whole, cut(whole, this.#list, { at: [x, y, z], radius, half, off: 0 }, missed));
    }
    frame.enter(x, y, z);
    const off = frame.off(x, y, z, radius);
    const ball = { at: [frame.x, frame.y, frame.z], radius: frame.reach(radius) + off, half, off } as const;
    return new NearSum(whole, cut(whole, this.#list, ball, missed));
  }

  #value(x: number, y: number, z: number): number {
    const { far, terms } = this.#list;
    const { centre, taylor } = far;
    let sum = taylorAt(taylor, x - centre[0], y - centre[1], z - centre[2]);
    for (let i = 0; i < terms.length; i++) {
      const term = terms[i]!;
      sum += term.factor * term.field.value(x, y, z);
    }
    return sum;
  }

  #evaluate(x: number, y: number, z: number, out: FieldValue): void {
    const { far, terms } = this.#list;
    const { centre, taylor } = far;
    evaluateTaylor(taylor, x - centre[0], y - centre[1], z - centre[2], out);
    for (let i = 0; i < terms.length; i++) {
      const term = terms[i]!;
      term.field.add(x, y, z, term.factor, out);
    }
  }

  #colour(x: number, y: number, z: number, out: Float64Array): number {
    const { far, terms } = this.#list;
    const { centre, taylor, colour: weighed } = far;
    const { threshold, first } = this.#whole;
    const mean = weighed.slice();
    let sum = taylorAt(taylor, x - centre[0], y - centre[1], z - centre[2]);
    for (const { field, factor, colour } of terms) {
      const value = factor * field.value(x, y, z);
      sum += value;
      addColour(mean, value - UNSEEN * threshold, colour);
    }
    const weight = mean[0]!;
    for (let i = 0; i < 3; i++) out[i] = weight > 0 ? mean[i + 1]! / weight : first[i]!;
    return sum;
  }
}
