/** A shape as it is within a cube: itself, always asked whole. Faces of those that have edges are its branches. */
import type { Facets } from '../shape/shape.ts';
import type { FieldValue } from '../skeleton/skeleton.ts';
import { WITH_GRADIENT } from '../skeleton/work.ts';
import { clearAlong, rangeAlong } from './cubeSight.ts';
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
import type { Colour } from './node.ts';
import type { TreeField } from './treeField.ts';

/** `field` is the shape where it was put by `frame`, `facets` are those of the shape in its own frame. */
export function nearShape(
  field: TreeField,
  colour: Colour,
  facets: Facets | null,
  frame: LeafFrame | null,
  tally: Tally,
): Near {
  const sight = { ray: AHEAD, at: new Float64Array(3), first: 0 };
  const whole = { field, colour, facets, frame, tally, leaf: tally.leaf(), sight };
  return new NearShape(whole, -Infinity, Infinity);
}

interface Whole {
  readonly field: TreeField;
  readonly colour: Colour;
  readonly facets: Facets | null;
  readonly frame: LeafFrame | null;
  readonly tally: Tally;
  readonly leaf: number;
  /** the last look along a ray */
  readonly sight: { ray: Ray; readonly at: Float64Array; first: number };
}

const range = new Float64Array(2);
const AHEAD: Ray = [1, 0, 0];
/** of a distance: the cube around so much of a ray mostly holds no surface */
const NEARER = 0.7;
const SHORTEST = 0.1;

class NearShape implements Near {
  readonly low: number;
  readonly high: number;
  readonly error = 0;
  readonly asked = 1;
  readonly mostMissed = Infinity;
  readonly branches: number;
  readonly #whole: Whole;

  constructor(whole: Whole, low: number, high: number) {
    this.#whole = whole;
    this.branches = whole.facets?.count ?? 1;
    this.low = low;
    this.high = high;
  }

  get node(): number {
    return this.#whole.leaf;
  }

  errorAt(): number {
    return 0;
  }

  get plain(): Colour {
    return this.#whole.colour;
  }

  value(x: number, y: number, z: number): number {
    this.#whole.tally.work += 1;
    return this.#whole.field.value(x, y, z);
  }

  evaluate(x: number, y: number, z: number, out: FieldValue): void {
    this.#whole.tally.work += WITH_GRADIENT;
    this.#whole.field.evaluate(x, y, z, out);
  }

  colour(x: number, y: number, z: number, out: Float64Array): number {
    this.#whole.tally.work += 1;
    return this.#whole.field.colour(x, y, z, out);
  }

  branch(x: number, y: number, z: number): number {
    const { facets, frame, tally, leaf } = this.#whole;
    if (!facets) return branchOf(leaf);
    tally.work += 1;
    if (!frame) return branchOf(leaf, facets.nearest(x, y, z));
    frame.enter(x, y, z);
    return branchOf(leaf, facets.nearest(frame.x, frame.y, frame.z));
  }

  holds(branch: number): boolean {
    return isFaceOf(this.#whole.leaf, branch);
  }

  onBranch(branch: number, x: number, y: number, z: number, out: FieldValue): void {
    const { facets, frame, tally, leaf } = this.#whole;
    if (!facets) {
      this.evaluate(x, y, z, out);
      return;
    }
    tally.work += WITH_GRADIENT;
    if (!frame) {
      facets.evaluate(branch - branchOf(leaf), x, y, z, out);
      return;
    }
    frame.enter(x, y, z);
    facets.evaluate(branch - branchOf(leaf), frame.x, frame.y, frame.z, out);
    frame.leave(out);
  }

  within(x: number, y: number, z: number, half: number): Near {
    this.#whole.tally.work += WITH_GRADIENT;
    this.#whole.field.range(x, y, z, half, range);
    return new NearShape(this.#whole, range[0]!, range[1]!);
  }

  /** Distances tell how far it is at least; the first of two tries. */
  look(ray: Ray, x: number, y: number, z: number, reach: number): number {
    const { sight, frame } = this.#whole;
    const value = this.value(x, y, z);
    sight.ray = ray;
    sight.at.set([x, y, z]);
    sight.first = Math.min(reach, (NEARER * Math.abs(value)) / (frame?.scale ?? 1));
    return value;
  }

  clear(): number {
    const { at, ray, first } = this.#whole.sight;
    return clearAlong(this.#range, at, ray, first);
  }

  reached(): number {
    return Infinity;
  }

  /** The ball in the largest cube that is tried. */
  around(): number {
    const { at, first } = this.#whole.sight;
    for (let half = first; half > SHORTEST * first; half *= 0.5) {
      this.#range(at[0]!, at[1]!, at[2]!, half, range);
      if (range[0]! > 0 || range[1]! < 0) return half;
    }
    return 0;
  }

  ahead(t: number, out: Float64Array): void {
    const { at, ray } = this.#whole.sight;
    rangeAlong(this.#range, at, ray, t, out);
  }

  readonly #range = (x: number, y: number, z: number, half: number, out: Float64Array): void => {
    this.#whole.tally.work += 1;
    this.#whole.field.range(x, y, z, half, out);
  };

  corners(nodes: BrickCorners, out: Float64Array): number {
    return nodes.exact(this, out);
  }

  get steep(): number {
    return this.#whole.frame?.scale ?? 1;
  }

  effect(newer: Near, changes: Changes, x: number, y: number, z: number, half: number): number {
    return changes.has(this.#whole.leaf) ? rangesApart(this, newer.within(x, y, z, half, 0)) : 0;
  }

  eachLeaf(visit: (leaf: NearLeaf) => void): void {
    visit({ leaf: this.#whole.leaf, dropped: null, terms: null, far: null });
  }

  eachDropped(way: Way, visit: (leaf: NearLeaf) => void): void {
    visit({ leaf: this.#whole.leaf, dropped: way, terms: null, far: null });
  }
}
