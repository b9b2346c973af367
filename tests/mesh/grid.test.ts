import { describe, expect, test } from 'vitest';
import type { Plane } from '../../src/math/plane.ts';
import { topology } from '../../src/mesh/check.ts';
import { type Columns, evenColumns, gridMesh as gridOf, type Row } from '../../src/mesh/grid.ts';
import { volume } from '../../src/mesh/measure.ts';

const PLANE = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] } as const;
const COLUMNS = 12;
const gridMesh = (rows: readonly Row[], columns: number, plane: Plane) =>
  gridOf(rows, evenColumns(columns), plane);

/** A horizontal ring whose columns run counter-clockwise seen from above; `lean`: z of its normals. */
function ring(radius: number, z: number, options: { joined?: boolean; lean?: number } = {}): Row {
  const { joined = true, lean = 0 } = options;
  const each = (r: number, w: number): Float64Array =>
    Float64Array.from({ length: 3 * (COLUMNS + 1) }, (_, i) => {
      const angle = (2 * Math.PI * (Math.floor(i / 3) % COLUMNS)) / COLUMNS;
      return [r * Math.cos(angle), r * Math.sin(angle), w][i % 3]!;
    });
  const flat = Math.sqrt(1 - lean * lean);
  return { points: each(radius, z), normals: each(flat, lean), joined, pole: radius === 0 };
}

/** Downwards, so that (along the rows) × (along the columns) points outward. */
const bicone = [
  ring(0, 1, { lean: 0.7 }),
  ring(1, 0, { lean: 0.7 }),
  ring(1, 0, { joined: false, lean: -0.7 }),
  ring(0, -1, { lean: -0.7 }),
];

describe('grid meshes', () => {
  test('poles are fans without degenerate triangles; creases stay closed', () => {
    const mesh = gridMesh(bicone, COLUMNS, PLANE);
    expect(mesh.indices).toHaveLength(3 * 2 * COLUMNS);
    expect(topology(mesh)).toMatchObject({ watertight: true, genus: 0, components: 1, degenerate: 0 });
    const base = (COLUMNS / 2) * Math.sin((2 * Math.PI) / COLUMNS);
    expect(volume(mesh)).toBeCloseTo((2 * base) / 3, 5);
  });

  test('a pole has the normal and the texture of the middle of its column', () => {
    const mesh = gridMesh(bicone, COLUMNS, PLANE);
    const half = Math.PI / COLUMNS;
    for (let j = 0; j < COLUMNS; j++) {
      expect(mesh.uvs[2 * j + 1]).toBeCloseTo((j + 0.5) / COLUMNS, 6);
      const angle = Math.atan2(mesh.normals[3 * j + 1]!, mesh.normals[3 * j]!);
      expect(Math.cos(angle - (2 * j + 1) * half)).toBeCloseTo(1, 6);
      expect(Math.hypot(...mesh.normals.subarray(3 * j, 3 * j + 3))).toBeCloseTo(1, 6);
    }
  });

  test('ending in the first row closes a torus, with a seam in the texture only', () => {
    const rows = Array.from({ length: 9 }, (_, i) => {
      const angle = (2 * Math.PI * (i % 8)) / 8;
      return ring(3 + Math.cos(angle), -Math.sin(angle));
    });
    const mesh = gridMesh(rows, COLUMNS, PLANE);
    expect(topology(mesh)).toMatchObject({ watertight: true, genus: 1, components: 1, degenerate: 0 });
    expect(volume(mesh)).toBeGreaterThan(0);
    expect([mesh.uvs[0], mesh.uvs[2 * 8 * (COLUMNS + 1)]]).toEqual([0, 1]);
  });

  test('u follows the length along the rows, and stands still at a crease', () => {
    const rows = [ring(1, 4), ring(1, 3), ring(1, 3, { joined: false }), ring(1, 0)];
    const { uvs } = gridMesh(rows, COLUMNS, PLANE);
    const us = [0, 1, 2, 3].map((row) => uvs[2 * row * (COLUMNS + 1)]);
    expect(us).toEqual([0, 0.25, 0.25, 1]);
  });

  test('a plane places points and turns normals', () => {
    const plane = { origin: [10, 20, 30], x: [0, 1, 0], y: [0, 0, 1] } as const;
    const flat = gridMesh(bicone, COLUMNS, PLANE);
    const placed = gridMesh(bicone, COLUMNS, plane);
    for (let i = 0; i < flat.positions.length; i += 3) {
      const [x, y, z] = flat.positions.subarray(i, i + 3);
      expect([...placed.positions.subarray(i, i + 3)]).toEqual([10 + z!, 20 + x!, 30 + y!].map(Math.fround));
      expect(placed.normals[i + 1]).toBe(flat.normals[i]);
    }
    expect(volume(placed)).toBeCloseTo(volume(flat), 4);
  });

  test('columns that run together lose their triangles and stay closed', () => {
    const rows = [ring(0, 1), ring(1, 0), ring(0, -1)].map((row, i) => {
      const points = row.points.slice();
      if (i === 1) points.copyWithin(3, 0, 3);
      return { ...row, points };
    });
    expect(topology(gridMesh(rows, COLUMNS, PLANE))).toMatchObject({ watertight: true, degenerate: 0 });
  });

  test('rows in one place make no triangles', () => {
    expect(gridMesh([ring(1, 0), ring(1, 0)], COLUMNS, PLANE).indices).toHaveLength(0);
    expect(gridMesh([], COLUMNS, PLANE).indices).toHaveLength(0);
  });

  test('flipped rows face the other way, poles too', () => {
    const flipped = gridMesh(
      bicone.map((row) => ({ ...row, flipped: true })),
      COLUMNS,
      PLANE,
    );
    const mesh = gridMesh(bicone, COLUMNS, PLANE);
    expect(topology(flipped)).toMatchObject({ watertight: true, genus: 0, components: 1, degenerate: 0 });
    expect(volume(flipped)).toBe(-volume(mesh));
    // the vertex of a pole is still the one between the columns of its triangle
    const tips = (indices: Uint32Array) => [...indices].filter((i) => i < COLUMNS).sort((a, b) => a - b);
    expect(tips(flipped.indices)).toEqual(tips(mesh.indices));
  });
});

