/**
 * Takes the branches off a medial axis that tell of the pen's tremble and not of a form.
 *
 * A branch may go where the circles that stay still reach the outline to within a share of their radius: the error of the whole, against the
 * outline itself, is bounded, whatever was taken before. Branches go in the order of that error; then ends are shortened by the same
 * measure. Tai et al. 2004 decide circle by circle with the last one kept, along the triangles (prunePaper.ts), which a jittered outline
 * upsets; the figures of both are in docs/silhouettes.md.
 */
import type { MedialGraph } from './axis.ts';
import { neighboursOf, subgraph } from './branches.ts';
import { along, type Loop, roundOf, spaced } from './outline.ts';

export interface PruneOptions {
  /** share of a radius by which the circles may stay away from the outline where a branch was, 0–1 */
  readonly branch: number;
  /** the same at the ends of limbs */
  readonly end: number;
}

export const PRUNING: PruneOptions = { branch: 0.2, end: 0.05 };

/** of the widest circle of an end: narrower ones before it are a spur */
const SHRUNK = 0.9;
/** places of the outline that are looked at */
const PLACES = 260;
/** mm², so that a circle without a radius has a finite reciprocal */
const TINY = 1e-300;

/** What is left is of one piece where the graph was; never empty unless the graph is. */
export function prune(
  graph: MedialGraph,
  loops: readonly Loop[],
  options: PruneOptions = PRUNING,
): MedialGraph {
  return prunings(graph, loops, [options.branch], options.end)[0]!();
}

/** One for each share in `branches`, which come coarsest first. A finer one is met on the way to a coarser: all cost as much as one. */
export function prunings(
  graph: MedialGraph,
  loops: readonly Loop[],
  branches: readonly number[],
  end = PRUNING.end,
): readonly (() => MedialGraph)[] {
  const trimmer = Trimmer.of(graph, loops);
  const finestFirst = [...branches].reverse().map((branch) => {
    trimmer.branches(branch);
    const own = trimmer.copy();
    return () => {
      own.ends(end, branch);
      return subgraph(graph, (node) => own.isKept(node));
    };
  });
  return finestFirst.reverse();
}

/** What changes as branches go. */
interface State {
  readonly near: readonly Set<number>[];
  /** the circles that are left come first, in no order; where each is among them */
  readonly order: Int32Array;
  readonly where: Int32Array;
  readonly count: number;
  /** of each place: the circle that reaches it best */
  readonly best: Int32Array;
}

class Trimmer {
  readonly #near: readonly Set<number>[];
  readonly #order: Int32Array;
  readonly #where: Int32Array;
  #count: number;
  readonly #best: Int32Array;
  /** x, y, 1/radius² of each */
  readonly #circles: Float64Array;
  /** x, y of each */
  readonly #places: Float64Array;

  static of(graph: MedialGraph, loops: readonly Loop[]): Trimmer {
    const circles = graph.nodes.flatMap(({ at, radius }) => [...at, 1 / Math.max(radius * radius, TINY)]);
    const places = Float64Array.from(placesOf(loops).flat(2));
    const order = Int32Array.from(graph.nodes.keys());
    const state: State = {
      near: neighboursOf(graph).map((others) => new Set(others)),
      order,
      where: order.slice(),
      count: order.length,
      best: new Int32Array(places.length / 2),
    };
    const trimmer = new Trimmer(state, Float64Array.from(circles), places);
    for (const place of state.best.keys()) trimmer.#best[place] = trimmer.#reach(place);
    return trimmer;
  }

  private constructor(state: State, circles: Float64Array, places: Float64Array) {
    this.#near = state.near.map((others) => new Set(others));
    this.#order = state.order.slice();
    this.#where = state.where.slice();
    this.#count = state.count;
    this.#best = state.best.slice();
    this.#circles = circles;
    this.#places = places;
  }

