import { describe, expect, test } from 'vitest';
import { acrossOf } from '../../src/surface/across.ts';
import { alike } from '../../src/surface/alike.ts';
import { joined, round } from '../../src/surface/joined.ts';
import { knotsOf } from '../../src/surface/knots.ts';
import { type Outline, roundHalf } from '../../src/surface/outline.ts';
import { roof, wave } from './outlines.ts';

const spans = (outline: Outline, wish = 16): number[] =>
  acrossOf(alike([outline]), wish).map((piece) => piece.spans);

describe('columns across sections', () => {
  test('what the wished number keeps to gets no more', () => {
    expect(spans(roundHalf)).toEqual([16]);
    expect(spans(round)).toEqual([16]);
    expect(spans(roof)).toEqual([8, 8]);
  });

  test('pieces with many bumps get more, straight ones beside them do not', () => {
    const [front, back] = spans(joined(wave(0.1, 9), roof)).slice(0, 2);
    expect(Math.max(front!, back!)).toBeGreaterThan(16);
    expect(Math.min(...spans(joined(wave(0.1, 9), roof)))).toBeLessThanOrEqual(8);
  });

  test('a scribble has an end', () => {
    expect(spans(wave(0.5, 400))[0]!).toBeLessThanOrEqual(1.5 * 6 * 16);
  });

  test('q_r stays a column of a ring', () => {
    const [piece] = acrossOf(alike([round]), 5);
    expect(knotsOf(piece!)).toContain(0.5);
  });
});
