/** Sections where they are seen: the sheet's own points, in a frame that knows what is out of the drawing plane. */
import { describe, expect, it } from 'vitest';
import { DEFAULT_BRUSH } from '../../src/document/document.ts';
import { type Seen, sectionLoop, sectionSeenAt, sectionThrough } from '../../src/document/sectionLoops.ts';
import { PLAIN, ROUND, type SurfaceForm } from '../../src/document/surfacePart.ts';
import { UNMOVED } from '../../src/math/placement.ts';
import { line, strokeAlong } from './strokes.ts';

/** Twice as high as it is wide, seen in the middle. */
const tall = { half: null, stroke: strokeAlong((t) => [20 * t - 10, -80 * t * (1 - t)]) };
const form: SurfaceForm = {
  ...PLAIN,
  strokes: [line(-10), line(10)],
  sections: [{ u: 0.5, ...ROUND, front: tall }],
  back: 'front',
};
const seen = (kind: Seen['kind'], change: Partial<SurfaceForm> = {}): Seen => ({
  kind,
  form: { ...form, ...change },
  brush: DEFAULT_BRUSH,
  placement: UNMOVED,
});
const heightOf = (of: Seen): number => Math.max(...sectionLoop(of, 0.5)!.points.map(([, , z]) => z));

describe('sections where they are seen', () => {
  it('stand in the plane of their chord, out towards the person', () => {
    const { plane, half, closed } = sectionLoop(seen('crossSection'), 0.5)!;
    expect(half).toBeCloseTo(10, 1);
    expect(closed).toBe(true);
    expect(Math.abs(plane.x[0])).toBeCloseTo(1, 9);
    expect(plane.y[2]).toBeCloseTo(1, 9);
  });

  it('are those of the kind, bends and sections there are now', () => {
    const whole = heightOf(seen('crossSection'));
    expect(whole).toBeGreaterThan(18);
    // a person stepped back from the section: the strokes are the same ones
    expect(heightOf(seen('rotational'))).toBeCloseTo(10, 1);
    expect(heightOf(seen('crossSection', { back: 'none' }))).toBeCloseTo(whole, 6);
    expect(heightOf(seen('crossSection'))).toBe(whole);
  });

  it('are found by a point of the surface, and by where they are seen', () => {
    const round = seen('rotational');
    const { plane, points } = sectionLoop(round, 0.37)!;
    const top = points.reduce((a, b) => (b[2] > a[2] ? b : a));
    expect(sectionThrough(round, top)).toBeCloseTo(0.37, 6);
    const at = sectionSeenAt(round, ([x, y]) => [x - plane.origin[0], y - plane.origin[1]])!;
    expect(at.u).toBeCloseTo(0.37, 6);
  });
});
