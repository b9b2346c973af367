/**
 * The values at all corners of active bricks, one brick after the other. Each corner has one owner, the brick of the lowest number that
 * holds it, so that neighbours, whose lists differ, agree; the mesh is closed whatever they say.
 *
 * Interpolated values that might have the wrong sign are evaluated by the brick's list, what that might miss by all skels. How far
 * interpolation is off is an estimate (hermite.ts; none of 200,000 signs was wrong in the tests), and where a culled brick, whose sign
 * is proven, says otherwise, it is believed.
 */

import { Slab } from '../math/slab.ts';
import { BEFORE, BrickNodes, inCommon, LEAST, type LeafNodes, pairsOf } from './brickNodes.ts';
import { around, type Brick, type Bricks, INSIDE, OUTSIDE } from './bricks.ts';
import { CORNERS, SIDE } from './hermite.ts';
import { BRICK, type Lattice, nodesBefore } from './lattice.ts';
import type { Near, Tally } from './near.ts';

/** In place of what is inside at the lattice's border: outside, for nothing is known beyond. */
export const CUT = -1e300;
/** of the 27 around a brick, itself */
const MIDDLE = 13;

const SAME_CORNERS = inCommon(SIDE);
const PAIRS = pairsOf(SAME_CORNERS);

/** By the brick around, of 27, the corners that it has too. */
const TOUCHING = Array.from({ length: 27 }, (_, n) => {
  const ways = [(n % 3) - 1, (Math.floor(n / 3) % 3) - 1, Math.floor(n / 9) - 1];
  return Array.from({ length: CORNERS }, (__, c) => c).filter((c) => {
    const at = [c % SIDE, Math.floor(c / SIDE) % SIDE, Math.floor(c / (SIDE * SIDE))];
    return ways.every((way, axis) => way === 0 || at[axis] === (way < 0 ? 0 : BRICK));
  });
});

/** What is known of a brick. */
interface Filled {
  readonly values: Float64Array;
  nodes: LeafNodes | null;
}

const FORGOTTEN: Filled = { values: new Float64Array(0), nodes: null };

/** Values from before an edit, and which bricks they still hold for. */
export interface Before {
  readonly values: BrickValues;
  /** of brick `place` its place then; −1 where it was made anew or was not there */
  placeOf(place: number): number;
}

export class BrickValues {
  /** the field by all skels */
  readonly whole: Near;
  readonly #bricks: Bricks;
  readonly #nodes: BrickNodes;
  readonly #filled: Filled[] = [];
  readonly #around = new Int32Array(27);
  readonly #exact = new Map<number, number>();
  /** bricks before it were forgotten */
  #forgotten = 0;
  /** whether the field is inside at each side of the lattice: −x, x, −y, y, −z, z */
  readonly exits = [false, false, false, false, false, false];
  readonly #slab = new Slab();
  /** of the brick at hand, and of those before it around */
  readonly #mine = new Float64Array(CORNERS);
  readonly #nodesBefore: (LeafNodes | null)[] = Array.from({ length: BEFORE }, () => null);
  #before: Before | null;
  readonly #hasGrown: boolean;
  readonly isLive: boolean;

  /** `before`: what may be taken over. `isLive`: nodes are kept for the next edit. */
  constructor(
    whole: Near,
    bricks: Bricks,
    tally: Tally,
    before: Before | null = null,
    isLive = before !== null,
  ) {
    this.#before = before;
    this.isLive = isLive;
    this.#hasGrown = before !== null && before.values.#bricks.lattice !== bricks.lattice;
    this.whole = whole;
    this.#bricks = bricks;
    this.#nodes = new BrickNodes(bricks.lattice, tally);
  }

