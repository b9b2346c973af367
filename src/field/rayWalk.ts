/**
 * The bricks that a ray comes through, one after the other (Amanatides & Woo 1987), on two levels: blocks of 4³ bricks of which none
 * may hold surface are passed at once, and are told as one.
 */
import type { Vec3 } from '../math/vec.ts';
import type { Bricks } from './bricks.ts';
import { BRICK } from './lattice.ts';

/** bricks of a block along each side */
const BLOCK = 4;
/** neither all outside nor all inside */
const MIXED = 0;

/** Bricks that rays walk through, with what is the same in whole blocks of them: OUTSIDE, INSIDE or MIXED. */
export interface Walked {
  readonly bricks: Bricks;
  readonly blocks: Int8Array;
  readonly along: Vec3;
}

export function walked(bricks: Bricks): Walked {
  const [nx, ny, nz] = bricks.counts;
  const along: Vec3 = [Math.ceil(nx / BLOCK), Math.ceil(ny / BLOCK), Math.ceil(nz / BLOCK)];
  const blocks = new Int8Array(along[0] * along[1] * along[2]).fill(1);
  for (let k = 0; k < nz; k++) {
    for (let j = 0; j < ny; j++) {
      for (let i = 0; i < nx; i++) {
        const state = Math.min(bricks.grid[i + nx * (j + ny * k)]!, MIXED);
        const block = blockOf(along, i, j, k);
        if (blocks[block] === 1) blocks[block] = state;
        else if (blocks[block] !== state) blocks[block] = MIXED;
      }
    }
  }
  return { bricks, blocks, along };
}

const blockOf = ([nx, ny]: Vec3, i: number, j: number, k: number): number =>
  Math.floor(i / BLOCK) + nx * (Math.floor(j / BLOCK) + ny * Math.floor(k / BLOCK));

export class RayWalk {
  readonly #walked: Walked;
  /** mm of a brick */
  readonly #edge: number;
  readonly #at = new Int32Array(3);
  #from: Vec3 = [0, 0, 0];
  #ray: Vec3 = [1, 0, 0];
  #end = 0.5;
  /** place among the active bricks, OUTSIDE or INSIDE */
  state = 0;
  /** mm along the ray: where the brick, or the block, is entered and left */
  start = 0.5;
  stop = 0.5;
  /** where the lattice is entered, and across which axis; −1 where the ray began in it */
  entry = 0.5;
  entered = -1;

  constructor(walked: Walked) {
    this.#walked = walked;
    this.#edge = BRICK * walked.bricks.lattice.step;
  }

  /** From `nearest` to `farthest` mm along the unit vector `ray` from `from`; false where the lattice is not met. */
  begin(from: Vec3, ray: Vec3, nearest: number, farthest: number): boolean {
    this.#from = from;
    this.#ray = ray;
    if (!this.#clip(nearest, farthest)) return false;
    const { lattice, counts } = this.#walked.bricks;
    for (let axis = 0; axis < 3; axis++) {
      const at = (from[axis]! + this.start * ray[axis]! - lattice.origin[axis]!) / this.#edge;
      this.#at[axis] = Math.min(Math.max(Math.floor(at), 0), counts[axis]! - 1);
    }
    this.#look();
    return true;
  }

  /** Goes on to the next; false at the end. */
  next(): boolean {
    if (!(this.stop < this.#end)) return false;
    const { counts } = this.#walked.bricks;
    const axis = this.#out;
    this.#at[axis] = this.#ray[axis]! > 0 ? this.#last[axis]! + 1 : this.#first[axis]! - 1;
    if (this.#at[axis]! < 0 || this.#at[axis]! >= counts[axis]!) return false;
    // in a block the other axes have gone on
    for (let other = 0; other < 3; other++) {
      if (other === axis) continue;
      const at = (this.#from[other]! + this.stop * this.#ray[other]! - this.#origin(other)) / this.#edge;
      this.#at[other] = Math.min(Math.max(Math.floor(at), this.#first[other]!), this.#last[other]!);
    }
    this.start = this.stop;
    this.#look();
    return true;
  }

  readonly #first = new Int32Array(3);
  readonly #last = new Int32Array(3);
  #out = 0;

  #origin(axis: number): number {
    return this.#walked.bricks.lattice.origin[axis]!;
  }

  /** The half cells at the border of the lattice are cut off, as they are of meshes. */
  #clip(nearest: number, farthest: number): boolean {
    const { lattice } = this.#walked.bricks;
    let [start, end] = [nearest, farthest];
    this.entered = -1;
    for (let axis = 0; axis < 3; axis++) {
      const low = lattice.origin[axis]! + 0.5 * lattice.step - this.#from[axis]!;
      const high = low + (lattice.counts[axis]! - 2) * lattice.step;
      const along = this.#ray[axis]!;
      if (along === 0) {
        if (low > 0 || high < 0) return false;
        continue;
      }
      const [near, far] = along > 0 ? [low / along, high / along] : [high / along, low / along];
      if (near > start) {
        start = near;
        this.entered = axis;
      }
      end = Math.min(end, far);
    }
    this.start = start;
    this.entry = start;
    this.#end = end;
    return start < end;
  }

  #look(): void {
    const { bricks, blocks, along } = this.#walked;
    const [i, j, k] = [this.#at[0]!, this.#at[1]!, this.#at[2]!];
    const block = blocks[blockOf(along, i, j, k)]!;
    const [nx, ny] = bricks.counts;
    this.state = block === MIXED ? bricks.grid[i + nx * (j + ny * k)]! : block;
    const size = block === MIXED ? 1 : BLOCK;
    this.stop = this.#end;
    for (let axis = 0; axis < 3; axis++) {
      const first = this.#at[axis]! - (this.#at[axis]! % size);
      const last = Math.min(first + size, bricks.counts[axis]!) - 1;
      this.#first[axis] = first;
      this.#last[axis] = last;
      const ray = this.#ray[axis]!;
      if (ray === 0) continue;
      const wall = this.#origin(axis) + (ray > 0 ? last + 1 : first) * this.#edge;
      const t = (wall - this.#from[axis]!) / ray;
      if (t < this.stop) {
        this.stop = Math.max(t, this.start);
        this.#out = axis;
      }
    }
  }
}
