/** Materials of files: what a finish becomes where others read it. */
import { describe, expect, it } from 'vitest';
import { DEFAULT_FINISH, type Finish } from '../../src/document/finish.ts';
import { glb } from '../../src/export/glb.ts';
import { materialsOf, metalnessOf, roughnessOf } from '../../src/export/material.ts';
import { obj } from '../../src/export/obj.ts';
import { solidOf } from './models.ts';
import { asText, readGltf } from './readers.ts';

const METAL: Finish = { ambient: 0.5, diffuse: 1.2, specular: 1, shininess: 20 };
const GLOSS: Finish = { ambient: 1, diffuse: 1, specular: 0.8, shininess: 100 };
const dressed = (name: string, finish: Finish) => ({ ...solidOf(name), finish });
const model = {
  name: 'x',
  solids: [
    dressed('a', DEFAULT_FINISH),
    dressed('b', METAL),
    dressed('c', { ...METAL }),
    dressed('d', GLOSS),
  ],
};

describe('materials', () => {
  it('are shared by parts that look alike, and by no others', () => {
    const names = materialsOf(model.solids).map(({ name }) => name);
    expect(names).toEqual(['colour_808080', 'colour_808080_1', 'colour_808080_1', 'colour_808080_2']);
  });

  it('are clay where nobody set anything, metal on a dark ground, smooth where highlights are sharp', () => {
    expect([metalnessOf(DEFAULT_FINISH), roughnessOf(DEFAULT_FINISH)]).toEqual([0, 0.8]);
    expect(metalnessOf(METAL)).toBeGreaterThan(0.9);
    expect(metalnessOf(GLOSS)).toBe(0);
    expect(roughnessOf(GLOSS)).toBeLessThan(0.5);
    expect(roughnessOf({ ...DEFAULT_FINISH, specular: 0 })).toBe(1);
    expect(roughnessOf({ ...GLOSS, specular: 1, shininess: 200 })).toBeGreaterThan(0);
  });

  it('are in OBJ as Phong’s terms', async () => {
    const [, library] = await obj.write(model);
    const text = asText(library!.bytes);
    const [clay, metal, gloss] = text.split('newmtl ').slice(1);
    expect(clay).toContain('Ks 0 0 0\nd 1\nillum 1');
    expect(clay).not.toContain('Ka');
    expect(metal).toContain('Ns 20\n');
    expect(metal).toContain('Ks 1 1 1\n');
    expect(metal).toContain(`Ka ${Number(((0.5 * 128) / 255).toFixed(6))} `);
    expect(metal).toContain(`Kd ${Number(((1.2 * 128) / 255).toFixed(6))} `);
    expect(gloss).toContain('illum 2');
  });

  it('are in GLB as roughness and metal', async () => {
    const [file] = await glb.write(model);
    const { json } = readGltf(file!.bytes);
    expect(json.materials).toHaveLength(3);
    const [clay, metal] = json.materials!.map(({ pbrMetallicRoughness }) => pbrMetallicRoughness!);
    expect(clay).toMatchObject({ metallicFactor: 0, roughnessFactor: 0.8 });
    expect(metal!.metallicFactor ?? 1).toBeGreaterThan(0.9);
  });
});
