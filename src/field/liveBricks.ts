/**
 * The octree of bricks (bricks.ts) of a body that is being edited: it stays from one edit to the next, and only cubes that a change
 * reaches are looked at again. By how much values in a cube may have changed is bounded without them (Near.effect); as long as what
 * an edit leaves uncorrected adds up to less than a hundredth of a cell, or than what a culled cube has to spare, the cube and all that is in
 * it stay. So many small drags come to no more than one.
 *
 * The lattice may grow by whole bricks to all sides: the octree then grows upwards, cubes of twice the size around it, and what is in it stays.
 */
import type { Vec3 } from '../math/vec.ts';
import {
  type Brick,
  type Bricks,
  countsOf,
  cubeWithin,
  eighths,
  fillInside,
  INSIDE,
  inOrder,
  OUTSIDE,
  stateOf,
} from './bricks.ts';
import { BRICK, type Grown, type Lattice } from './lattice.ts';
import type { Changes, Near } from './near.ts';

/** cells: by how much the surface may stay where it was before */
const STALE = 1e-2;

/** cubes between two looks at the clock */
const BATCH = 16;

/** bricks along an axis, more than a lattice grows to */
const ALONG = 1 << 12;

/** Places in bricks from the first brick of the lattice as it was made. */
interface Cube {
  readonly i: number;
  readonly j: number;
  readonly k: number;
  /** bricks */
  readonly size: number;
  near: Near;
  /** by how much its values may be off for what was not followed */
  debt: number;
  /** as stateOf */
  state: number;
  parts: Cube[] | null;
}

export class LiveBricks {
  #lattice: Lattice;
  /** the first brick of the lattice */
  #first: Vec3 = [0, 0, 0];
  #root: Cube;
  /** numbers of bricks that were made anew by the last edit */
  readonly renewed = new Set<number>();

  private constructor(whole: Near, lattice: Lattice) {
    this.#lattice = lattice;
    let size = 1;
    while (size < Math.max(...countsOf(lattice))) size *= 2;
    this.#root = this.#made(whole, 0, 0, 0, size);
  }

  /** Yields now and then: what share is done is not known. */
  static *making(whole: Near, lattice: Lattice): Generator<number, LiveBricks> {
    const bricks = new LiveBricks(whole, lattice);
    yield* bricks.#fill(bricks.#root);
    return bricks;
  }

  /**
   * `whole`: the field after the changes. `grown`: the lattice, where it is no longer the one before. Yields now and then.
   */
  *edit(whole: Near, changes: Changes, grown: Grown | null = null): Generator<number> {
    this.renewed.clear();
    const root = this.#root;
    const outer = grown ? this.#grow(whole, grown) : whole;
    yield* this.#visit(root, outer, changes);
    if (grown) yield* this.#complete(this.#root, whole);
  }

  bricks(): Bricks {
    const lattice = this.#lattice;
    const [nx, ny, nz] = countsOf(lattice);
    const grid = new Int32Array(nx * ny * nz).fill(OUTSIDE);
    const active: Brick[] = [];
    this.#collect(this.#root, grid, active);
    return inOrder(lattice, active, grid);
  }

  /** A number that the brick keeps when the lattice grows. */
  number({ i, j, k }: Pick<Brick, 'i' | 'j' | 'k'>): number {
    const [x, y, z] = this.#first;
    return i + x + ALONG * (j + y + ALONG * (k + z));
  }

  /** The root becomes an eighth of a larger one, until that holds the lattice. Returns the field in the cube around the root that was. */
  #grow(whole: Near, { lattice, before }: Grown): Near {
    let outer: Near | null = null;
    const [x, y, z] = this.#first;
    this.#lattice = lattice;
    this.#first = [x - before[0], y - before[1], z - before[2]];
    for (;;) {
      const { size } = this.#root;
      const at = this.#within(this.#root);
      if (at.every((low, axis) => low <= 0 && low + size >= countsOf(lattice)[axis]!)) {
        return outer ?? whole;
      }
      const first = (axis: 0 | 1 | 2) => at[axis] + this.#first[axis] - (at[axis] > 0 ? size : 0);
      const larger = this.#made(whole, first(0), first(1), first(2), 2 * size);
      if (larger.state === 0) larger.parts = [this.#root];
      this.#root = larger;
      outer ??= larger.near;
    }
  }

