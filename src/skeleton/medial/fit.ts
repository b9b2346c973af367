/**
 * Weights with which the surface of a skeleton goes through its outline: bounded, damped least squares over places of the outline (Tai et al.
 * 2004, eq. 26, whose weights are one a segment, ≥ 0, and unfair).
 *
 * Unknowns are weights at nodes, shared by the segments that meet there, and of points (skelsOf.ts), each relative to what an infinite line
 * (a lone point) of that radius needs. A row is a place: by how many of its local radii the surface is off, to first order, so that limbs
 * count as much as bodies; slopes are taken anew as weights change. What makes neighbours uneven, and what leaves the rule, is damped.
 * Nodes may move a little too: the field of a bent line is stronger on its inner side, which no weight mends (a ring's mean error is
 * 1.7 % with weights alone).
 */
import type { Kernel, KernelParams } from '../../kernel/kernel.ts';
import { boundedLeastSquares } from '../../math/boundedLeastSquares.ts';
import type { Vec2 } from '../../math/vec.ts';
import type { Skel } from '../skels.ts';
import { lineWeight, pointWeight } from '../weight.ts';
import type { MedialGraph } from './axis.ts';
import { neighboursOf } from './branches.ts';
import { type Basis, basisAt, fieldOf, shiftsAt } from './fitBasis.ts';
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
}

export const FITTING: FitOptions = { low: 0.05, high: 3, fairness: 0.1, pull: 0.01, move: 0.3 };

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
  /** share of the weights at nodes that are at a bound, 0–1 */
  readonly atBound: number;
  /** largest quotient of relative weights of two nodes that are linked */
  readonly ratio: number;
}

/** times that slopes are taken anew, with nodes where they are, and while they move */
const ROUNDS = 3;
const MOVES = 4;
/** of a point beside segments, where nothing says otherwise */
const POINT = 0.1;
/** slopes flatter than this many thresholds a radius are taken as this: where the field has its top, first order says nothing */
const FLAT = 0.5;
/** damping of moves, against that of weights */
const STAY = 4;

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
  for (let round = 0; round < ROUNDS; round++) fit.step(false);
  let best = fit.result();
  for (let round = 0; round < MOVES && options.move > 0; round++) {
    fit.step(true);
    const next = fit.result();
    // first order has gone too far
    if (!(next.residual < best.residual)) break;
    best = next;
  }
  return best;
}

class Fit {
  readonly #graph: MedialGraph;
  readonly #places: readonly Vec2[];
  readonly #kernel: Kernel;
  readonly #params: KernelParams;
  readonly #threshold: number;
  readonly #options: FitOptions;
  readonly #layout: Layout;
  readonly #scales: readonly number[];
  readonly #radii: readonly number[];
  readonly #isBeside: readonly boolean[];
  #moved: MedialGraph;
  #x: readonly number[];
  /** in radii: x and y of each node in turn */
  #moves: readonly number[];
  #basis: Basis;

