/**
 * Weights with which the surface of a skeleton goes through its outline: bounded, damped least squares over places of the outline (Tai et al.
 * 2004, eq. 26, whose weights are one a segment, ≥ 0, and unfair).
 *
 * Unknowns are weights at nodes, shared by the segments that meet there, and of points (skelsOf.ts), each relative to what an infinite line
 * (a lone point) of that radius needs. A row is a place: by how many of its local radii the surface is off, to first order, so that limbs
 * count as much as bodies; slopes are taken anew as weights change. What makes neighbours uneven, and what leaves the rule, is damped.
 * Over nodes with neighbours the surface should be as high as their circles are wide (.26 % off the outline in the mean for .23 without).
 * Nodes may move a little too: the field of a bent line is stronger on its inner side, which no weight mends (a ring's mean error is
 * 1.7 % with weights alone).
 */
import type { Kernel, KernelParams } from '../../kernel/kernel.ts';
import {
  addEntries,
  addRow,
  boundedMinimum,
  emptyNormal,
  type Normal,
} from '../../math/boundedLeastSquares.ts';
import type { Vec2 } from '../../math/vec.ts';
import type { Skel } from '../skels.ts';
import { lineWeight, pointWeight } from '../weight.ts';
import type { MedialGraph } from './axis.ts';
import { neighboursOf } from './branches.ts';
import { type Basis, basisAt } from './fitBasis.ts';
import { type Layout, layoutOf, skelsWith } from './skelsOf.ts';

export interface FitOptions {
  /** of relative weights at nodes; those of points may be 0 */
  readonly low: number;
  readonly high: number;
  /** damps second differences along chains */
  readonly fairness: number;
  /** damps what leaves a relative weight of 1 */
  readonly pull: number;
  /** radii by which a node may move */
  readonly move: number;
  /** times that slopes are taken anew, with nodes where they are, and at most while they move */
  readonly rounds: number;
  readonly moves: number;
}

export const FITTING: FitOptions = {
  low: 0.05,
  high: 3,
  fairness: 0.05,
  pull: 0.01,
  move: 0.3,
  rounds: 1,
  moves: 5,
};

export interface Fitted {
  /** nodes as they were moved */
  readonly graph: MedialGraph;
  readonly skels: readonly Skel[];
  /** of nodes, then of points, against an infinite line or a lone point of that radius */
  readonly relative: readonly number[];
  /** root mean square by which the surface is off at the places, in local radii, to first order */
  readonly residual: number;
  /** mm by which it is off where it is most, to first order */
  readonly most: number;
  /** the same of all places but the worst `CORNERS` of them, which may be at corners that no smooth field has */
  readonly nearly: number;
  /** share of the weights at nodes that are at a bound, 0–1 */
  readonly atBound: number;
  /** largest quotient of relative weights of two nodes that are linked */
  readonly ratio: number;
}

/** nodes: more stay where they are, or steps would take seconds */
const MANY = 100;
/** of a point beside segments, where nothing says otherwise */
const POINT = 0.1;
/** slopes flatter than this many thresholds a radius are taken as this: where the field has its top, first order says nothing */
const FLAT = 0.5;
/** damping of moves, against that of weights */
const STAY = 4;
/** of a place as high over a node as its circle is wide, against one of the outline: without any, the middle of a star is .56 as thick */
const OVER = 0.7;
/** share of the places */
const CORNERS = 0.03;
/** rounds of a step: the next one goes on */
const TRIES = 6;
/** unknowns: of more than these, one round */
const LARGE = 120;
/** of a step that is tried: the first that helps */
const SHARES = [1, 0.5, 0.25];
/** share of the misfit: a step that gains less is the last */
const GAIN = 0.03;
/** share of a support that a weight is made for */
const WITHIN = 0.9;
/** mm: no circle is taken as smaller */
const LEAST = 1e-12;
/** radii of length, for kernels whose infinite lines have an infinite field */
const LINE = 6;

/** `places` are of the outline, mm; the skels lie in the plane z = 0. */
export function fitWeights(
  graph: MedialGraph,
  places: readonly Vec2[],
  kernel: Kernel,
  params: KernelParams,
  threshold: number,
  options: FitOptions = FITTING,
): Fitted {
  const fit = new Fit(graph, places, kernel, params, threshold, options);
  for (let round = 0; round < options.rounds; round++) fit.weigh();
  const moves = graph.nodes.length > MANY ? 0 : options.moves;
  for (let round = 0; round < moves && options.move > 0; round++) if (!fit.move()) break;
  return fit.result();
}