  /** What the lattice did not hold before. `outer`: the field after the changes in a cube around. */
  *#complete(cube: Cube, outer: Near): Generator<number> {
    if (!cube.parts) return;
    const { i, j, k, size } = cube;
    const near = cube.debt === 0 ? cube.near : outer;
    const parts: Cube[] = [];
    for (const at of this.#eighths(i, j, k, size / 2)) {
      const known = cube.parts.find((part) => part.i === at[0] && part.j === at[1] && part.k === at[2]);
      const part = known ?? this.#made(near, ...at, size / 2);
      parts.push(part);
      yield* known ? this.#complete(part, near) : this.#fill(part);
    }
    cube.parts = parts;
  }

  /** From the first brick of the lattice as it is. */
  #within({ i, j, k }: Pick<Cube, 'i' | 'j' | 'k'>): Vec3 {
    const [x, y, z] = this.#first;
    return [i - x, j - y, k - z];
  }

  #eighths(i: number, j: number, k: number, half: number): readonly Vec3[] {
    const [x, y, z] = this.#first;
    const parts = eighths(i - x, j - y, k - z, half, countsOf(this.#lattice));
    return parts.map((part): Vec3 => [part[0] + x, part[1] + y, part[2] + z]);
  }

  #made(outer: Near, i: number, j: number, k: number, size: number): Cube {
    const cube: Cube = { i, j, k, size, near: outer, debt: 0, state: 0, parts: null };
    this.#look(cube, outer);
    return cube;
  }

  #look(cube: Cube, outer: Near): void {
    const [x, y, z] = this.#within(cube);
    cube.near = cubeWithin(outer, this.#lattice, x, y, z, cube.size);
    cube.debt = 0;
    cube.state = stateOf(cube.near, countsOf(this.#lattice), x, y, z, cube.size);
  }

  /** Of a cube that has no parts yet, all that it is to have. */
  *#fill(root: Cube): Generator<number> {
    const open = [root];
    let count = 0;
    for (let cube = open.pop(); cube; cube = open.pop()) {
      const { i, j, k, size, near, state } = cube;
      if (state !== 0) continue;
      if (size === 1) {
        this.renewed.add(this.number(this.#placed(cube)));
        continue;
      }
      cube.parts = this.#eighths(i, j, k, size / 2).map((at) => this.#made(near, ...at, size / 2));
      open.push(...cube.parts);
      if (++count % BATCH === 0) yield 0;
    }
  }

  #placed(cube: Cube): Brick {
    const [i, j, k] = this.#within(cube);
    return { i, j, k, near: cube.near };
  }

  *#visit(cube: Cube, outer: Near, changes: Changes): Generator<number> {
    const { size, near } = cube;
    const { origin, step } = this.#lattice;
    const half = 0.5 * size * BRICK * step;
    const at = this.#within(cube);
    const centre = (axis: 0 | 1 | 2) => origin[axis] + at[axis] * BRICK * step + half;
    const effect = near.effect(outer, changes, centre(0), centre(1), centre(2), half * (1 + 1e-12));
    // of edits before, which the parts have not seen
    const owed = cube.debt;
    cube.debt += effect;
    if (cube.debt <= this.#allowed(cube)) return;
    yield 0;
    const before = cube.state;
    this.#look(cube, outer);
    if (cube.state !== 0 || before !== 0 || size === 1) {
      cube.parts = null;
      yield* this.#fill(cube);
      return;
    }
    for (const part of cube.parts!) {
      part.debt += owed;
      yield* this.#visit(part, cube.near, changes);
    }
  }

  /** What is culled may be off by what it has to spare. */
  #allowed({ near, state }: Cube): number {
    const spare = state === OUTSIDE ? -near.high : state === INSIDE ? near.low : 0;
    return Math.max(spare, STALE * this.#lattice.step * near.steep);
  }

  #collect(cube: Cube, grid: Int32Array, active: Brick[]): void {
    if (cube.parts) for (const part of cube.parts) this.#collect(part, grid, active);
    else if (cube.state === 0) active.push(this.#placed(cube));
    else if (cube.state === INSIDE)
      fillInside(grid, countsOf(this.#lattice), ...this.#within(cube), cube.size);
  }
}
