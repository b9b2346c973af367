import { describe, expect, test } from 'vitest';
import { topology } from '../../src/mesh/check.ts';
import { emptyMesh } from '../../src/mesh/grid.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { box, soup, union } from './solids.ts';

/** A torus of n × m quads: the plain identification of a rectangle's sides. */
function torus(n: number, m: number): Mesh {
  const points = Array.from({ length: n * m }, (_, i) => {
    const [a, b] = [(2 * Math.PI * Math.floor(i / m)) / n, (2 * Math.PI * (i % m)) / m];
    const r = 3 + Math.cos(b);
    return [r * Math.cos(a), r * Math.sin(a), Math.sin(b)];
  });
  const triangles = points.flatMap((_, i) => {
    const [a, b] = [Math.floor(i / m), i % m];
    const [c, d] = [(a + 1) % n, (b + 1) % m];
    const [p, q, r, s] = [a * m + b, c * m + b, c * m + d, a * m + d];
    return [
      [p, q, r],
      [p, r, s],
    ];
  });
  return soup(points, triangles);
}

describe('topology', () => {
  test('of a box', () => {
    expect(topology(box(1, 2, 3))).toEqual({
      watertight: true,
      badEdges: 0,
      euler: 2,
      genus: 0,
      components: 1,
      degenerate: 0,
      finite: true,
    });
  });

  test('of a torus', () => {
    expect(topology(torus(5, 7))).toMatchObject({ watertight: true, euler: 0, genus: 1, components: 1 });
  });

  test('genus is summed over components', () => {
    const mesh = union(torus(4, 4), box(1, 1, 1, [10, 0, 0]), torus(3, 5), box(1, 1, 1, [20, 0, 0]));
    expect(topology(mesh)).toMatchObject({ watertight: true, euler: 4, genus: 1 + 1, components: 4 });
  });

  test('boxes that touch in a corner are two', () => {
    const mesh = union(box(1, 1, 1), box(1, 1, 1, [1, 1, 1]));
    expect(topology(mesh)).toMatchObject({ watertight: true, euler: 4, genus: 0, components: 2 });
  });

  test('boxes that share an edge are not watertight there', () => {
    const mesh = union(box(1, 1, 1), box(1, 1, 1, [1, 1, 0]));
    expect(topology(mesh)).toMatchObject({ watertight: false, badEdges: 1, genus: Number.NaN });
  });

  test('a missing triangle leaves three bad edges', () => {
    const mesh = box(1, 1, 1);
    expect(topology({ ...mesh, indices: mesh.indices.slice(3) })).toMatchObject({
      watertight: false,
      badEdges: 3,
    });
  });

  test('a triangle the wrong way round spoils its three edges', () => {
    const mesh = box(1, 1, 1);
    const indices = mesh.indices.slice();
    [indices[0], indices[1]] = [indices[1]!, indices[0]!];
    expect(topology({ ...mesh, indices })).toMatchObject({ watertight: false, badEdges: 3 });
  });

  test('triangles without area are counted', () => {
    const points = [
      [0, 0, 0],
      [1, 0, 0],
      [2, 0, 0],
      [0, 1, 0],
    ];
    expect(
      topology(
        soup(points, [
          [0, 1, 2],
          [0, 0, 3],
          [0, 1, 3],
        ]),
      ).degenerate,
    ).toBe(2);
  });

  test('numbers that are none are found wherever they are', () => {
    for (const key of ['positions', 'normals', 'uvs'] as const) {
      for (const value of [Number.NaN, Infinity]) {
        const mesh = box(1, 1, 1);
        mesh[key][4] = value;
        expect(topology(mesh).finite).toBe(false);
      }
    }
  });

  test('nothing is watertight and has no components', () => {
    expect(topology(emptyMesh())).toMatchObject({ watertight: true, euler: 0, genus: 0, components: 0 });
  });
});
