/** PLY: read back by its own header it is the mesh itself, with normals and the parts' colours. */
import { describe, expect, it } from 'vitest';
import { ply } from '../../src/export/ply.ts';
import { ballAndTube, EMPTY, PAINT, painted } from './models.ts';
import { bitsOf, readPly } from './readers.ts';

describe('ply', () => {
  it('holds every float to the bit, in millimetres, all parts in one', async () => {
    const model = ballAndTube();
    const [file, ...more] = await ply.write(model);
    expect(more).toEqual([]);
    expect(file!.name).toBe('ball and tube.ply');
    const read = readPly(file!.bytes);
    for (const key of ['positions', 'normals'] as const) {
      const joined = model.solids.flatMap(({ mesh }) => [...mesh[key]]);
      expect(bitsOf(read[key].flat()).equals(bitsOf(joined)), key).toBe(true);
    }
    const first = model.solids[0]!.mesh;
    const offset = first.positions.length / 3;
    const second = Array.from(model.solids[1]!.mesh.indices, (i) => i + offset);
    expect(read.triangles.flat().join()).toBe([...first.indices, ...second].join());
  });

  it('gives every vertex the colour of its part', async () => {
    const model = ballAndTube();
    const [file] = await ply.write(model);
    const { colours } = readPly(file!.bytes);
    const border = model.solids[0]!.mesh.positions.length / 3;
    expect(new Set(colours.slice(0, border).map(String))).toEqual(new Set(['200,60,40']));
    expect(new Set(colours.slice(border).map(String))).toEqual(new Set(['43,89,195']));
  });

  it('gives painted vertices their own', async () => {
    const { solids } = painted();
    const [file] = await ply.write(painted());
    const { colours } = readPly(file!.bytes);
    const first = solids[0]!.mesh.positions.length / 3;
    expect(new Set(colours.slice(0, first).map(String))).toEqual(new Set(['128,128,128']));
    colours.slice(first).forEach((rgb, i) => {
      const shown = PAINT[i % 3]!.map((x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
      expect(rgb).toEqual(shown.map((x) => Math.round(255 * x)));
    });
  });

  it('says who wrote it, in which unit and with which axes', async () => {
    const [file] = await ply.write(ballAndTube());
    const { header } = readPly(file!.bytes);
    expect(header.slice(0, 2)).toEqual(['ply', 'format binary_little_endian 1.0']);
    expect(header.filter((line) => line.startsWith('comment')).join(' ')).toMatch(/Rotund.*millimetre.*y up/);
  });

  it('of nothing is a valid file without vertices', async () => {
    const [file] = await ply.write(EMPTY);
    expect(readPly(file!.bytes)).toMatchObject({ positions: [], triangles: [] });
  });
});
