/** Where strokes of sections lie on a drawing: on two sides at x = −20 and 20, or on a tube of 6 mm. */
import { describe, expect, it } from 'vitest';
import { DEFAULT_BRUSH } from '../../src/document/document.ts';
import { sectionCurves } from '../../src/document/sectionCurves.ts';
import type { Section } from '../../src/document/surfacePart.ts';
import { PLANE, strokeAlong } from './strokes.ts';

const side = (x: number) => strokeAlong((t) => [x, 60 * t], { plane: PLANE });
const across = strokeAlong((t) => [40 * t - 20, 30 - 40 * t * (1 - t)], { plane: PLANE });
const turned = { ...across, samples: [...across.samples].reverse() };
/** from the middle to 5 mm out of the plane at the right */
const over = { stroke: strokeAlong((t) => [10 * t, 5 * t], { plane: PLANE }), half: 10 };
const SECTIONS: readonly Section[] = [
  { u: 0.25, front: { stroke: across, half: null }, back: { stroke: turned, half: null }, redraws: [over] },
  { u: 0.75, front: null, back: null, redraws: [over, over] },
];

describe('strokes of sections', () => {
  it('come in the order in which they are counted: front, back, what was drawn over it', () => {
    const found = sectionCurves({ strokes: [side(-20), side(20)], sections: SECTIONS }, DEFAULT_BRUSH);
    expect(found.map(({ section, as }) => [section, as])).toEqual([
      [0, 'front'],
      [0, 'back'],
      [0, 'redraw'],
      [1, 'redraw'],
      [1, 'redraw'],
    ]);
    const [front, back, redraw] = found;
    for (const { points } of [front!, back!]) expect(points.every(([, , z]) => z === 0)).toBe(true);
    // half a chord of 20 mm where it was drawn over one of 10
    const end = redraw!.points.at(-1)!;
    const [left, right] = redraw!.ends;
    expect(Math.hypot(end[0] - right[0], end[1] - right[1])).toBeLessThan(0.5);
    expect(Math.abs(end[2])).toBeCloseTo(10, 0);
    expect(Math.hypot(left[0] - right[0], left[1] - right[1])).toBeCloseTo(40, 0);
  });

  it('are there on one stroke, too, as wide as the tube', () => {
    const found = sectionCurves({ strokes: [side(0)], sections: SECTIONS }, DEFAULT_BRUSH);
    expect(found).toHaveLength(5);
    for (const { points, ends } of found) {
      expect(points.length).toBeGreaterThan(1);
      expect(Math.hypot(ends[0][0] - ends[1][0], ends[0][1] - ends[1][1])).toBeCloseTo(12, 6);
    }
  });

  it('are not where there is nothing to hold them', () => {
    expect(sectionCurves({ strokes: [], sections: SECTIONS }, DEFAULT_BRUSH)).toEqual([]);
    expect(sectionCurves({ strokes: [side(0)], sections: [] }, DEFAULT_BRUSH)).toEqual([]);
  });
});
