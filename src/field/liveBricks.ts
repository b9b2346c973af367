/**
 * The octree of bricks (bricks.ts) of a body that is being edited: it stays from one edit to the next, and only cubes that a change
 * reaches are looked at again. By how much values in a cube may have changed is bounded without them (Near.effect); as long as what
 * an edit leaves uncorrected adds up to less than a hundredth of a cell, or than what a culled cube has to spare, the cube and all that is in
 * it stay. So many small drags come to no more than one.
 */
import type { Vec3 } from '../math/vec.ts';
import { type Brick, type Bricks, cubeWithin, INSIDE, isAtBorder, OUTSIDE } from './bricks.ts';
import { BRICK, type Lattice } from './lattice.ts';
import type { Changes, Near } from './near.ts';

/** cells: by how much the surface may stay where it was before */
const STALE = 1e-2;

/** cubes between two looks at the clock */
const BATCH = 16;

interface Cube {
  readonly i: number;
  readonly j: number;
  readonly k: number;
  /** bricks */
  readonly size: number;
  near: Near;
  /** by how much its values may be off for what was not followed */
  debt: number;
  /** OUTSIDE, INSIDE, or 0 where it may hold surface */
  state: number;
  parts: Cube[] | null;
}

export class LiveBricks {
  readonly #lattice: Lattice;
  readonly #counts: Vec3;
  #root: Cube | null = null;
  /** numbers of bricks that were made anew by the last edit */
  readonly renewed = new Set<number>();

  private constructor(lattice: Lattice) {
    this.#lattice = lattice;
    this.#counts = lattice.counts.map((nodes) => (nodes - 1) / BRICK) as unknown as Vec3;
  }

  /** Yields now and then: what share is done is not known. */
  static *making(whole: Near, lattice: Lattice): Generator<number, LiveBricks> {
    const bricks = new LiveBricks(lattice);
    let size = 1;
    while (size < Math.max(...bricks.#counts)) size *= 2;
    const root = bricks.#made(whole, 0, 0, 0, size);
    bricks.#root = root;
    const open = [root];
    let count = 0;
    for (let cube = open.pop(); cube; cube = open.pop()) {
      bricks.#divide(cube);
      open.push(...(cube.parts ?? []));
      if (++count % BATCH === 0) yield 0;
    }
    return bricks;
  }

  /** `whole`: the field after the changes. Yields now and then. */
  *edit(whole: Near, changes: Changes): Generator<number> {
    this.renewed.clear();
    if (this.#root) yield* this.#visit(this.#root, whole, changes);
  }

  bricks(): Bricks {
    const [nx, ny, nz] = this.#counts;
    const grid = new Int32Array(nx * ny * nz).fill(OUTSIDE);
    const active: Brick[] = [];
    if (this.#root) this.#collect(this.#root, grid, active);
    active.sort((a, b) => this.number(a) - this.number(b));
    for (const [place, brick] of active.entries()) grid[this.number(brick)] = place;
    return { lattice: this.#lattice, counts: this.#counts, active, grid };
  }

  number({ i, j, k }: Pick<Brick, 'i' | 'j' | 'k'>): number {
    return i + this.#counts[0] * (j + this.#counts[1] * k);
  }

  #made(outer: Near, i: number, j: number, k: number, size: number): Cube {
    const near = cubeWithin(outer, this.#lattice, i, j, k, size);
    return { i, j, k, size, near, debt: 0, state: this.#stateOf(near, i, j, k, size), parts: null };
  }

  #stateOf(near: Near, i: number, j: number, k: number, size: number): number {
    if (near.high <= 0) return OUTSIDE;
    return near.low > 0 && !isAtBorder(this.#counts, i, j, k, size) ? INSIDE : 0;
  }

  /** The parts of a cube that has none yet, if it is to have any. */
  #divide(cube: Cube): void {
    const { i, j, k, size, near } = cube;
    if (cube.state !== 0) return;
    if (size === 1) {
      this.renewed.add(this.number(cube));
      return;
    }
    const half = size / 2;
    cube.parts = [];
    for (let corner = 0; corner < 8; corner++) {
      const [x, y, z] = [i + (corner & 1) * half, j + ((corner >> 1) & 1) * half, k + (corner >> 2) * half];
      if ([x, y, z].every((at, axis) => at < this.#counts[axis]!))
        cube.parts.push(this.#made(near, x, y, z, half));
    }
  }

  #divideAll(cube: Cube): void {
    this.#divide(cube);
    for (const part of cube.parts ?? []) this.#divideAll(part);
  }

  *#visit(cube: Cube, outer: Near, changes: Changes): Generator<number> {
    const { i, j, k, size, near } = cube;
    const { origin, step } = this.#lattice;
    const half = 0.5 * size * BRICK * step;
    const [x, y, z] = [i, j, k].map((at, axis) => origin[axis]! + at * BRICK * step + half) as [
      number,
      number,
      number,
    ];
    const effect = near.effect(outer, changes, x, y, z, half * (1 + 1e-12), cube.debt);
    // of edits before, which the parts have not seen
    const owed = cube.debt;
    cube.debt += effect;
    if (cube.debt <= this.#allowed(cube)) return;
    yield 0;
    const before = cube.state;
    cube.near = cubeWithin(outer, this.#lattice, i, j, k, size);
    cube.debt = 0;
    cube.state = this.#stateOf(cube.near, i, j, k, size);
    if (cube.state !== 0 || before !== 0 || size === 1) {
      cube.parts = null;
      this.#divideAll(cube);
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
    const [nx, ny, nz] = this.#counts;
    const { i, j, k, size, state, near } = cube;
    if (cube.parts) for (const part of cube.parts) this.#collect(part, grid, active);
    else if (state === 0) active.push({ i, j, k, near });
    else if (state === INSIDE) {
      for (let z = k; z < Math.min(k + size, nz); z++)
        for (let y = j; y < Math.min(j + size, ny); y++) {
          const row = nx * (y + ny * z);
          grid.fill(INSIDE, row + i, row + Math.min(i + size, nx));
        }
    }
  }
}
