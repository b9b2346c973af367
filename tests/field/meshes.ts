/** What tests of meshes of fields ask. Tolerances follow from the size of a cell: facets are chords of the surface. */
import { expect } from 'vitest';
import type { Affine } from '../../src/field/affine.ts';
import { bindField } from '../../src/field/bind.ts';
import type { Lattice } from '../../src/field/lattice.ts';
import type { FieldNode, SetNode } from '../../src/field/node.ts';
import { type Polygonized, polygonize } from '../../src/field/polygonize.ts';
import { topology } from '../../src/mesh/check.ts';
import { area, bounds, volume } from '../../src/mesh/measure.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { weld } from '../../src/mesh/weld.ts';
import type { Shape } from '../../src/shape/index.ts';
import type { Point } from './trees.ts';

export const shape = (of: Shape): FieldNode => ({ type: 'shape', shape: of });

export const set = (type: SetNode['type'], form: SetNode['form'], ...parts: FieldNode[]): FieldNode => ({
  type,
  form,
  parts,
});

export const made = (node: FieldNode, resolution: number): Polygonized =>
  polygonize(bindField(node), resolution);

/** y, the axis of shapes, along `to`. */
export function along([x, y, z]: Point, node: FieldNode): FieldNode {
  const length = Math.hypot(x, y, z);
  const [dx, dy, dz] = [x / length, y / length, z / length];
  const flat = Math.hypot(dx, dy);
  const [sx, sy] = [dy / flat, -dx / flat];
  const third = [sy * dz, -sx * dz, sx * dy - sy * dx] as const;
  const matrix: Affine = [sx, dx, third[0], 0, sy, dy, third[1], 0, 0, dz, third[2], 0];
  return { type: 'affine', matrix, node };
}

/** Closed, outward, of one piece unless said. */
export function expectSolid(mesh: Mesh, genus = 0, components = 1): void {
  expect(topology(mesh)).toMatchObject({
    watertight: true,
    genus,
    components,
    euler: 2 * (components - genus),
    finite: true,
  });
  expect(volume(mesh)).toBeGreaterThan(0);
}

/** What is known of a solid without a mesh. mm, mm², mm³. */
export interface Known {
  readonly genus?: number;
  readonly components?: number;
  readonly volume: number;
  readonly area: number;
  /** half sizes of its box, if it is about the origin */
  readonly half?: Point;
  /** 1/mm: the largest curvature off the creases */
  readonly curvature: number;
  /** mm: the length of all creases, which facets may cut or overshoot by a cell */
  readonly creases: number;
}

/**
 * A triangle of a cube of edge h is nowhere farther than κ (√3 h / 2)² / 2 from a surface with curvature κ on which its corners
 * lie, and its normal is off by at most √3 h κ. Across a crease it cuts off less than a right triangle of a cell's two sides.
 */
export function expectKnown({ mesh, lattice: { step } }: Polygonized, known: Known): void {
  const { genus = 0, components = 1, half, curvature, creases } = known;
  expectSolid(mesh, genus, components);
  const deep = (3 / 8) * curvature * step * step;
  expect(Math.abs(volume(mesh) - known.volume)).toBeLessThan(known.area * deep + creases * step * step);
  const tilt = 1.5 * (curvature * step) ** 2;
  expect(Math.abs(area(mesh) - known.area)).toBeLessThan(known.area * tilt + creases * step);
  if (!half) return;
  const { min, max } = bounds(mesh);
  // of vertices within √3 h of the farthest point, or of a corner that was cut
  const short = 1.5 * curvature * step * step + (creases > 0 ? step : 0) + 1e-3 * step;
  half.forEach((size, axis) => {
    for (const end of [-min[axis]!, max[axis]!]) {
      expect(end).toBeLessThan(size + 1e-2 * step);
      expect(end).toBeGreaterThan(size - short);
    }
  });
}

/** Whether all vertices are within the lattice. */
export function isWithin({ positions }: Mesh, { origin, step, counts }: Lattice): boolean {
  const slack = 1e-3 * step + 1e-6 * Math.max(...origin.map(Math.abs));
  return positions.every((x, i) => {
    const axis = (i % 3) as 0 | 1 | 2;
    return x >= origin[axis] - slack && x <= origin[axis] + (counts[axis] - 1) * step + slack;
  });
}

/** Whether there are two fans of triangles at one point. The mesh is watertight. */
export function touches(mesh: Mesh): boolean {
  const { ids } = weld(mesh.positions);
  const places = new Set(Array.from(mesh.indices, (i) => ids[i]!)).size;
  // V of the Euler number counts fans
  return topology(mesh).euler + mesh.indices.length / 6 !== places;
}

/** Cells by which vertices are off the surface of a field, at most. */
export function offBy(node: FieldNode, mesh: Mesh, step: number): number {
  const field = bindField(node);
  const out = new Float64Array(4);
  let most = 0;
  for (let i = 0; i < mesh.positions.length; i += 3) {
    field.evaluate(mesh.positions[i]!, mesh.positions[i + 1]!, mesh.positions[i + 2]!, out);
    most = Math.max(most, Math.abs(out[0]!) / Math.hypot(out[1]!, out[2]!, out[3]!) / step);
  }
  return most;
}
