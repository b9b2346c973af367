/** Strokes as pages write them become strokes that the document takes. */
import { describe, expect, it } from 'vitest';
import { EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { checkStroke, replay } from '../../src/document/serialize.ts';
import { type StrokeInput, strokeOf } from '../../src/element/strokeInput.ts';

const POINTS: StrokeInput['points'] = [
  [0, 60],
  [10, 0, 0.9],
  [0, -60],
];

describe('strokeOf', () => {
  it('fills in what a hand would have added', () => {
    const stroke = checkStroke(strokeOf({ points: POINTS }, EMPTY_DOCUMENT));
    expect(stroke.samples.map(({ x, y, pressure }) => [x, y, pressure])).toEqual([
      [0, 60, 0.5],
      [10, 0, 0.9],
      [0, -60, 0.5],
    ]);
    const times = stroke.samples.map(({ time }) => time);
    expect(times[0]).toBe(0);
    expect([...times].sort((a, b) => a - b)).toEqual(times);
    expect(stroke.closed).toBe(false);
  });

  it('lies on the plane of the unfinished form, so that the two pair', () => {
    const plane = { origin: [0, 0, 9], x: [0, 0, 1], y: [0, 1, 0] } as const;
    const first = checkStroke(strokeOf({ points: POINTS, plane }, EMPTY_DOCUMENT));
    const begun = replay([{ type: 'addStroke', stroke: first }]);
    const second = checkStroke(strokeOf({ points: POINTS.map(([x, y]) => [x + 50, y]) }, begun));
    expect(second.plane).toEqual(plane);
    const kept = replay([{ type: 'addStroke', stroke: second }, { type: 'keep' }], begun);
    expect(kept.parts.map(({ kind }) => kind)).toEqual(['rotational']);
  });

  it('leaves whole strokes as they are, and nonsense for the check to name', () => {
    const whole = checkStroke(strokeOf({ points: POINTS }, EMPTY_DOCUMENT));
    expect(strokeOf(whole, EMPTY_DOCUMENT)).toBe(whole);
    for (const nonsense of [null, 7, {}, { points: 'many' }, { points: [7] }, { points: [[1]] }])
      expect(() => checkStroke(strokeOf(nonsense as never, EMPTY_DOCUMENT))).toThrow(/stroke.*expected/);
  });
});