  constructor(
    graph: MedialGraph,
    places: readonly Vec2[],
    kernel: Kernel,
    params: KernelParams,
    threshold: number,
    options: FitOptions,
  ) {
    this.#graph = graph;
    this.#moved = graph;
    this.#places = places;
    this.#kernel = kernel;
    this.#params = params;
    this.#threshold = threshold;
    this.#options = options;
    this.#layout = layoutOf(graph);
    const { nodes, isPoint } = this.#layout;
    this.#scales = nodes.map(({ radius }, i) =>
      (isPoint[i] ? pointWeight : lineWeight)(kernel, params, radius, threshold),
    );
    this.#radii = places.map((p) => nearestRadius(graph, p));
    this.#isBeside = isPoint.map((is) => is && graph.links.length > 0);
    this.#x = this.#isBeside.map((is) => (is ? POINT : 1));
    this.#moves = graph.nodes.flatMap(() => [0, 0]);
    this.#basis = this.#basisNow();
  }

  /** Gauss–Newton, in weights and, when `moves`, in places of nodes. */
  step(moves: boolean): void {
    const { low, high, move } = this.#options;
    const { rows, y } = this.#rows(moves);
    const damped = this.#damping(moves);
    const shifts = moves ? this.#moves : [];
    const bounds = {
      low: [...this.#isBeside.map((is) => (is ? 0 : low)), ...shifts.map(() => -move)],
      high: [...this.#x.map(() => high), ...shifts.map(() => move)],
    };
    const all = [...rows, ...damped.rows];
    const { x } = boundedLeastSquares(all, [...y, ...damped.y], bounds.low, bounds.high, [
      ...this.#x,
      ...shifts,
    ]);
    this.#x = x.slice(0, this.#x.length);
    if (!moves) return;
    this.#moves = x.slice(this.#x.length);
    const nodes = this.#graph.nodes.map(({ at, radius }, i) => ({
      at: [at[0] + radius * this.#moves[2 * i]!, at[1] + radius * this.#moves[2 * i + 1]!] as const,
      radius,
    }));
    this.#moved = { nodes, links: this.#graph.links };
    this.#basis = this.#basisNow();
  }

  result(): Fitted {
    const { links, nodes } = this.#graph;
    const x = this.#x;
    const offs = this.#basis.map((row, at) =>
      Math.abs((fieldOf(row, x).value - this.#threshold) * this.#per(row, at)),
    );
    const most = offs.reduce((worst, off, at) => Math.max(worst, off * this.#radii[at]!), 0);
    const { low, high } = this.#options;
    const ends = x.slice(0, nodes.length).filter((weight) => weight <= low || weight >= high);
    return {
      graph: this.#moved,
      skels: skelsWith(layoutOf(this.#moved), this.#scales, x),
      relative: x,
      residual: Math.sqrt(offs.reduce((sum, off) => sum + off * off, 0) / Math.max(offs.length, 1)),
      most,
      atBound: ends.length / Math.max(nodes.length, 1),
      ratio: links.reduce((most, [a, b]) => Math.max(most, x[a]! / x[b]!, x[b]! / x[a]!), 1),
    };
  }

  #basisNow(): Basis {
    return basisAt(layoutOf(this.#moved), this.#scales, this.#places, this.#kernel, this.#params);
  }

  /** local radii a difference of the field, at a place */
  #per(row: Float64Array, at: number): number {
    const radius = this.#radii[at]!;
    return 1 / (Math.max(fieldOf(row, this.#x).slope, (FLAT * this.#threshold) / radius) * radius);
  }

  #rows(moves: boolean) {
    const known = this.#x.length;
    const shifts = moves
      ? shiftsAt(this.#moved, this.#scales, this.#x, this.#places, this.#kernel, this.#params)
      : null;
    const y: number[] = [];
    const rows = this.#basis.map((row, at) => {
      const per = this.#per(row, at);
      const out = new Float64Array(known + (moves ? this.#moves.length : 0));
      for (let i = 0; i < known; i++) out[i] = row[3 * i]! * per;
      let right = this.#threshold * per;
      const gains = shifts ? shifts[at]! : [];
      for (const [i, gain] of gains.entries()) {
        out[known + i] = gain * per;
        right += gain * per * this.#moves[i]!;
      }
      y.push(right);
      return out;
    });
    return { rows, y };
  }

  /** More places ask for as much more. */
  #damping(moves: boolean) {
    const { fairness, pull } = this.#options;
    const { nodes } = this.#graph;
    const known = this.#x.length;
    const size = known + (moves ? 2 * nodes.length : 0);
    const share = Math.sqrt(this.#places.length / known);
    const rows: Float64Array[] = [];
    const y: number[] = [];
    const add = (entries: readonly (readonly [number, number])[], right: number) => {
      const row = new Float64Array(size);
      for (const [i, value] of entries) row[i] = value * share;
      rows.push(row);
      y.push(right * share);
    };
    for (const [i, is] of this.#isBeside.entries()) add([[i, pull]], pull * (is ? POINT : 1));
    neighboursOf(this.#graph).forEach((others, node) => {
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
    return { rows, y };
  }
}

function nearestRadius({ nodes }: MedialGraph, [x, y]: Vec2): number {
  let least = Infinity;
  let found = 1;
  for (const { at, radius } of nodes) {
    const gap = Math.sqrt((x - at[0]) * (x - at[0]) + (y - at[1]) * (y - at[1])) / radius;
    if (gap < least) [least, found] = [gap, radius];
  }
  return found;
}
