/**
 * Lattice values where the surface may be; elsewhere the sign alone. A tree of cubes over the lattice: where the field's interval over a
 * cube (TreeField.range) does not hold 0, all nodes of the cube are inside or all are outside, and nobody needs their values. The others are
 * halved, down to bricks of four cells, whose nodes are evaluated, each once, by the skels that are near (nearSum.ts). What is culled is
 * proven, and what is neglected bounded, so that every sign is right: the mesh is that of all values.
 *
 * The field of millions of nodes is thus taken at some n² of them. Which bricks may hold surface is a list that later stages can
 * walk too; for now the lattice itself is still dense, one number a node.
 */
import type { Lattice } from './lattice.ts';
import { nodeCount } from './lattice.ts';
import { type Near, nearOf } from './near.ts';
import type { TreeField } from './treeField.ts';

/** cells of a brick along each side: two cost more intervals than they save values, eight more values */
const BRICK = 4;

/** of T: what a brick may neglect of its far skels; nodes with a smaller value are asked again, of all */
const NEGLECTED = 3e-3;

/** Yields after each brick of the first level what share of them is done. */
export function* culledSampling(field: TreeField, lattice: Lattice): Generator<number, Float64Array> {
  const values = new Float64Array(nodeCount(lattice)).fill(Number.NaN);
  const [nx, ny, nz] = lattice.counts;
  let size = BRICK;
  while (size < Math.max(nx, ny, nz) - 1) size *= 2;
  const culling = new Culling(field, lattice, values);
  const top = Math.max(size / 8, BRICK);
  const whole = nearOf(field);
  const layers = Math.ceil((nz - 1) / top);
  for (let k = 0; k < layers; k++) {
    for (let j = 0; j * top < ny - 1; j++) {
      for (let i = 0; i * top < nx - 1; i++) culling.visit(whole, i * top, j * top, k * top, top);
    }
    yield (k + 1) / layers;
  }
  return values;
}

class Culling {
  readonly #field: TreeField;
  readonly #lattice: Lattice;
  readonly #values: Float64Array;

  constructor(field: TreeField, lattice: Lattice, values: Float64Array) {
    this.#field = field;
    this.#lattice = lattice;
    this.#values = values;
  }

  /** The cube of `size` cells from node (i, j, k) on, within the cube that `outer` is of. */
  visit(outer: Near, i: number, j: number, k: number, size: number): void {
    const [nx, ny, nz] = this.#lattice.counts;
    if (i >= nx - 1 || j >= ny - 1 || k >= nz - 1) return;
    const near = this.#within(outer, i, j, k, size);
    if (near.low > 0 || near.high <= 0) {
      const sign = near.low > 0 ? 1 : -1;
      this.#each(i, j, k, size, (at) => {
        // where a neighbour was evaluated its value stands
        if (Number.isNaN(this.#values[at])) this.#values[at] = sign;
      });
      return;
    }
    if (size === BRICK) {
      this.#evaluate(near, i, j, k);
      return;
    }
    const half = size / 2;
    for (let corner = 0; corner < 8; corner++) {
      const [x, y, z] = [i + (corner & 1) * half, j + ((corner >> 1) & 1) * half, k + (corner >> 2) * half];
      this.visit(near, x, y, z, half);
    }
  }

  #within(outer: Near, i: number, j: number, k: number, size: number): Near {
    const { origin, step } = this.#lattice;
    const half = 0.5 * size * step;
    const [x, y, z] = [origin[0] + i * step + half, origin[1] + j * step + half, origin[2] + k * step + half];
    // what is neglected above is neglected in all cubes below: half as much a level
    return outer.within(x, y, z, half * (1 + 1e-12), (NEGLECTED * BRICK) / size);
  }

  #evaluate(near: Near, i: number, j: number, k: number): void {
    const { origin, step } = this.#lattice;
    const doubtful = near.error * (1 + 1e-9);
    this.#each(i, j, k, BRICK, (at, nx, ny, nz) => {
      const known = this.#values[at]!;
      // signs that culled neighbours left are right, but vertices want values
      if (!Number.isNaN(known) && Math.abs(known) !== 1) return;
      const [x, y, z] = [origin[0] + nx * step, origin[1] + ny * step, origin[2] + nz * step];
      const value = near.value(x, y, z);
      this.#values[at] = Math.abs(value) > doubtful ? value : this.#field.value(x, y, z);
    });
  }

  /** All nodes of the cube, its far sides included. */
  #each(
    i: number,
    j: number,
    k: number,
    size: number,
    visit: (at: number, x: number, y: number, z: number) => void,
  ) {
    const [nx, ny, nz] = this.#lattice.counts;
    for (let z = k; z <= Math.min(k + size, nz - 1); z++) {
      for (let y = j; y <= Math.min(j + size, ny - 1); y++) {
        for (let x = i; x <= Math.min(i + size, nx - 1); x++) visit(x + nx * (y + ny * z), x, y, z);
      }
    }
  }
}