describe('columns', () => {
  /** a gable over the edges of a strip: its ridge is a crease along the rows */
  const columns: Columns = { vs: [0, 0.5, 0.5, 1], joined: [false, true, false, true] };
  const gable = (y: number, joined = true): Row => ({
    points: Float64Array.from([-1, y, 0, 0, y, 1, 0, y, 1, 1, y, 0]),
    normals: Float64Array.from([-0.6, 0, 0.8, -0.6, 0, 0.8, 0.6, 0, 0.8, 0.6, 0, 0.8]),
    joined,
  });

  test('an open sheet is open, its crease closed, with a normal for either side', () => {
    const mesh = gridOf([gable(2), gable(0)], columns, PLANE);
    expect(mesh.indices).toHaveLength(4 * 3);
    expect(topology(mesh)).toMatchObject({ badEdges: 6, components: 1, degenerate: 0 });
    expect([...mesh.positions.subarray(3, 6)]).toEqual([...mesh.positions.subarray(6, 9)]);
    expect([mesh.normals[3], mesh.normals[6]]).toEqual([-0.6, 0.6].map(Math.fround));
    expect([...mesh.uvs].filter((_, i) => i % 2 === 1)).toEqual([0, 0.5, 0.5, 1, 0, 0.5, 0.5, 1]);
  });

  test('a tip of an open sheet does not mix normals across its crease', () => {
    const tip: Row = { ...gable(0), points: new Float64Array(12), pole: true };
    const { normals, uvs, indices } = gridOf([gable(2), tip], columns, PLANE);
    expect(indices).toHaveLength(2 * 3);
    expect([normals[12], normals[18]]).toEqual([-0.6, 0.6].map(Math.fround));
    expect([uvs[9], uvs[13]]).toEqual([0.25, 0.75]);
  });

  test('the texture runs along by the middles of quads: a crease counts once', () => {
    const far: Row = { ...gable(0), points: gable(0).points.map((x, i) => (i % 3 === 1 ? -i : x)) };
    const rows = [gable(1), gable(0), far];
    const us = [0, 1, 2].map((i) => gridOf(rows, columns, PLANE).uvs[8 * i]!);
    // ways of the entries 1, 4, 7, 10: quads go (1 + 4)/2 and (7 + 10)/2
    expect(us[1]).toBeCloseTo(1 / (1 + (2.5 + 8.5) / 2), 6);
    expect(us[2]).toBe(1);
  });
});
