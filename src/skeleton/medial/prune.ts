/**
 * Takes the branches off a medial axis that tell of the pen's tremble and not of a form.
 *
 * A branch may go where the circles that stay still reach the outline to within a share of their radius: the error of the whole, against the
 * outline itself, is bounded, whatever was taken before. Branches go in the order of that error; then ends are shortened by the same
 * measure. Tai et al. 2004 decide circle by circle with the last one kept, along the triangles (prunePaper.ts), which a jittered outline
 * upsets; the figures of both are in docs/silhouettes.md.
 */
import { length2, sub2 } from '../../math/tuple.ts';
import type { Vec2 } from '../../math/vec.ts';
import type { MedialGraph } from './axis.ts';
import { neighboursOf, subgraph } from './branches.ts';
import { along, type Loop } from './outline.ts';

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
const PLACES = 400;

/** What is left is of one piece where the graph was; never empty unless the graph is. */
export function prune(
  graph: MedialGraph,
  loops: readonly Loop[],
  options: PruneOptions = PRUNING,
): MedialGraph {
  const trimmer = new Trimmer(graph, loops);
  trimmer.branches(options.branch);
  trimmer.ends(options.end, options.branch);
  return subgraph(graph, (node) => trimmer.isKept(node));
}

class Trimmer {
  readonly #near: Set<number>[];
  readonly #kept: boolean[];
  /** x, y, radius of each */
  readonly #circles: Float64Array;
  readonly #places: readonly Vec2[];
  /** of each place: the circle that reaches it best */
  readonly #best: Int32Array;

  constructor(graph: MedialGraph, loops: readonly Loop[]) {
    this.#circles = Float64Array.from(graph.nodes.flatMap(({ at, radius }) => [...at, radius]));
    this.#near = neighboursOf(graph).map((others) => new Set(others));
    this.#kept = graph.nodes.map(() => true);
    const round = loops.flatMap((loop) => loop.map((p, i) => length2(sub2(p, loop.at(i - 1)!))));
    this.#places = along(loops, round.reduce((a, b) => a + b, 0) / PLACES);
    this.#best = Int32Array.from(this.#places, (_, place) => this.#reach(place, () => true));
  }

  isKept(node: number): boolean {
    return this.#kept[node]!;
  }

  /** What stays away from the outline only grows as circles go: an old error is a lower bound, and few are found anew. */
  branches(most: number): void {
    const known = new Map(this.#tips().map((tip) => [tip, 0]));
    for (;;) {
      const [tip] = [...known].reduce((best, leaf) => (leaf[1] < best[1] ? leaf : best), [-1, Infinity]);
      if (tip < 0 || known.get(tip)! > most) return;
      const branch = this.#branch(tip);
      const error = branch.length > 0 ? this.#without(branch) : Infinity;
      if (error > known.get(tip)!) {
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
      const end = this.#end(tip, spur);
      const widest = end.reduce((radius, node) => Math.max(radius, this.#radius(node)), 0);
      let count = end.findIndex((node) => this.#radius(node) >= SHRUNK * widest);
      while (count < end.length - 1 && this.#without(end.slice(0, count + 1)) <= most) count++;
      this.#drop(end.slice(0, Math.max(count, 0)));
    }
  }

  /** From a tip inwards, all that may go with less than this error, and the node after it, as long as they are in one row. */
  #end(tip: number, most: number): readonly number[] {
    const end = [tip];
    while (this.#without(end) <= most) {
      const next = [...this.#near[end.at(-1)!]!].find((other) => other !== end.at(-2));
      if (next === undefined || this.#near[next]!.size > 2) break;
      end.push(next);
      if (this.#near[next]!.size === 1) break;
    }
    return end;
  }

  #radius(node: number): number {
    return this.#circles[3 * node + 2]!;
  }

  #tips(): number[] {
    return this.#kept.flatMap((kept, node) => (kept && this.#near[node]!.size === 1 ? [node] : []));
  }

  /** From an end to before the joint it hangs on; none where there is no joint. */
  #branch(tip: number): number[] {
    const branch = [tip];
    for (let at = tip; ; ) {
      const next = [...this.#near[at]!].find((other) => other !== branch.at(-2));
      if (next === undefined) return [];
      if (this.#near[next]!.size > 2) return branch;
      branch.push(next);
      at = next;
    }
  }

  #drop(branch: readonly number[]): void {
    for (const node of branch) {
      this.#kept[node] = false;
      for (const other of this.#near[node]!) this.#near[other]!.delete(node);
    }
    const gone = new Set(branch);
    this.#best.forEach((node, place) => {
      if (gone.has(node)) this.#best[place] = this.#reach(place, () => true);
    });
  }

  /** The largest share of its radius by which a circle stays away from a place that one of these reached. */
  #without(branch: readonly number[]): number {
    const gone = new Set(branch);
    let worst = 0;
    this.#best.forEach((node, place) => {
      if (!gone.has(node)) return;
      const other = this.#reach(place, (at) => !gone.has(at));
      worst = Math.max(worst, other < 0 ? Infinity : this.#gap(place, other));
    });
    return worst;
  }

  /** In radii of the circle. */
  #gap(place: number, node: number): number {
    const [x, y] = this.#places[place]!;
    const [dx, dy] = [x - this.#circles[3 * node]!, y - this.#circles[3 * node + 1]!];
    return Math.sqrt(dx * dx + dy * dy) / this.#circles[3 * node + 2]! - 1;
  }

  #reach(place: number, isThere: (node: number) => boolean): number {
    let best = -1;
    let least = Infinity;
    for (let node = 0; node < this.#kept.length; node++) {
      if (!this.#kept[node] || !isThere(node)) continue;
      const gap = this.#gap(place, node);
      if (gap < least) {
        best = node;
        least = gap;
      }
    }
    return best;
  }
}
