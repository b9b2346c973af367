/** A field that is noise at the nodes of a lattice and linear between them, as the octree's nodes have it: every cube a hard case. */

import type { BrickNodes } from '../../src/field/brickNodes.ts';
import { type Bricks, culling } from '../../src/field/bricks.ts';
import type { Lattice } from '../../src/field/lattice.ts';
import type { Near } from '../../src/field/near.ts';
import { finished } from './finished.ts';

const CORNERS = Array.from({ length: 8 }, (_, corner) => corner);

/** Of `values` at the nodes. */
export function noise({ counts: [nx, ny, nz] }: Lattice, values: Float64Array): Near {
  const value = (x: number, y: number, z: number) => {
    const first = (c: number, nodes: number) => Math.min(Math.floor(c), nodes - 2);
    const [i, j, k] = [first(x, nx), first(y, ny), first(z, nz)];
    const at = (corner: number) =>
      values[i + (corner & 1) + nx * (j + ((corner >> 1) & 1) + ny * (k + (corner >> 2)))]!;
    const share = (c: number, from: number, bit: number) => (bit ? c - from : 1 - c + from);
    return CORNERS.reduce(
      (sum, c) => sum + at(c) * share(x, i, c & 1) * share(y, j, c & 2) * share(z, k, c & 4),
      0,
    );
  };
  const evaluate = (x: number, y: number, z: number, out: Float64Array) => {
    const h = 1e-6;
    out[0] = value(x, y, z);
    out[1] = (value(x + h, y, z) - value(x - h, y, z)) / (2 * h);
    out[2] = (value(x, y + h, z) - value(x, y - h, z)) / (2 * h);
    out[3] = (value(x, y, z + h) - value(x, y, z - h)) / (2 * h);
  };
  const near: Near = {
    low: -1,
    high: 1,
    error: 0,
    errorAt: () => 0,
    mostMissed: Infinity,
    asked: 1,
    branches: 1,
    node: 0,
    steep: 1,
    effect: () => Infinity,
    plain: [0.5, 0.5, 0.5],
    value,
    evaluate,
    colour: value,
    branch: () => 0,
    holds: () => true,
    onBranch: (_, x, y, z, out) => evaluate(x, y, z, out),
    look: (_, x, y, z) => value(x, y, z),
    clear: () => 0,
    reached: () => Infinity,
    around: () => 0,
    ahead: (_, out) => out.set([-Infinity, Infinity]),
    within: () => near,
    corners: (nodes: BrickNodes, out) => nodes.exact(near, out),
    eachLeaf: () => {},
    eachDropped: () => {},
  };
  return near;
}

/** All bricks of a lattice, each with that field. */
export const everyBrick = (near: Near, lattice: Lattice): Bricks => finished(culling(near, lattice));
