/** Surfaces of fitted skels against the outlines that they were made from. */
import { describe, expect, it } from 'vitest';
import { kernelNamed } from '../../../src/kernel/index.ts';
import { bindSkel } from '../../../src/skeleton/index.ts';
import { neighboursOf } from '../../../src/skeleton/medial/branches.ts';
import { FITTING } from '../../../src/skeleton/medial/fit.ts';
import { infer, inferPaper } from '../../../src/skeleton/medial/infer.ts';
import { distanceTo } from '../../../src/skeleton/medial/outline.ts';
import { silhouetteOf, silhouetteSkels, skeletonOf } from '../../../src/skeleton/medial/silhouette.ts';
import type { Skel } from '../../../src/skeleton/skels.ts';
import { blob, disc, plate, SHAPES, stadium } from '../../fixtures/silhouettes.ts';
import { outlineError } from './outlineError.ts';

const cauchy = kernelNamed('cauchy')!;
const quartic = kernelNamed('quartic')!;
const fitted = (loops: Parameters<typeof skeletonOf>[0], kernel = cauchy, options = FITTING) => {
  const found = silhouetteSkels(skeletonOf(loops), loops, kernel, initial(kernel), 1, options);
  return { ...found, error: outlineError(found.skels, loops, kernel, found.params, 1) };
};
const initial = ({ params }: typeof cauchy) => Object.fromEntries(params.map(({ name }) => [name, 1]));

describe('fitWeights', () => {
  it('a circle gives a sphere within 1 %', () => {
    const { skels, error } = fitted([disc(30)]);
    expect(skels.map(({ type }) => type)).toEqual(['point']);
    expect(error.most).toBeLessThan(0.01);
  });

  it('a stadium is followed within 0.7 %', () => {
    expect(fitted([stadium(30, 10)]).error.most).toBeLessThan(0.007);
  });

  it.each([0, 1, 2, 3])('a plate with %i holes is followed within 0.7 %', (holes) => {
    expect(fitted(holes === 0 ? [stadium(30, 16)] : plate(holes)).error.most).toBeLessThan(0.007);
  });

  it('detail comes where the outline asks for it: none of twelve forms is off by more than 1 % in the mean', () => {
    const means = [...Object.values(SHAPES), [blob(1)], [blob(6)]].map((loops) => {
      const { skels, params } = silhouetteOf(loops, cauchy, initial(cauchy), 1)!;
      return outlineError(skels, loops, cauchy, params, 1).mean;
    });
    for (const mean of means) expect(mean).toBeLessThan(0.01);
    expect(means.reduce((a, b) => a + b, 0) / means.length).toBeLessThan(0.004);
  });

  it('there is none where the outline holds nothing', () => {
    expect(
      silhouetteOf(
        [
          [
            [0, 0],
            [1, 1],
            [2, 2],
          ],
        ],
        cauchy,
        initial(cauchy),
        1,
      ),
    ).toBeNull();
  });

  it('is nearer than weights that each segment infers by itself, the paper’s and ours', () => {
    const sums = { fit: 0, ours: 0, paper: 0 };
    for (const loops of Object.values(SHAPES)) {
      const { error, params } = fitted(loops);
      const graph = skeletonOf(loops);
      const of = (skels: readonly Skel[]) => outlineError(skels, loops, cauchy, params, 1).mean;
      sums.fit += error.mean;
      sums.ours += of(infer(graph, cauchy, params, 1));
      sums.paper += of(inferPaper(graph, cauchy, params, 1));
    }
    expect(sums.fit).toBeLessThan(0.3 * sums.ours);
    expect(sums.fit).toBeLessThan(0.3 * sums.paper);
  });

  it('moves of nodes make a ring’s mean error a tenth', () => {
    const still = fitted(SHAPES.ring!, cauchy, { ...FITTING, move: 0 });
    expect(fitted(SHAPES.ring!).error.mean).toBeLessThan(0.1 * still.error.mean);
  });

  it('a kernel with a support follows a stadium within 0.7 % and a circle within 1 %', () => {
    expect(fitted([stadium(30, 10)], quartic).error.most).toBeLessThan(0.007);
    expect(fitted([disc(30)], quartic).error.most).toBeLessThan(0.01);
  });

  it.each(['star', 'cross', 'box', 'hand', 'plate with two holes'])(
    '%s: at joints the surface is as thick as the form is wide, and no bulge',
    (name) => {
      const loops = SHAPES[name]!;
      const { graph, skels, params } = silhouetteOf(loops, cauchy, initial(cauchy), 1)!;
      const fields = skels.map((skel) => bindSkel(skel, cauchy, params));
      const thick = graph.nodes.map(({ at }) => {
        let [low, high] = [0, 100];
        for (let i = 0; i < 40; i++) {
          const z = (low + high) / 2;
          if (fields.reduce((sum, field) => sum + field.value(at[0], at[1], z), 0) > 1) low = z;
          else high = z;
        }
        return low / distanceTo(at, loops);
      });
      neighboursOf(graph).forEach((others, joint) => {
        if (others.length < 3) return;
        const around = Math.max(1, ...others.map((other) => thick[other]!));
        expect(thick[joint]!).toBeGreaterThan(0.7);
        expect(thick[joint]!).toBeLessThan(1.05 * around);
      });
    },
  );

  it('quick ones are nearly as near', () => {
    const errors = [...Object.values(SHAPES), [blob(1)], [blob(6)]].map((loops) => {
      const { skels, params } = silhouetteOf(loops, cauchy, initial(cauchy), 1, { quick: true })!;
      return outlineError(skels, loops, cauchy, params, 1).mean;
    });
    expect(errors.reduce((a, b) => a + b, 0) / errors.length).toBeLessThan(0.012);
  });

  it('a width that is given stays', () => {
    const found = silhouetteOf(SHAPES.star!, cauchy, { s: 0.1 }, 1, { width: 'given' })!;
    expect(found.params).toEqual({ s: 0.1 });
  });

  it.each([11, 12, 13])(
    'weights are within their bounds, and nothing is not a number (blob, seed %i)',
    (seed) => {
      const { relative, skels, ratio, atBound } = fitted([blob(seed)]);
      for (const weight of relative) expect(weight >= 0 && weight <= FITTING.high).toBe(true);
      expect(ratio).toBeGreaterThanOrEqual(1);
      expect(atBound).toBeLessThanOrEqual(1);
      expect(
        skels
          .flatMap((skel) => Object.values(skel).flat())
          .every((v) => typeof v === 'string' || Number.isFinite(v)),
      ).toBe(true);
    },
  );
});
