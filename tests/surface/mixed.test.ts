import { expect, test } from 'vitest';
import { mixedOutline } from '../../src/surface/mixed.ts';
import { roundHalf } from '../../src/surface/outline.ts';
import { raisedBy } from './outlines.ts';

test('on a ring sections at the end are at the beginning, of two in one place the last counts', () => {
  const [low, high] = [raisedBy(roundHalf, 0.5), raisedBy(roundHalf, 2)];
  const sections = [
    { u: 0, outline: low },
    { u: 1, outline: high },
  ];
  for (const between of ['cubic', 'linear', 'plain'] as const) {
    for (const u of [0, 0.5, 1]) {
      expect(mixedOutline(sections, u, between, true).point(0.5)).toEqual([0, 2]);
    }
  }
});