  copy(): Trimmer {
    const state = { near: this.#near, order: this.#order, where: this.#where, count: this.#count };
    return new Trimmer({ ...state, best: this.#best }, this.#circles, this.#places);
  }

  isKept(node: number): boolean {
    return this.#where[node]! < this.#count;
  }

  /** What stays away from the outline only grows as circles go: an old error is a lower bound, and few are found anew. */
  branches(most: number): void {
    const known = new Map(this.#tips().map((tip) => [tip, 0]));
    for (;;) {
      let tip = -1;
      let least = Infinity;
      for (const [leaf, error] of known) if (error < least) [tip, least] = [leaf, error];
      if (tip < 0 || least > most) return;
      const branch = this.#branch(tip);
      const error = branch.length > 0 ? this.#without(branch) : Infinity;
      if (error > least) {
        known.set(tip, error);
        continue;
      }
      this.#drop(branch);
      known.delete(tip);
    }
  }

  /**
   * Shortens limbs: by what hardly shows, and by spurs, whose circles shrink towards one bump of a round end (`spur` is the share by
   * which the outline may be missed there).
   */
  ends(most: number, spur: number): void {
    for (const tip of this.#tips()) {
      if (!this.isKept(tip)) continue;
      const row = this.#row(tip);
      const errors = this.#withoutFirst(row);
      const far = errors.findIndex((error) => error > spur);
      const end = row.slice(0, far < 0 ? row.length : far + 1);
      // 1/radius²
      const sharpest = end.reduce((least, node) => Math.min(least, this.#circles[3 * node + 2]!), Infinity);
      let count = end.findIndex((node) => SHRUNK * SHRUNK * this.#circles[3 * node + 2]! <= sharpest);
      while (count < end.length - 1 && errors[count]! <= most) count++;
      this.#drop(end.slice(0, Math.max(count, 0)));
    }
  }

  #tips(): number[] {
    return [...this.#near.keys()].filter((node) => this.isKept(node) && this.#near[node]!.size === 1);
  }

  /** From an end to before the joint it hangs on, or to the other end. */
  #row(tip: number): number[] {
    const row = [tip];
    for (let at = tip, before = -1; ; ) {
      let next = -1;
      for (const other of this.#near[at]!) if (other !== before) next = other;
      if (next < 0 || this.#near[next]!.size > 2) return row;
      row.push(next);
      [before, at] = [at, next];
    }
  }

  /** None where there is no joint. */
  #branch(tip: number): number[] {
    const row = this.#row(tip);
    const isWhole = row.length > 1 && this.#near[row.at(-1)!]!.size === 1;
    return isWhole || this.#near[tip]!.size !== 1 ? [] : row;
  }

  #drop(branch: readonly number[]): void {
    this.#hide(branch);
    for (const node of branch) for (const other of this.#near[node]!) this.#near[other]!.delete(node);
    for (let place = 0; place < this.#best.length; place++) {
      if (!this.isKept(this.#best[place]!)) this.#best[place] = this.#reach(place);
    }
  }

  /** Behind those that are left; `#count` put back shows them again. */
  #hide(nodes: readonly number[]): void {
    for (const node of nodes) {
      const at = this.#where[node]!;
      const last = this.#order[--this.#count]!;
      this.#order[at] = last;
      this.#where[last] = at;
      this.#order[this.#count] = node;
      this.#where[node] = this.#count;
    }
  }

  /** The largest share of its radius by which a circle stays away from a place that one of these reached. */
  #without(branch: readonly number[]): number {
    const before = this.#count;
    this.#hide(branch);
    let worst = 1;
    for (let place = 0; place < this.#best.length; place++) {
      const best = this.#best[place]!;
      if (this.#where[best]! < this.#count || this.#where[best]! >= before) continue;
      const other = this.#reach(place);
      worst = Math.max(worst, other < 0 ? Infinity : this.#gap2(place, other));
    }
    this.#count = before;
    return Math.sqrt(worst) - 1;
  }

  /** The same without the first, the first two, … of a row. */
  #withoutFirst(row: readonly number[]): readonly number[] {
    const before = this.#count;
    const rank = new Map(row.map((node, i) => [node, i]));
    const worst = row.map(() => 1);
    this.#hide(row);
    for (let place = 0; place < this.#best.length; place++) {
      const own = rank.get(this.#best[place]!);
      if (own === undefined) continue;
      const other = this.#reach(place);
      let least = other < 0 ? Infinity : this.#gap2(place, other);
      for (let i = row.length - 1; i >= own; i--) {
        worst[i] = Math.max(worst[i]!, least);
        least = Math.min(least, this.#gap2(place, row[i]!));
      }
    }
    this.#count = before;
    return worst.map((gap2) => Math.sqrt(gap2) - 1);
  }

  /** Squared distance from the middle of the circle, in its squared radius. */
  #gap2(place: number, node: number): number {
    const dx = this.#places[2 * place]! - this.#circles[3 * node]!;
    const dy = this.#places[2 * place + 1]! - this.#circles[3 * node + 1]!;
    return (dx * dx + dy * dy) * this.#circles[3 * node + 2]!;
  }

  /** The circle that is left whose `#gap2` is least; −1 where none is. */
  #reach(place: number): number {
    const circles = this.#circles;
    const order = this.#order;
    const x = this.#places[2 * place]!;
    const y = this.#places[2 * place + 1]!;
    let best = -1;
    let least = Infinity;
    for (let i = 0; i < this.#count; i++) {
      const at = 3 * order[i]!;
      const dx = x - circles[at]!;
      const dy = y - circles[at + 1]!;
      const gap = (dx * dx + dy * dy) * circles[at + 2]!;
      if (gap < least) {
        best = order[i]!;
        least = gap;
      }
    }
    return best;
  }
}

/** With corners, unless there are too many. */
function placesOf(loops: readonly Loop[]): readonly Loop[] {
  const isFine = loops.reduce((sum, loop) => sum + loop.length, 0) > 2 * PLACES;
  return isFine ? spaced(loops, PLACES) : [along(loops, roundOf(loops) / PLACES)];
}
