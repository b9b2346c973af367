/** Whether a mesh has the sharp edges of a solid whose edges are known, in cells: how far it is from them, and its vertices there. */
import { expect } from 'vitest';
import type { Lattice } from '../../src/field/lattice.ts';
import type { TreeField } from '../../src/field/treeField.ts';
import { cross3, dot3, length3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { nearestOn } from '../../src/mesh/nearest.ts';
import type { CreaseCase } from './creaseCases.ts';
import { expectSolid } from './meshes.ts';
import { evaluated, type Point } from './trees.ts';

/** cells: how far from the true crease */
export const CLOSE = 0.1;
/** of the surfaces that meet: on both of them */
const ON = 0.05;
/** what a crease has of its length in a cell at least, for a vertex to be asked there */
const CROSSED = 0.3;

export function expectSharp(mesh: Mesh, lattice: Lattice, { sides, crease }: CreaseCase): void {
  expectSolid(mesh);
  const near = buckets(mesh, lattice);
  const missed = crease.filter((_, i) => i % 4 === 0).map((p) => near(p) / lattice.step);
  expect(largest(missed)).toBeLessThan(CLOSE);

  const found = vertices(mesh).filter((p) => fromSecond(sides, p) < ON * lattice.step);
  const away = found.map((p) => fromCrease(crease, p) / lattice.step);
  expect(largest(away)).toBeLessThan(CLOSE);

  expect(cellsWithout(found, crease, lattice)).toEqual([]);
  // a triangle here and there that a turned edge left across the crease
  expect(against(mesh, 1e-3 * lattice.step * lattice.step)).toBeLessThan(1e-3 * mesh.indices.length);
}

/** Corners of triangles, slivers excepted, whose normal is of the other side. */
function against({ positions, normals, indices }: Mesh, sliver: number): number {
  const of = (list: ArrayLike<number>, v: number): Vec3 => [list[3 * v]!, list[3 * v + 1]!, list[3 * v + 2]!];
  let count = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const corners = [0, 1, 2].map((k) => indices[i + k]!);
    const [a, b, c] = corners.map((v) => of(positions, v)) as [Vec3, Vec3, Vec3];
    const across = cross3(sub3(b, a), sub3(c, a));
    if (length3(across) < sliver) continue;
    count += corners.filter((v) => dot3(across, of(normals, v)) <= 0).length;
  }
  return count;
}

export const largest = (list: readonly number[]) => list.reduce((most, x) => Math.max(most, x), 0);

/** mm, nearly: the distance from the second nearest of the surfaces. */
export function fromSecond(sides: readonly TreeField[], p: Point): number {
  const away = sides.map((side) => {
    const [value, gx, gy, gz] = evaluated(side, p);
    return Math.abs(value) / Math.hypot(gx, gy, gz);
  });
  return away.sort((a, b) => a - b)[1]!;
}

const vertices = ({ positions }: Mesh): Point[] =>
  Array.from({ length: positions.length / 3 }, (_, i) => [
    positions[3 * i]!,
    positions[3 * i + 1]!,
    positions[3 * i + 2]!,
  ]);

const fromCrease = (crease: readonly Point[], [x, y, z]: Point): number =>
  Math.sqrt(
    crease.reduce(
      (least, [a, b, c]) => Math.min(least, (a - x) ** 2 + (b - y) ** 2 + (c - z) ** 2),
      Infinity,
    ),
  );

const cellOf = ({ origin, step }: Lattice, p: Point) => p.map((x, k) => Math.floor((x - origin[k]!) / step));

/** The distance from a mesh, by triangles in the cells around; Infinity where there are none. */
function buckets(mesh: Mesh, lattice: Lattice): (p: Point) => number {
  const all = vertices(mesh);
  const cells = new Map<string, number[]>();
  for (let i = 0; i < mesh.indices.length; i += 3) {
    const corners = [0, 1, 2].map((k) => cellOf(lattice, all[mesh.indices[i + k]!]!));
    for (const key of new Set(corners.map(String))) {
      cells.set(key, [...(cells.get(key) ?? []), i]);
    }
  }
  return (p) => {
    const [x, y, z] = cellOf(lattice, p) as [number, number, number];
    const close: number[] = [];
    for (const i of [-1, 0, 1])
      for (const j of [-1, 0, 1])
        for (const k of [-1, 0, 1]) close.push(...(cells.get(String([x + i, y + j, z + k])) ?? []));
    const indices = Uint32Array.from(close.flatMap((i) => [...mesh.indices.subarray(i, i + 3)]));
    return nearestOn({ ...mesh, indices }, p)?.distance ?? Infinity;
  };
}

/** Cells that a crease passes through, and in which no vertex lies on it, nor within half a cell beside. */
function cellsWithout(found: readonly Point[], crease: readonly Point[], lattice: Lattice): string[] {
  const { origin, step } = lattice;
  const passed = new Map<string, number>();
  crease.forEach((p, i) => {
    const [x, y, z] = crease[i + 1] ?? p;
    const length = Math.hypot(x - p[0], y - p[1], z - p[2]);
    const key = String(cellOf(lattice, p));
    // from one edge to the next it jumps
    if (length < 0.1 * step) passed.set(key, (passed.get(key) ?? 0) + length);
  });
  const has = (cell: readonly number[]) =>
    found.some((p) => p.every((x, k) => Math.abs((x - origin[k]!) / step - cell[k]! - 0.5) <= 1));
  return [...passed]
    .filter(([key, length]) => length > CROSSED * step && !has(key.split(',').map(Number)))
    .map(([key]) => key);
}
