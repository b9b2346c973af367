/** What the private seam leans on in three.js. Another version has to be looked at, with e2e/scene/device.spec.ts, before it is pinned here. */
import { readFileSync } from 'node:fs';
import { REVISION } from 'three/webgpu';
import { expect, test } from 'vitest';

const read = (path: string) => readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8');

test('three.js is the one that the seam was made for', () => {
  expect(REVISION).toBe('187');
  const { dependencies, devDependencies } = JSON.parse(read('package.json'));
  expect([dependencies.three, devDependencies['@types/three']]).toEqual(['0.187.0', '0.187.0']);
});

test('an attribute whose record has a buffer gets no other one', () => {
  const attributes = read('node_modules/three/src/renderers/webgpu/utils/WebGPUAttributeUtils.js');
  expect(attributes).toMatch(/let buffer = bufferData\.buffer;\s+if \( buffer === undefined \)/);
  const geometries = read('node_modules/three/src/renderers/common/Geometries.js');
  expect(geometries).toContain('const indirect = renderObject.geometry.indirect;');
});
