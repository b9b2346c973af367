/**
 * A scribble one of whose four pieces is a hair, 18.5 mm long and 0.007 mm wide: pruned against the circles of all pieces, its skeleton came
 * down to one circle at a tip, and nothing was where it had been drawn.
 */
import { expect, it } from 'vitest';
import { kernelNamed } from '../../src/kernel/index.ts';
import type { Vec2 } from '../../src/math/vec.ts';
import { bindSkel } from '../../src/skeleton/index.ts';
import { sizeOf, spaced } from '../../src/skeleton/medial/outline.ts';
import { silhouetteOf } from '../../src/skeleton/medial/silhouette.ts';
import { anySilhouette } from '../skeleton/medial/anySilhouette.ts';

const SEED = 3677;

it(`the hair of scribble ${SEED} is followed`, () => {
  const { loops } = anySilhouette(SEED);
  const hair: readonly Vec2[] = loops[1]!;
  expect(loops).toHaveLength(4);
  const cauchy = kernelNamed('cauchy')!;
  const { skels, params } = silhouetteOf(loops, cauchy, {}, 1)!;
  const fields = skels.map((skel) => bindSkel(skel, cauchy, params));
  const offs = spaced([hair], 20)[0]!.map(([x, y]) => {
    const out = new Float64Array(4);
    for (const field of fields) field.add(x, y, 0, 1, out);
    return Math.abs(out[0]! - 1) / Math.hypot(out[1]!, out[2]!);
  });
  // mm, to first order; it was 18 times the size of the whole
  expect(Math.max(...offs)).toBeLessThan(0.015 * sizeOf(loops));
});
