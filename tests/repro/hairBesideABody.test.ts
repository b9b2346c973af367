/**
 * Scribbles one of whose pieces is a hair. Of 3677 it is 18.5 mm long and 0.007 mm wide: pruned against the circles of all pieces, its skeleton
 * came down to one circle at a tip. Of 4727 it has most of the eighty circles, and the body beside it was left with six.
 */
import { expect, it } from 'vitest';
import { kernelNamed } from '../../src/kernel/index.ts';
import { bindSkel } from '../../src/skeleton/index.ts';
import { sizeOf, spaced } from '../../src/skeleton/medial/outline.ts';
import { silhouetteOf } from '../../src/skeleton/medial/silhouette.ts';
import { anySilhouette } from '../skeleton/medial/anySilhouette.ts';

it.each([
  [3677, 1],
  [4727, 0],
])('scribble %i is followed around its piece %i', (seed, piece) => {
  const { loops } = anySilhouette(seed);
  expect(loops).toHaveLength(4);
  const cauchy = kernelNamed('cauchy')!;
  const { skels, params } = silhouetteOf(loops, cauchy, {}, 1)!;
  const fields = skels.map((skel) => bindSkel(skel, cauchy, params));
  const offs = spaced([loops[piece]!], 40)[0]!.map(([x, y]) => {
    const out = new Float64Array(4);
    for (const field of fields) field.add(x, y, 0, 1, out);
    return Math.abs(out[0]! - 1) / Math.hypot(out[1]!, out[2]!);
  });
  // to first order; they were 18 and 4 times the size of the whole
  expect(Math.max(...offs)).toBeLessThan(0.03 * sizeOf(loops));
});
