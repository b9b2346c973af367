/**
 * The 27 nodes and 125 corners of one brick, for the leaves of its tree: sums are evaluated at nodes, each once, whichever brick
 * comes first, and interpolated; shapes are evaluated at the corners that no brick before has.
 */
import { Slab } from '../math/slab.ts';
import type { Vec3 } from '../math/vec.ts';
import { FLOPS } from '../skeleton/work.ts';
import {
  CORNERS,
  INTERPOLATION_FLOPS,
  interpolate,
  interpolationError,
  NODES,
  SIDE,
  STRIDE,
} from './hermite.ts';
import type { Lattice } from './lattice.ts';
import type { BrickCorners, Near, Tally } from './near.ts';

/** Of the 27 bricks around one: those before it. */
export const BEFORE = 13;

/** Value and gradient at nodes, by leaf. */
export type LeafNodes = Map<number, Float64Array>;

/** A node or corner in common with a brick before: which, and its number there; ascending. */
interface Common {
  readonly brick: number;
  readonly at: number;
}

/** For each of `side`³ places of a brick those of the bricks before it that are the same. */
export function inCommon(side: number): readonly (readonly Common[])[] {
  const last = side - 1;
  const ways = (at: number) => (at === 0 ? [-1, 0] : at === last ? [0, 1] : [0]);
  return Array.from({ length: side * side * side }, (_, place) => {
    const at = [place % side, Math.floor(place / side) % side, Math.floor(place / (side * side))] as const;
    const common = ways(at[2]).flatMap((dk) =>
      ways(at[1]).flatMap((dj) =>
        ways(at[0]).map((di) => ({
          brick: di + 1 + 3 * (dj + 1 + 3 * (dk + 1)),
          at: at[0] - last * di + side * (at[1] - last * dj + side * (at[2] - last * dk)),
        })),
      ),
    );
    return common.filter(({ brick }) => brick < BEFORE);
  });
}

/** For each brick before one the places they have in common: its own and theirs in turn. */
export const pairsOf = (common: readonly (readonly Common[])[]): readonly Uint8Array[] =>
  Array.from({ length: BEFORE }, (_, n) =>
    Uint8Array.from(
      common.flatMap((all, place) => all.filter(({ brick }) => brick === n).flatMap(({ at }) => [place, at])),
    ),
  );

const SAME_NODES = pairsOf(inCommon(3));

/** Corners of a cube of two cells. */
const HALF = Array.from(
  { length: 27 },
  (_, n) => (n % 3) + SIDE * ((Math.floor(n / 3) % 3) + SIDE * Math.floor(n / 9)),
);

/** Surely on its side of 0. */
const away = (value: number, slack: number): number =>
  value > 0 ? Math.max(value, 2 * slack + LEAST) : Math.min(value, -2 * slack - LEAST);
/** of a value of which only the sign is known */
export const LEAST = 1e-30;

export class BrickNodes implements BrickCorners {
  readonly #lattice: Lattice;
  readonly #tally: Tally;
  readonly #node = new Float64Array(STRIDE);
  #x = 0;
  #y = 0;
  #z = 0;
  #own: LeafNodes = new Map();
  #before: readonly (LeafNodes | null)[] = [];
  readonly #slab = new Slab();
  /** nodes that bricks before have */
  readonly #has = new Uint8Array(NODES);
  readonly #rough = new Float64Array(CORNERS);
  readonly #done = new Uint8Array(CORNERS);
  roughly = true;
  /** corners that no brick before has */
  readonly wanted = new Uint8Array(CORNERS);

  constructor(lattice: Lattice, tally: Tally) {
    this.#lattice = lattice;
    this.#tally = tally;
  }

  /** Goes to the brick whose first corner is node (x, y, z) of the lattice; `before`: what the 13 bricks before it have. */
  enter(x: number, y: number, z: number, own: LeafNodes, before: readonly (LeafNodes | null)[]): void {
    this.#x = x;
    this.#y = y;
    this.#z = z;
    this.#own = own;
    this.#before = before;
  }

