/** What the styles are told of a finish. */
import { describe, expect, it } from 'vitest';
import { DEFAULT_FINISH } from '../../src/document/finish.ts';
import { finishVectors } from '../../src/scene/finish.ts';

const of = (change: Partial<typeof DEFAULT_FINISH>) => finishVectors({ ...DEFAULT_FINISH, ...change });

describe('vectors of a finish', () => {
  it('of the default one are the light that styles have anyway, exactly', () => {
    const { light, peak } = finishVectors(DEFAULT_FINISH);
    expect(light).toEqual([1, 1, 0.75, 0.25]);
    // where (N·H)^40 exceeds .8
    expect(peak).toEqual([40, 0.8 ** (1 / 40), 0, 0]);
  });

  it('of more specular whiten more, never wholly; of none not at all', () => {
    const whites = [0, 0.2, 0.4, 0.7, 1].map((specular) => of({ specular }).light);
    expect(whites.map(([, , white]) => white).every((white, i, all) => i === 0 || white > all[i - 1]!)).toBe(
      true,
    );
    expect(whites[0]!.slice(2)).toEqual([0, 0]);
    expect(whites.at(-1)![2]).toBeLessThan(1);
  });

  it('of more shininess have a smaller highlight', () => {
    const cosines = [1, 10, 40, 200].map((shininess) => of({ shininess }).peak[1]);
    expect(cosines).toEqual([...cosines].sort((a, b) => a - b));
    for (const cosine of cosines) expect(cosine).toBeLessThan(1);
  });
});
