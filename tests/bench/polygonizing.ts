/**
 * How polygonizing is measured. Work is counted as skels asked: 1 a value, 1.6 with its gradient, 0.25 a distance or remainder, 0.45 a
 * point of a far expansion, flops/80 of interpolation; dense work is all skels at all nodes of the same lattice, values only.
 */
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { bindField } from '../../src/field/bind.ts';
import type { Lattice } from '../../src/field/lattice.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { type Polygonized, polygonize, polygonizing } from '../../src/field/polygonize.ts';
import type { TreeField } from '../../src/field/treeField.ts';
import { nodeCount } from '../field/nodeCount.ts';
import { skelsOf } from './scenes/index.ts';

/** ms that one measurement may take, about: dense lattices are sampled in part, quick ones of ours repeated */
const PATIENCE = 1000;
const ROUNDS = 5;
const MIB = 2 ** 20;

export interface Measured {
  readonly result: Polygonized;
  readonly skels: number;
  readonly work: number;
  readonly denseWork: number;
  /** the whole, tree to mesh, the least of some rounds */
  readonly milliseconds: number;
}

export function measured(node: FieldNode, resolution: number): Measured {
  const skels = skelsOf(node);
  const { result, milliseconds } = least(() => polygonize(bindField(node), resolution));
  const denseWork = skels * nodeCount(result.lattice);
  return { result, skels, work: result.evaluations, denseWork, milliseconds };
}

/** The least time of as many rounds as patience allows, at least one. */
function least<T>(make: () => T): { readonly result: T; readonly milliseconds: number } {
  const begin = performance.now();
  let milliseconds = Infinity;
  for (let round = 1; ; round++) {
    const start = performance.now();
    const result = make();
    milliseconds = Math.min(milliseconds, performance.now() - start);
    if (round === ROUNDS || performance.now() - begin > PATIENCE) return { result, milliseconds };
  }
}

let unread = 0;

/**
 * Milliseconds for the values of all nodes in TypeScript. Rows of nodes are taken all over the lattice until patience ends, and
 * the rest is extrapolated: `share` of them was taken.
 */
export function denseTime(field: TreeField, { origin, step, counts }: Lattice) {
  const rows = counts[1] * counts[2];
  const stride = coprime(Math.floor(rows * 0.618), rows);
  const start = performance.now();
  let taken = 0;
  for (let row = 0; taken < rows && performance.now() - start < PATIENCE; taken++) {
    const [y, z] = [origin[1] + (row % counts[1]) * step, origin[2] + Math.floor(row / counts[1]) * step];
    for (let i = 0; i < counts[0]; i++) unread += field.value(origin[0] + i * step, y, z);
    row = (row + stride) % rows;
  }
  if (Number.isNaN(unread)) console.log('a field is no number');
  return { milliseconds: ((performance.now() - start) * rows) / taken, share: taken / rows };
}

/** The next number that has no factor with `of` in common: its multiples reach all rows. */
function coprime(from: number, of: number): number {
  const divisor = (a: number, b: number): number => (b === 0 ? a : divisor(b, a % b));
  let at = Math.max(from, 1);
  while (divisor(at, of) !== 1) at++;
  return at;
}

/** How far vertices are from the surface, in cells, by the whole field: |f| / (|∇f| h). Every `every`-th vertex. */
export function vertexErrors(field: TreeField, mesh: Polygonized['mesh'], { step }: Lattice, every: number) {
  const out = new Float64Array(4);
  const errors: number[] = [];
  for (let i = 0; i < mesh.positions.length; i += 3 * every) {
    field.evaluate(mesh.positions[i]!, mesh.positions[i + 1]!, mesh.positions[i + 2]!, out);
    errors.push(Math.abs(out[0]!) / (Math.hypot(out[1]!, out[2]!, out[3]!) * step));
  }
  errors.sort((a, b) => a - b);
  return { p999: errors[Math.floor(0.999 * errors.length)] ?? 0, most: errors.at(-1) ?? 0 };
}

/** MiB that are reachable at most while a mesh is made, its own arrays included, seen after some of the steps. Slow. */
export function peakMemory(node: FieldNode, resolution: number): number {
  setFlagsFromString('--expose-gc');
  const collect = runInNewContext('gc') as () => void;
  const used = () => {
    // buffers of the first are given back at the second
    collect();
    collect();
    const { heapUsed, arrayBuffers } = process.memoryUsage();
    return heapUsed + arrayBuffers;
  };
  const before = used();
  const steps = polygonizing(bindField(node), resolution);
  let most = 0;
  for (let i = 0; ; i++) {
    const { done, value } = steps.next();
    if (done || i % 8 === 0) most = Math.max(most, used());
    // the mesh is held until here
    if (done && value.mesh.indices) return (most - before) / MIB;
  }
}
