/** Triangles whose evenly spaced places sent the constrained triangulation round in circles: cut into ears their skeleton ran along an edge. */
import { expect, it } from 'vitest';
import { kernelNamed } from '../../src/kernel/index.ts';
import type { Vec2 } from '../../src/math/vec.ts';
import { silhouetteOf } from '../../src/skeleton/medial/silhouette.ts';
import { outlineError } from '../skeleton/medial/outlineError.ts';

const TRIANGLES: readonly (readonly Vec2[])[] = [
  [
    [24.06988483853638, 28.849843069911003],
    [28.854729852173477, 27.284793206490576],
    [15.719126262702048, 4.9139749724417925],
  ],
  [
    [2.2875795559957623, 0.8180980919860303],
    [9.530975371599197, 5.528798277955502],
    [21.19326809188351, 28.95587136503309],
  ],
];

it.each(TRIANGLES.map((loop, i) => [i, loop] as const))('triangle %i is followed', (_, loop) => {
  const cauchy = kernelNamed('cauchy')!;
  const { skels, params } = silhouetteOf([loop], cauchy, {}, 1)!;
  expect(outlineError(skels, [loop], cauchy, params, 1).mean).toBeLessThan(0.005);
});
