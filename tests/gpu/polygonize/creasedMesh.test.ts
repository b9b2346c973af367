/** Meshes with creases as they come from the device, put in order. */
import { expect, it } from 'vitest';
import { creasedMesh, type Written } from '../../../src/gpu/polygonize/creasedMesh.ts';

/** Vertices by place and fan; colours and normals say which they were. */
function written(
  rows: readonly (readonly [x: number, y: number, z: number, fan: number])[],
  indices: number[],
) {
  const numbers = (of: (row: (typeof rows)[number], i: number) => readonly number[]) =>
    Float32Array.from(rows.flatMap((row, i) => of(row, i)));
  return {
    positions: numbers(([x, y, z]) => [x, y, z]),
    normals: numbers((_, i) => [i, 0, 0]),
    colours: numbers((_, i) => [0, i, 0]),
    fans: numbers(([, , , fan]) => [fan]),
    indices: Uint32Array.from(indices),
  } satisfies Written;
}

it('leaves out triangles and vertices that are none, and keeps the order of the others', () => {
  const mesh = creasedMesh(
    written(
      [
        [0, 0, 0, 0],
        [9, 9, 9, 0],
        [1, 0, 0, 3],
        [0, 1, 0, -1],
        [7, 7, 7, -2],
        [0, 0, 1, 0],
      ],
      [0, 0, 0, 5, 2, 3, 2, 2, 3, 0, 3, 2, 3, 0, 3],
    ),
  );
  expect([...mesh.indices]).toEqual([3, 1, 2, 0, 2, 1]);
  expect([...mesh.positions]).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
  expect([...mesh.normals].filter((_, i) => i % 3 === 0)).toEqual([0, 2, 3, 5]);
  expect([...mesh.colours].filter((_, i) => i % 3 === 1)).toEqual([0, 2, 3, 5]);
});

it('moves points on creases apart that are in one place, all vertices of one together', () => {
  const corner = [1, -2, 0.5] as const;
  const { positions } = creasedMesh(
    written(
      [
        [...corner, 0],
        [...corner, -2],
        [...corner, -2],
        [...corner, -3],
        [...corner, -3],
        [...corner, -4],
        [0, 0, 0, 0],
      ],
      [0, 1, 2, 3, 4, 5, 0, 1, 6],
    ),
  );
  const at = (v: number) => [...positions.subarray(3 * v, 3 * v + 3)];
  expect(at(1)).toEqual(at(2));
  expect(at(3)).toEqual(at(4));
  expect(new Set([1, 3, 5].map((v) => at(v).join(' '))).size).toBe(3);
  for (let v = 0; v < 6; v++) {
    at(v).forEach((x, axis) => {
      expect(Math.abs(x - corner[axis]!)).toBeLessThan(1e-6);
    });
  }
});
