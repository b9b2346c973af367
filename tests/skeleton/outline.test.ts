/** Chords instead of far edges change nothing: a polygon is the sum of its triangles, over its corners and edges too. */
import { expect, it } from 'vitest';
import { kernelNamed } from '../../src/kernel/index.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { bound } from '../bench/timing.ts';
import { edgesOfTriangles } from '../bench/triangulated.ts';
import { POLYGONS } from '../fixtures/polygons.ts';
import { random } from '../fixtures/random.ts';

const SEED = 3;
const quartic = kernelNamed('quartic')!;

it.each(Object.entries(POLYGONS))(`the %s is the sum of its triangles (seed ${SEED})`, (_, skel) => {
  const whole = bound(skel, quartic);
  const triangles = edgesOfTriangles(skel, quartic);
  const next = random(SEED);
  const around = (): Vec3 => [13 * next() - 6.5, 13 * next() - 6.5, 3 * next() - 1.5];
  const over = skel.loops[0]!.flatMap(([x, y], i): Vec3[] => {
    const [px, py] = skel.loops[0]!.at(i - 1)!;
    return [
      [x, y, 0.25],
      [0.5 * (x + px), 0.5 * (y + py), -0.5],
    ];
  });
  for (const [x, y, z] of [...over, ...Array.from({ length: 500 }, around)]) {
    const sum = [0, 0, 0, 0];
    for (const field of triangles) {
      const out = new Float64Array(4);
      field.add(x, y, z, 1, out);
      out.forEach((part, k) => {
        sum[k]! += part;
      });
    }
    const out = new Float64Array(4);
    whole.add(x, y, z, 1, out);
    expect(Math.max(...sum.map((part, k) => Math.abs(out[k]! - part)))).toBeLessThan(2e-14);
  }
});

it('is nothing beyond its support', () => {
  const field = bound(POLYGONS.star, quartic);
  expect(field.value(6, 0, 0)).toBe(0);
  expect(field.value(0, 0, 1.2)).toBe(0);
});