  get apart(): number {
    return 2 * this.#lattice.step;
  }

  interpolated(near: Near, leaf: number, out: Float64Array): number {
    const nodes = this.#slab.take(STRIDE * NODES);
    this.#take(nodes, leaf);
    for (let n = 0; n < NODES; n++) if (this.#has[n] === 0) this.#fill(nodes, n, near);
    this.#own.set(leaf, nodes);
    const { step } = this.#lattice;
    interpolate(nodes, step, out);
    this.#tally.work += INTERPOLATION_FLOPS / FLOPS;
    return interpolationError(nodes, step);
  }

  exact(near: Near, out: Float64Array): number {
    for (let c = 0; c < CORNERS; c++) if (this.wanted[c] === 1) out[c] = this.value(near, c);
    return 0;
  }

  halved(near: Near, missed: number, out: Float64Array): number {
    const { origin, step } = this.#lattice;
    const rough = this.#rough;
    const done = this.#done.fill(0);
    let slack = 0;
    for (let half = 0; half < 8; half++) {
      const [i, j, k] = [2 * (half & 1), half & 2, (half >> 1) & 2];
      const x = origin[0] + (this.#x + i + 1) * step;
      const y = origin[1] + (this.#y + j + 1) * step;
      const z = origin[2] + (this.#z + k + 1) * step;
      const within = near.within(x, y, z, step * (1 + 1e-12), missed);
      const isActive = within.low <= 0 && within.high > 0;
      if (isActive) slack = Math.max(slack, within.error);
      for (const corner of HALF) {
        const c = corner + i + SIDE * (j + SIDE * k);
        if (this.wanted[c] === 0 || done[c] === 1) continue;
        rough[c] = 0.5 * (within.low + within.high);
        if (!isActive) continue;
        out[c] = this.value(within, c);
        done[c] = 1;
      }
    }
    for (let c = 0; c < CORNERS; c++) if (done[c] === 0) out[c] = away(rough[c]!, slack);
    return slack;
  }

  /** At a corner. */
  value(near: Near, c: number): number {
    return near.value(...this.#at(c));
  }

  /** By how much that may be off. */
  error(near: Near, c: number): number {
    return near.errorAt(...this.#at(c));
  }

  #at(c: number): Vec3 {
    const { origin, step } = this.#lattice;
    return [
      origin[0] + (this.#x + (c % SIDE)) * step,
      origin[1] + (this.#y + (Math.floor(c / SIDE) % SIDE)) * step,
      origin[2] + (this.#z + Math.floor(c / (SIDE * SIDE))) * step,
    ];
  }

  /** What bricks before have. */
  #take(nodes: Float64Array, leaf: number): void {
    this.#has.fill(0);
    for (let brick = 0; brick < BEFORE; brick++) {
      const known = this.#before[brick]?.get(leaf);
      if (!known) continue;
      const pairs = SAME_NODES[brick]!;
      for (let p = 0; p < pairs.length; p += 2) {
        const n = pairs[p]!;
        for (let i = 0; i < STRIDE; i++) nodes[STRIDE * n + i] = known[STRIDE * pairs[p + 1]! + i]!;
        this.#has[n] = 1;
      }
    }
  }

  #fill(nodes: Float64Array, n: number, near: Near): void {
    const { origin, step } = this.#lattice;
    const node = this.#node;
    near.evaluate(
      origin[0] + (this.#x + 2 * (n % 3)) * step,
      origin[1] + (this.#y + 2 * (Math.floor(n / 3) % 3)) * step,
      origin[2] + (this.#z + 2 * Math.floor(n / 9)) * step,
      node,
    );
    for (let i = 0; i < STRIDE; i++) nodes[STRIDE * n + i] = node[i]!;
  }
}
