import { describe, expect, test } from 'vitest';
import { emptyMesh } from '../../src/mesh/grid.ts';
import { area, bounds, eachTriangle, volume } from '../../src/mesh/measure.ts';
import { box, soup } from './solids.ts';

describe('measures', () => {
  test('of a box', () => {
    const mesh = box(2, 3, 4, [1, 1, 1]);
    expect(volume(mesh)).toBeCloseTo(24, 5);
    expect(area(mesh)).toBeCloseTo(2 * (6 + 8 + 12), 5);
    expect(bounds(mesh)).toEqual({ min: [1, 1, 1], max: [3, 4, 5] });
  });

  test('a mesh turned inside out has a negative volume', () => {
    const mesh = box(2, 3, 4);
    const indices = mesh.indices.map((_, i, all) => all[i - (i % 3) + 2 - (i % 3)]!);
    expect(volume({ ...mesh, indices })).toBeCloseTo(-24, 5);
  });

  test('a small box far away keeps its volume', () => {
    expect(volume(box(1, 1, 1, [4096, 8192, -4096]))).toBe(1);
  });

  test('nothing measures nothing', () => {
    expect(volume(emptyMesh())).toBe(0);
    expect(area(emptyMesh())).toBe(0);
    expect(bounds(emptyMesh())).toEqual({ min: [0, 0, 0], max: [0, 0, 0] });
  });

  test('eachTriangle visits corners in order', () => {
    const seen: unknown[] = [];
    const points = [
      [0, 0, 0],
      [1, 0, 0],
      [0, 2, 0],
    ];
    eachTriangle(soup(points, [[0, 1, 2]]), (...all) => seen.push(all));
    expect(seen).toEqual([[...points, 0]]);
  });
});
