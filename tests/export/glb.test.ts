/** GLB: Khronos' validator finds nothing to say, and an independent reader finds the same solids, in metres. */
import { validateBytes } from 'gltf-validator';
import { describe, expect, it } from 'vitest';
import { glb } from '../../src/export/glb.ts';
import type { Model } from '../../src/export/index.ts';
import { box, soup } from '../mesh/solids.ts';
import { ballAndTube, EMPTY, namedBoxes, PAINT, painted, solidOf } from './models.ts';
import { cornersOf, dot, measured, openEdges, readGlb, readGltf } from './readers.ts';

async function written(model: Model): Promise<Uint8Array> {
  const [file, ...more] = await glb.write(model);
  expect(more).toEqual([]);
  return file!.bytes;
}

/** Errors and warnings. (What is only remarked is that no picture uses the texture coordinates yet.) */
async function complaints(bytes: Uint8Array): Promise<string[]> {
  const { issues } = await validateBytes(bytes, { maxIssues: 0 });
  expect(issues.truncated).toBe(false);
  return issues.messages
    .filter(({ severity }) => severity < 2)
    .map(({ code, message, pointer }) => `${code} ${pointer}: ${message}`);
}

describe('glb', () => {
  it('is the same solids in metres, a node a part', async () => {
    const model = ballAndTube();
    const parts = readGlb(await written(model));
    expect(parts.map(({ name }) => name)).toEqual(['Rotational 1', 'Tube 2']);
    parts.forEach((part, i) => {
      const { mesh } = model.solids[i]!;
      const wrong = part.positions.flat().filter((x, k) => {
        const metres = mesh.positions[k]! / 1000;
        return Math.abs(x - metres) > 1.2e-7 * Math.abs(metres);
      });
      expect(wrong).toEqual([]);
      expect(part.triangles.flat().join()).toBe(mesh.indices.join());
      expect(openEdges(cornersOf(part))).toBe(0);
    });
  });

  it('is a ball of 50 mm', async () => {
    const [ball] = readGlb(await written(ballAndTube()));
    const { volume, area, min, max } = measured(cornersOf(ball!));
    expect(Math.abs(volume / ((4 / 3) * Math.PI * 0.05 ** 3) - 1)).toBeLessThan(0.01);
    expect(Math.abs(area / (4 * Math.PI * 0.05 ** 2) - 1)).toBeLessThan(0.01);
    for (const value of [...min.map((x) => -x), ...max]) expect(Math.abs(value - 0.05)).toBeLessThan(0.0005);
  });

  it('has outward unit normals, and texture coordinates counted from above', async () => {
    const model = ballAndTube();
    const [ball] = readGlb(await written(model));
    const inward = ball!.normals.filter((n, i) => dot(n, ball!.positions[i]!) <= 0);
    expect(inward).toEqual([]);
    expect(ball!.normals.filter((n) => Math.abs(dot(n, n) - 1) > 1e-5)).toEqual([]);
    const { uvs } = model.solids[0]!.mesh;
    const turned = (value: number, i: number) => (i % 2 ? 1 - value : value);
    expect(ball!.uvs.flat().filter((value, i) => Math.abs(value - turned(uvs[i]!, i)) > 1e-7)).toEqual([]);
  });

  it('has matt colours, linear', async () => {
    const { json } = readGltf(await written(ballAndTube()));
    const [red] = json.materials!.map(({ pbrMetallicRoughness }) => pbrMetallicRoughness);
    const linear = [0xc8, 0x3c, 0x28].map((value) => ((value / 255 + 0.055) / 1.055) ** 2.4);
    linear.forEach((value, k) => {
      expect(Math.abs(red!.baseColorFactor![k]! - value)).toBeLessThan(1e-12);
    });
    expect(red).toMatchObject({ metallicFactor: 0 });
    expect(red!.roughnessFactor).toBeGreaterThan(0.5);
    expect(json.asset).toEqual({ generator: 'Rotund', version: '2.0' });
  });

  it('has the light of painted vertices, over white', async () => {
    const [plain, body] = readGlb(await written(painted()));
    expect(plain!.paint).toEqual([]);
    expect(body!.colour).toEqual([1, 1, 1, 1]);
    body!.paint.forEach((rgb, i) => {
      expect(rgb).toEqual(PAINT[i % 3]!.map(Math.fround));
    });
    expect(body!.paint).toHaveLength(body!.positions.length);
  });

  const FLAT = soup(
    [
      [0, 0, 0],
      [1, 0, 0],
      [2, 0, 0],
      [0, 1, 0],
    ],
    [
      [0, 1, 2],
      [0, 1, 3],
    ],
  );

  const models: Readonly<Record<string, () => Model>> = {
    'ball and tube': ballAndTube,
    'odd names': () =>
      namedBoxes(['<script>', 'a\nb', '#', '', 'same', 'same', '\ud800', '"quoted"', '\u0000']),
    nothing: () => EMPTY,
    'painted by vertex': painted,
    'a part without triangles': () => ({
      name: 'x',
      solids: [solidOf('none', soup([], [])), solidOf('box')],
    }),
    'a triangle in line': () => ({ name: 'x', solids: [solidOf('flat', FLAT)] }),
    'a normal without direction': () => {
      const mesh = box(1, 1, 1);
      return { name: 'x', solids: [solidOf('box', { ...mesh, normals: mesh.normals.map(() => 0) })] };
    },
    'a normal that is no number': () => {
      const mesh = box(1, 1, 1);
      return { name: 'x', solids: [solidOf('box', { ...mesh, normals: mesh.normals.map(() => NaN) })] };
    },
    'black, white and capital letters': () => ({
      name: 'x',
      solids: [solidOf('a', box(1, 1, 1), '#000000'), solidOf('b', box(1, 1, 1), '#FFFFFF')],
    }),
    'more than 65,535 vertices': () => {
      const points = Array.from({ length: 22_000 }, (_, i) => [i % 100, Math.floor(i / 100), i % 3]);
      const triangles = points.slice(2).map((_, i) => [i, i + 1, i + 2]);
      return { name: 'x', solids: [solidOf('many', soup(points, triangles))] };
    },
  };
  for (const [name, model] of Object.entries(models)) {
    it(`satisfies the validator without error or warning: ${name}`, async () => {
      expect(await complaints(await written(model()))).toEqual([]);
    }, 30_000);
  }
});