class Fit {
  readonly #graph: MedialGraph;
  readonly #near: readonly (readonly number[])[];
  readonly #places: Float64Array;
  /** the first of the places are of the outline; the others are over nodes */
  readonly #outline: number;
  readonly #kernel: Kernel;
  readonly #params: KernelParams;
  readonly #threshold: number;
  readonly #options: FitOptions;
  readonly #layout: Layout;
  readonly #scales: readonly number[];
  /** of each place: the radius there */
  readonly #radii: Float64Array;
  readonly #isBeside: readonly boolean[];
  #moved: MedialGraph;
  #x: readonly number[];
  /** in radii: x and y of each node in turn */
  #moves: readonly number[];
  #basis: Basis;
  /** of each place: by how much the field is above the threshold, and local radii a difference of the field */
  readonly #above: Float64Array;
  readonly #per: Float64Array;

  constructor(
    graph: MedialGraph,
    places: readonly Vec2[],
    kernel: Kernel,
    params: KernelParams,
    threshold: number,
    options: FitOptions,
  ) {
    this.#graph = graph;
    this.#near = neighboursOf(graph);
    this.#moved = graph;
    this.#kernel = kernel;
    this.#params = params;
    this.#threshold = threshold;
    this.#options = options;
    this.#layout = layoutOf(graph);
    const { nodes, isPoint } = this.#layout;
    this.#scales = nodes.map(({ radius }, i) => scaleOf(isPoint[i]!, kernel, params, radius, threshold));
    const over = graph.nodes.filter((_, i) => this.#near[i]!.length > 1);
    const above = over.map(({ at, radius }) => [...at, radius] as const);
    this.#outline = places.length;
    this.#places = Float64Array.from([...places.map(([x, y]) => [x, y, 0] as const), ...above].flat());
    this.#radii = Float64Array.from([
      ...places.map(([x, y]) => nearestRadius(graph, x, y)),
      ...over.map(({ radius }) => Math.max(radius, LEAST)),
    ]);
    const count = this.#radii.length;
    this.#above = new Float64Array(count);
    this.#per = new Float64Array(count);
    this.#isBeside = isPoint.map((is) => is && graph.links.length > 0);
    this.#x = this.#isBeside.map((is) => (is ? POINT : 1));
    this.#moves = graph.nodes.flatMap(() => [0, 0]);
    this.#basis = this.#look(null);
  }

  /** Gauss–Newton in weights. */
  weigh(): void {
    this.#x = this.#best([...this.#x], false);
    this.#measure();
  }

  /** The same in weights and places of nodes: as far as it helps, or else, when first order has gone too far, half or a quarter. */
  move(): boolean {
    if (!this.#basis.shifts) this.#look();
    const before = [...this.#x, ...this.#moves];
    const misfit = this.#misfit();
    const there = this.#best(before, true);
    for (const share of SHARES) {
      this.#go(there.map((value, i) => before[i]! + share * (value - before[i]!)));
      const now = this.#misfit();
      if (now < misfit) return now < (1 - GAIN) * misfit;
    }
    this.#go(before);
    return false;
  }

  #best(from: readonly number[], moves: boolean): readonly number[] {
    const { low, high, move } = this.#options;
    const shifts = moves ? this.#moves : [];
    const lows = [...this.#isBeside.map((is) => (is ? 0 : low)), ...shifts.map(() => -move)];
    const highs = [...this.#x.map(() => high), ...shifts.map(() => move)];
    return boundedMinimum(this.#normal(moves), lows, highs, from, from.length > LARGE ? 1 : TRIES).x;
  }

  #go(to: readonly number[]): void {
    this.#x = to.slice(0, this.#x.length);
    this.#moves = to.slice(this.#x.length);
    const nodes = this.#graph.nodes.map(({ at, radius }, i) => ({
      at: [at[0] + radius * this.#moves[2 * i]!, at[1] + radius * this.#moves[2 * i + 1]!] as const,
      radius,
    }));
    this.#moved = { nodes, links: this.#graph.links };
    this.#look();
  }

  /** Σ of squares, local radii. */
  #misfit(count = this.#above.length): number {
    let sum = 0;
    for (let at = 0; at < count; at++)
      sum += this.#above[at]! * this.#per[at]! * (this.#above[at]! * this.#per[at]!);
    return sum;
  }

  result(): Fitted {
    const { links, nodes } = this.#graph;
    const x = this.#x;
    const offs = this.#above
      .subarray(0, this.#outline)
      .map((above, at) => Math.abs(above * this.#per[at]!) * this.#radii[at]!)
      .sort();
    const { low, high } = this.#options;
    const ends = x.slice(0, nodes.length).filter((weight) => weight <= low || weight >= high);
    return {
      graph: this.#moved,
      skels: skelsWith(layoutOf(this.#moved), this.#scales, x),
      relative: x,
      residual: Math.sqrt(this.#misfit(this.#outline) / Math.max(this.#outline, 1)),
      most: offs.at(-1) ?? 0,
      nearly: offs[Math.floor((1 - CORNERS) * (offs.length - 1))] ?? 0,
      atBound: ends.length / Math.max(nodes.length, 1),
      ratio: links.reduce((most, [a, b]) => Math.max(most, ratioOf(x[a]!, x[b]!)), 1),
    };
  }

  #look(x: readonly number[] | null = this.#x): Basis {
    this.#basis = basisAt(
      this.#moved,
      this.#layout,
      this.#scales,
      this.#places,
      this.#kernel,
      this.#params,
      x,
    );
    this.#measure();
    return this.#basis;
  }

  #measure(): void {
    const { value, dx, dy, dz, unknowns } = this.#basis;
    for (let at = 0; at < this.#above.length; at++) {
      let [sum, sx, sy, sz] = [-this.#threshold, 0, 0, 0];
      for (let i = 0; i < unknowns; i++) {
        const k = at * unknowns + i;
        const weight = this.#x[i]!;
        sum += weight * value[k]!;
        sx += weight * dx[k]!;
        sy += weight * dy[k]!;
        sz += weight * dz[k]!;
      }
      const radius = this.#radii[at]!;
      const slope = Math.max(Math.sqrt(sx * sx + sy * sy + sz * sz), (FLAT * this.#threshold) / radius);
      this.#above[at] = sum;
      this.#per[at] = (at < this.#outline ? 1 : OVER) / (slope * radius);
    }
  }

  #normal(moves: boolean): Normal {
    const { value, shifts, unknowns } = this.#basis;
    const shifted = moves ? this.#moves.length : 0;
    const row = new Float64Array(unknowns + shifted);
    const normal = emptyNormal(row.length);
    for (const [at, per] of this.#per.entries()) {
      let right = this.#threshold * per;
      for (let i = 0; i < unknowns; i++) row[i] = value[at * unknowns + i]! * per;
      for (let i = 0; i < shifted; i++) {
        const gain = shifts![at * shifted + i]! * per;
        row[unknowns + i] = gain;
        right += gain * this.#moves[i]!;
      }
      addRow(normal, row, right);
    }
    this.#damp(normal, moves);
    return normal;
  }

  /** More places ask for as much more. */
  #damp(normal: Normal, moves: boolean): void {
    const { fairness, pull } = this.#options;
    const known = this.#x.length;
    const share = this.#outline / known;
    const add = (entries: readonly (readonly [number, number])[], right: number) =>
      addEntries(normal, entries, right, share);
    for (const [i, is] of this.#isBeside.entries()) add([[i, pull]], pull * (is ? POINT : 1));
    this.#near.forEach((others, node) => {
      const bends = (at: (node: number) => number, by: number) =>
        others.length === 2 &&
        add([[at(node), by], ...others.map((other) => [at(other), -0.5 * by] as const)], 0);
      bends((i) => i, fairness);
      if (!moves) return;
      for (const axis of [0, 1]) {
        bends((i) => known + 2 * i + axis, fairness * STAY);
        add([[known + 2 * node + axis, pull * STAY]], 0);
      }
    });
  }
}

const ratioOf = (a: number, b: number): number => (a === b ? 1 : Math.max(a / b, b / a));

/** Weight of an infinite line, or of a lone point; of kernels whose lines have no end, of one of this length. */
function scaleOf(
  isPoint: boolean,
  kernel: Kernel,
  params: KernelParams,
  radius: number,
  threshold: number,
): number {
  // what a support does not reach is not held, but no error either
  const within = kernel.support < Infinity ? WITHIN * kernel.support * kernel.unit(params, radius) : Infinity;
  const held = Math.min(Math.max(radius, LEAST), within);
  if (isPoint) return pointWeight(kernel, params, held, threshold);
  return lineWeight(kernel, params, held, threshold, kernel.wholeLine ? Infinity : LINE * held);
}

function nearestRadius({ nodes }: MedialGraph, x: number, y: number): number {
  let least = Infinity;
  let found = 1;
  for (const { at, radius } of nodes) {
    const held = Math.max(radius, LEAST);
    const gap = ((x - at[0]) * (x - at[0]) + (y - at[1]) * (y - at[1])) / (held * held);
    if (gap < least) [least, found] = [gap, held];
  }
  return found;
}
