/** OBJ: read back by an independent reader it is the mesh itself, bit for bit; names and materials as the format allows. */
import { describe, expect, it } from 'vitest';
import { obj } from '../../src/export/obj.ts';
import { ballAndTube, EMPTY, namedBoxes, solidOf } from './models.ts';
import { asText, bitsOf, readMtl, readObj } from './readers.ts';

const ODD_NAMES = ['<b>bold</b>', 'two\nf 1 2 3', '#', '', 'same', 'same', 'o\u2028x', 'ends in space '];

describe('obj', () => {
  it('holds every float to the bit, in millimetres, a group a part', async () => {
    const model = ballAndTube();
    const [file, library] = await obj.write(model);
    const parts = readObj(file!.bytes, library!.bytes);
    expect(parts.map(({ name }) => name)).toEqual(['Rotational_1', 'Tube_2']);
    parts.forEach((part, i) => {
      const { mesh } = model.solids[i]!;
      for (const key of ['positions', 'normals', 'uvs'] as const) {
        expect(bitsOf(part[key].flat()).equals(bitsOf(mesh[key])), key).toBe(true);
      }
      expect(part.triangles.flat().join()).toBe(mesh.indices.join());
    });
  });

  it('has a material a colour, in display values', async () => {
    const [file, library] = await obj.write(ballAndTube());
    expect(library!.name).toBe('ball_and_tube.mtl');
    expect(asText(file!.bytes)).toContain('\nmtllib ball_and_tube.mtl\n');
    expect([...readMtl(library!.bytes).keys()]).toEqual(['colour_c83c28', 'colour_2b59c3']);
    const [ball] = readObj(file!.bytes, library!.bytes);
    expect(ball!.colour.map((value) => Math.round(value * 255))).toEqual([0xc8, 0x3c, 0x28]);
    expect(asText(library!.bytes)).toContain('sRGB');
  });

  it('shares a material between parts of one colour', async () => {
    const [, library] = await obj.write({ name: 'x', solids: [solidOf('a'), solidOf('b')] });
    expect(readMtl(library!.bytes).size).toBe(1);
  });

  it('says who wrote it, in which unit and with which axes, but not when', async () => {
    const [file] = await obj.write(ballAndTube());
    const comments = asText(file!.bytes)
      .split('\n')
      .filter((line) => line.startsWith('#'));
    expect(comments.join('\n')).toMatch(/Rotund[\s\S]*millimetre[\s\S]*y up/);
    expect(comments.join('\n')).not.toMatch(/\d{4}/);
  });

  it('turns any name into one distinct word', async () => {
    const [file, library] = await obj.write(namedBoxes(ODD_NAMES));
    const parts = readObj(file!.bytes, library!.bytes);
    expect(parts).toHaveLength(ODD_NAMES.length);
    expect(new Set(parts.map(({ name }) => name)).size).toBe(ODD_NAMES.length);
    for (const { name, triangles } of parts) {
      expect(name).toMatch(/^[^\s#<>]+$/);
      expect(triangles).toHaveLength(12);
    }
  });

  it('names files so that every system and reader takes them', async () => {
    const { solids } = ballAndTube();
    const [file, library] = await obj.write({ name: '../a b#/c\n', solids });
    expect(file!.name).toBe('-a b#-c-.obj');
    expect(library!.name).toBe('-a_b_-c-.mtl');
    expect(asText(file!.bytes)).toContain(`\nmtllib ${library!.name}\n`);
  });

  it('of nothing is a valid file without groups', async () => {
    const [file, library] = await obj.write(EMPTY);
    expect(readObj(file!.bytes, library!.bytes)).toEqual([]);
  });
});