  /** Of brick `place` in `active`, 125 values; bricks come in order. */
  fill(place: number): Float64Array {
    const brick = this.#bricks.active[place]!;
    const values = this.#slab.take(CORNERS);
    const own: LeafNodes = new Map();
    around(this.#bricks, brick, this.#around);
    this.#enter(brick, own);
    const { wanted } = this.#nodes;
    const kept = this.#keptOf(place);
    if (kept) values.set(kept.values);
    this.#take(values);
    if (kept) {
      this.#believe(brick, values);
      this.#filled.push({ values, nodes: kept.nodes });
      return values;
    }
    const mine = this.#mine;
    const slack = brick.near.corners(this.#nodes, mine);
    for (let c = 0; c < CORNERS; c++) {
      if (wanted[c] === 0) continue;
      const value = mine[c]!;
      const isSafe = Math.abs(value) > slack + brick.near.error;
      values[c] = isSafe ? value : this.#asked(brick.near, c, slack === 0 ? value : null);
    }
    this.#believe(brick, values);
    this.#filled.push({ values, nodes: own });
    this.#forget(brick.k);
    return values;
  }

  /** At a corner of the lattice by the list of the brick that owns it: what decides how faces hang together. */
  exact(brick: Brick, c: number): number {
    const { active, lattice } = this.#bricks;
    const x = BRICK * brick.i + (c % SIDE);
    const y = BRICK * brick.j + (Math.floor(c / SIDE) % SIDE);
    const z = BRICK * brick.k + Math.floor(c / (SIDE * SIDE));
    const key = x + lattice.counts[0] * (y + lattice.counts[1] * z);
    const known = this.#exact.get(key);
    if (known !== undefined) return known;
    around(this.#bricks, brick, this.#around);
    const common = SAME_CORNERS[c]!.find((same) => this.#around[same.brick]! >= 0);
    const place = this.#around[common?.brick ?? MIDDLE]!;
    const owner = active[place]!;
    const then = this.#keptOf(place) ? this.#before!.values.#exactAt(lattice, x, y, z) : undefined;
    if (then !== undefined) {
      this.#exact.set(key, then);
      return then;
    }
    this.#nodes.enter(BRICK * owner.i, BRICK * owner.j, BRICK * owner.k, new Map(), []);
    const value = this.#asked(owner.near, common?.at ?? c, null);
    this.#exact.set(key, value);
    return value;
  }

  /** At a node of a lattice that may have grown since; undefined: it was not asked for. */
  #exactAt(now: Lattice, x: number, y: number, z: number): number | undefined {
    const { lattice } = this.#bricks;
    const [dx, dy, dz] = nodesBefore(lattice, now);
    return this.#exact.get(x - dx + lattice.counts[0] * (y - dy + lattice.counts[1] * (z - dz)));
  }

  /** What was before an edit. */
  forget(): void {
    this.#before = null;
  }

  #keptOf(place: number): Filled | null {
    const then = this.#before?.placeOf(place) ?? -1;
    if (then < 0) return null;
    const kept = this.#before!.values.#filled[then]!;
    // what was cut off at the border of a lattice that has grown is not known
    return this.#hasGrown && kept.values.includes(CUT) ? null : kept;
  }

  #enter({ i, j, k }: Brick, own: LeafNodes): void {
    const before = this.#nodesBefore;
    for (let n = 0; n < BEFORE; n++) {
      const place = this.#around[n]!;
      before[n] = place >= 0 ? this.#filled[place]!.nodes : null;
    }
    this.#nodes.enter(BRICK * i, BRICK * j, BRICK * k, own, before);
  }

  /** What bricks before have. */
  #take(values: Float64Array): void {
    const { wanted } = this.#nodes;
    wanted.fill(1);
    for (let brick = 0; brick < BEFORE; brick++) {
      const place = this.#around[brick]!;
      if (place < 0) continue;
      const theirs = this.#filled[place]!.values;
      const pairs = PAIRS[brick]!;
      for (let p = 0; p < pairs.length; p += 2) {
        values[pairs[p]!] = theirs[pairs[p + 1]!]!;
        wanted[pairs[p]!] = 0;
      }
    }
  }

  /** The value by the list, which is known already where that was not interpolated; of all skels where that says too little. */
  #asked(near: Near, c: number, known: number | null): number {
    const value = known ?? this.#nodes.value(near, c);
    if (Math.abs(value) > near.error * (1 + 1e-9)) return value;
    if (Math.abs(value) > this.#nodes.error(near, c) * (1 + 1e-9)) return value;
    const whole = near.error > 0 ? this.#nodes.value(this.whole, c) : value;
    return Number.isNaN(whole) ? -LEAST : whole;
  }

  /** Culled bricks that hold a corner have its sign; nothing is inside at the lattice's border. */
  #believe(brick: Brick, values: Float64Array): void {
    const { wanted } = this.#nodes;
    for (let n = 0; n < 27; n++) {
      const place = this.#around[n]!;
      if (place >= 0) continue;
      for (const c of TOUCHING[n]!) {
        if (wanted[c] === 0) continue;
        const value = values[c]!;
        if (place === OUTSIDE && value > 0) values[c] = -LEAST;
        if (place === INSIDE && !(value > 0)) values[c] = LEAST;
      }
    }
    this.#cut(brick, values);
  }

  #cut({ i, j, k }: Brick, values: Float64Array): void {
    const { counts } = this.#bricks;
    [i, j, k].forEach((at, axis) => {
      const faces = [at === 0 ? 0 : -1, at === counts[axis]! - 1 ? BRICK : -1];
      faces.forEach((face, end) => {
        if (face < 0) return;
        const stride = [1, SIDE, SIDE * SIDE][axis]!;
        for (let c = 0; c < CORNERS; c++) {
          if (Math.floor(c / stride) % SIDE !== face || !(values[c]! > 0 || values[c] === CUT)) continue;
          this.exits[2 * axis + end] = true;
          values[c] = CUT;
        }
      });
    });
  }

  /** Values and nodes are taken over by the next layer of bricks only. */
  #forget(k: number): void {
    const { active } = this.#bricks;
    if (this.isLive) return;
    while (active[this.#forgotten]!.k < k - 1) this.#filled[this.#forgotten++] = FORGOTTEN;
  }
}
