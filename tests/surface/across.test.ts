import { describe, expect, test } from 'vitest';
import { acrossOf } from '../../src/surface/across.ts';
import { alike } from '../../src/surface/alike.ts';
import { joined, round } from '../../src/surface/joined.ts';
import { knotsOf } from '../../src/surface/knots.ts';
import { type Outline, roundHalf } from '../../src/surface/outline.ts';
import { bent, raisedBy, roof, wave } from './outlines.ts';

const spans = (outline: Outline, wish = 16): number[] =>
  acrossOf(alike([outline]), wish).map((piece) => piece.spans);

describe('columns across sections', () => {
  test('what the wished number keeps to gets no more', () => {
    expect(spans(roundHalf)).toEqual([16]);
    expect(spans(round)).toEqual([16]);
    expect(spans(roof)).toEqual([8, 8]);
  });

  test('pieces with many bumps get more, straight ones beside them do not', () => {
    const found = spans(joined(roof, wave(0.06, 9)));
    expect(found).toHaveLength(3);
    expect(Math.max(...found)).toBeGreaterThan(16);
    expect(Math.min(...found)).toBeLessThanOrEqual(8);
  });

  test('a scribble has an end', () => {
    expect(spans(wave(0.5, 400))[0]!).toBeLessThanOrEqual(1.5 * 6 * 16);
  });

  test('q_r stays a column of a ring', () => {
    const [piece] = acrossOf(alike([round]), 5);
    expect(knotsOf(piece!)).toContain(0.5);
  });

  test.each([0.9985, 0.9999, 0.00003])(
    'q_r and q_l stay columns beside a crease at %d of the front',
    (at) => {
      const [x, y] = roundHalf.point(at);
      const creased = joined(
        bent([-1, 0], [x, y - 0.3 * (1 - Math.abs(x))], [1, 0]),
        raisedBy(roundHalf, -1),
      );
      const moved = { ...creased, corners: [at / 2] };
      const found = acrossOf(alike([moved]), 16).flatMap((piece) => knotsOf(piece).map((v) => v % 1));
      for (const v of [0, 0.5, at / 2]) expect(found).toContain(v);
    },
  );
});
