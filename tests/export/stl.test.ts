/** STL: read back it is the same closed surface; facet normals are those of the triangles. */
import { describe, expect, it } from 'vitest';
import { stl } from '../../src/export/stl.ts';
import { soup } from '../mesh/solids.ts';
import { ballAndTube, EMPTY, solidOf } from './models.ts';
import { bitsOf, dot, measured, openEdges, readStl } from './readers.ts';

describe('stl', () => {
  it('holds every triangle to the bit, in millimetres', async () => {
    const model = ballAndTube();
    const [file, ...more] = await stl.write(model);
    expect(more).toEqual([]);
    expect(file!.name).toBe('ball and tube.stl');
    const { facets } = readStl(file!.bytes);
    const expected = model.solids.flatMap(({ mesh }) =>
      Array.from(mesh.indices, (i) => [...mesh.positions.slice(3 * i, 3 * i + 3)]).flat(),
    );
    expect(bitsOf(facets.flatMap(({ corners }) => corners.flat())).equals(bitsOf(expected))).toBe(true);
    expect(openEdges(facets.map(({ corners }) => corners))).toBe(0);
  });

  it('has unit normals that face as the triangles do', async () => {
    const [file] = await stl.write(ballAndTube());
    const wrong = readStl(file!.bytes).facets.filter(({ normal, corners }) => {
      const { area } = measured([corners]);
      // The tetrahedron over the triangle with its apex one behind it has a third of the area as volume.
      const apex = corners[0]!.map((x, k) => x - normal[k]!);
      const shifted = corners.map((corner) => corner.map((x, k) => x - apex[k]!));
      const faces = Math.abs(measured([shifted]).volume / (area / 3) - 1) < 1e-3;
      return !faces || Math.abs(dot(normal, normal) - 1) > 1e-6;
    });
    expect(wrong).toEqual([]);
  });

  it('begins as no text file does', async () => {
    const [file] = await stl.write(ballAndTube());
    const { header } = readStl(file!.bytes);
    expect(header).toMatch(/^Rotund.*millimetre.*y up/);
    expect(header.toLowerCase().startsWith('solid')).toBe(false);
  });

  it('keeps a triangle in line, with the normal 0 0 0', async () => {
    const points = [
      [0, 0, 0],
      [1, 0, 0],
      [2, 0, 0],
    ];
    const [file] = await stl.write({ name: 'x', solids: [solidOf('line', soup(points, [[0, 1, 2]]))] });
    const { facets } = readStl(file!.bytes);
    expect(facets).toEqual([{ normal: [0, 0, 0], corners: points }]);
  });

  it('of nothing is a valid file without triangles', async () => {
    const [file] = await stl.write(EMPTY);
    expect(readStl(file!.bytes).facets).toEqual([]);
  });
});
