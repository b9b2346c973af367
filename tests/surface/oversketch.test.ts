import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { distance2, length2, sub2 } from '../../src/math/tuple.ts';
import type { Vec2 } from '../../src/math/vec.ts';
import { functionCurve, polylineCurve } from '../../src/stroke/arcLength.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import type { Outline } from '../../src/surface/outline.ts';
import { nearestV, redrawn } from '../../src/surface/oversketch.ts';
import { line, polygon, reversed, smoothStroke } from './curves.ts';

const angleAt = (v: number): number => Math.PI * (1 - 2 * (v - Math.floor(v)));
/** from q_l over the front to q_r and back */
const ring: Outline = {
  closed: true,
  corners: [],
  point: (v) => [Math.cos(angleAt(v)), Math.sin(angleAt(v))],
  derivative: (v) => [2 * Math.PI * Math.sin(angleAt(v)), -2 * Math.PI * Math.cos(angleAt(v))],
};
const half: Outline = {
  closed: false,
  corners: [],
  point: (v) => ring.point(v / 2),
  derivative: (v, side) => ring.derivative(v / 2, side).map((x) => x / 2) as unknown as Vec2,
};
/** q_l, up, right, down, q_r and back along the chord */
const box: Outline = (() => {
  const curve = polygon([-1, 0], [-1, 1], [1, 1], [1, 0]);
  return {
    closed: true,
    corners: curve.corners,
    point: curve.point,
    derivative: (v, side) => curve.tangent(v, side).map((x) => x * curve.length) as unknown as Vec2,
  };
})();

/** Part of the unit circle, exact by arc length. */
function arc(from: number, to: number, radius = 1): Curve {
  const at = (t: number): number => from + (to - from) * Math.min(Math.max(t, 0), 1);
  const way = Math.sign(to - from);
  return {
    closed: false,
    length: radius * Math.abs(to - from),
    corners: [],
    point: (t) => [radius * Math.cos(at(t)), radius * Math.sin(at(t))],
    tangent: (t) => [-way * Math.sin(at(t)), way * Math.cos(at(t))],
    pressure: () => 0.5,
  };
}

const VS = Array.from({ length: 201 }, (_, i) => i / 200);
const largest = (a: Outline, b: Outline, vs = VS): number =>
  Math.max(...vs.map((v) => distance2(a.point(v), b.point(v))));
const steepest = (a: Outline, b: Outline, vs = VS): number =>
  Math.max(...vs.map((v) => distance2(a.derivative(v, 1), b.derivative(v, 1))));
/** The largest step between neighbours: breaks show. */
const step = (outline: Outline): number => {
  const points = Array.from({ length: 4001 }, (_, i) => outline.point(i / 4000));
  return Math.max(...points.slice(1).map((p, i) => distance2(p, points[i]!)));
};
const nearestTo = (outline: Outline, p: Vec2): number =>
  Math.min(...Array.from({ length: 4001 }, (_, i) => distance2(outline.point(i / 4000), p)));

/** Away from corners, derivatives are those of the points. */
function derivativeError(outline: Outline): number {
  const h = 1e-6;
  const vs = VS.map((v) => 0.0013 + 0.997 * v).filter((v) =>
    outline.corners.every((c) => Math.abs(c - v) > 1e-4),
  );
  return Math.max(
    ...vs.map((v) => {
      const slope = sub2(outline.point(v + h), outline.point(v - h)).map(
        (x) => x / (2 * h),
      ) as unknown as Vec2;
      return distance2(slope, outline.derivative(v, 1)) / (1 + length2(slope));
    }),
  );
}

describe('oversketch', () => {
  for (const [name, outline, curve] of [
    ['a closed outline, on the front', ring, arc(2.5, 0.4)],
    ['a closed outline, across q_r', ring, arc(0.7, -0.9)],
    ['a closed outline, across q_l', ring, arc(2.5, 3.9)],
    ['a closed outline, more than half of it', ring, arc(2.9, -1.6)],
    ['an open outline', half, arc(2.5, 0.4)],
    ['all of an open outline', half, arc(Math.PI, 0)],
  ] as const) {
    test(`the same exact arc changes nothing: ${name}`, () => {
      for (const drawn of [curve, reversed(curve)]) {
        const after = redrawn(outline, drawn);
        expect(largest(outline, after)).toBeLessThan(1e-9);
        expect(steepest(outline, after)).toBeLessThan(1e-6);
        expect(after.corners).toEqual([]);
      }
    });
  }

  test('the part drawn over is replaced, the rest stays where it is, v included', () => {
    const bump = functionCurve((t) => {
      const a = 2.2 - 1.3 * t;
      const r = 1 + 0.4 * Math.sin(Math.PI * t) ** 2;
      return [r * Math.cos(a), r * Math.sin(a)];
    }, false);
    for (const outline of [ring, half]) {
      for (const drawn of [bump, reversed(bump)]) {
        const after = redrawn(outline, drawn);
        const [a, b] = [bump.point(0), bump.point(1)].map((p) => nearestV(outline, p));
        const outside = VS.filter((v) => v <= a! || v >= b!);
        expect(largest(outline, after, outside)).toBe(0);
        for (const t of [0.1, 0.5, 0.9]) expect(nearestTo(after, bump.point(t))).toBeLessThan(2e-3);
        expect(after.corners).toEqual([]);
        expect(derivativeError(after)).toBeLessThan(2e-3);
      }
    }
  });

  test('on closed outlines the nearer part goes, however long', () => {
    const wide = functionCurve((t) => {
      const a = 2.9 - 4.6 * t;
      const r = 1 + 0.3 * Math.sin(Math.PI * t);
      return [r * Math.cos(a), r * Math.sin(a)];
    }, false);
    const after = redrawn(ring, wide);
    // what is left lies between the angles −1.7 and 2.9 − 2π
    const kept = VS.filter((v) => distance2(after.point(v), ring.point(v)) < 1e-9);
    expect(kept.length / VS.length).toBeCloseTo((2 * Math.PI - 4.6) / (2 * Math.PI), 1);
    expect(nearestTo(after, wide.point(0.5))).toBeLessThan(2e-3);
  });

  test('a chord cuts off the smaller side', () => {
    const after = redrawn(ring, line([-0.6, 0.8], [0.6, 0.8]));
    expect(nearestTo(after, [0, 1])).toBeGreaterThan(0.15);
    expect(nearestTo(after, [0, -1])).toBeLessThan(1e-3);
    // it meets the circle at 53°, and keeps that
    expect(after.corners).toHaveLength(2);
  });

  test('corners: those replaced go, those of the stroke come, the others stay', () => {
    const after = redrawn(box, line([-0.5, 1], [0, 1.6], [0.5, 1]));
    const places = after.corners.map((v) => after.point(v));
    expect(places).toHaveLength(7);
    for (const corner of [
      [-1, 0],
      [-1, 1],
      [1, 1],
      [1, 0],
      [-0.5, 1],
      [0, 1.6],
      [0.5, 1],
    ] as Vec2[]) {
      expect(Math.min(...places.map((p) => distance2(p, corner)))).toBeLessThan(1e-6);
    }
    const over = redrawn(box, arc(2.2, 0.9, 1.3));
    const rest = over.corners.map((v) => over.point(v));
    expect(rest.every((p) => distance2(p, [-1, 0]) < 1e-6 || distance2(p, [1, 0]) < 1e-6 || p[1] > 0.9)).toBe(
      true,
    );
  });

  test('both sides of a corner have their own derivative', () => {
    const after = redrawn(ring, line([-0.6, 0.8], [0, 3], [0.6, 0.8]));
    expect(after.corners).toHaveLength(3);
    const h = 1e-6;
    for (const v of after.corners) {
      for (const side of [-1, 1] as const) {
        const there = after.point(v + side * h);
        const slope = sub2(there, after.point(v)).map((x) => (side * x) / h) as unknown as Vec2;
        expect(distance2(slope, after.derivative(v, side)) / length2(slope)).toBeLessThan(1e-3);
      }
    }
  });

  test('a stroke beyond the ends of an open outline ends there', () => {
    const over = line([-1.4, -0.1], [-1, 0.01], [0, 0.3], [1, -0.02], [1.2, -0.3]);
    const after = redrawn(half, over);
    expect(after.point(0)).toEqual(half.point(0));
    expect(after.point(1)).toEqual(half.point(1));
    expect(Math.min(...VS.map((v) => after.point(v)[0]))).toBeGreaterThan(-1.02);
    expect(nearestTo(after, [0, 0.3])).toBeLessThan(0.02);
  });

  test('strokes beside the outline are reached by it without a break', () => {
    const after = redrawn(ring, arc(2.4, 0.8, 1.3));
    expect(step(after)).toBeLessThan(0.01);
    expect(nearestTo(after, [0, 1.3])).toBeLessThan(1e-2);
  });

  test('dots and strokes that come back say nothing', () => {
    for (const curve of [
      polylineCurve([[0, 1]], false),
      line([0, 1], [0, 1.5], [0, 1]),
      polygon([0, 1], [0.1, 1.1], [0, 1.1]),
    ]) {
      expect(redrawn(half, curve)).toBe(half);
    }
  });

  test('drawn all round: everything is replaced, q_l and q_r keep their v', () => {
    const oval = functionCurve((t) => {
      const a = 1 + 2 * Math.PI * t;
      return [1.2 * Math.cos(a), 0.5 * Math.sin(a) + 0.1];
    }, true);
    for (const curve of [oval, reversed(oval)]) {
      const after = redrawn(ring, curve);
      expect(after.point(0)[0]).toBeLessThan(-1.05);
      expect(after.point(0.5)[0]).toBeGreaterThan(1.05);
      expect(after.point(0.25)[1]).toBeCloseTo(0.6, 2);
      expect(after.point(1)).toEqual(after.point(0));
      expect(derivativeError({ ...after, corners: [0, 0.5, 1] })).toBeLessThan(2e-3);
    }
    expect(largest(ring, redrawn(ring, arcRound()))).toBeLessThan(1e-4);
    const square = redrawn(ring, polygon([-1, -1], [-1, 1], [1, 1], [1, -1]));
    const corners = square.corners.map((v) => square.point(v).map((x) => Math.round(x * 1e6) / 1e6));
    expect(corners).toHaveLength(4);
    for (const corner of corners) expect(corner.map(Math.abs)).toEqual([1, 1]);
  });

  test('stacks', () => {
    const bump = (from: number, to: number): Curve =>
      functionCurve((t) => {
        const a = from + (to - from) * t;
        const r = 1 + 0.3 * Math.sin(Math.PI * t) ** 2;
        return [r * Math.cos(a), r * Math.sin(a)];
      }, false);
    const all = [bump(2.5, 1.2), bump(0.9, -0.5), bump(-1, -2.6), line([-0.9, 0.7], [0.9, 0.75])];
    const after = all.reduce((before, stroke) => redrawn(before, stroke), ring);
    expect(step(after)).toBeLessThan(0.01);
    expect(derivativeError(after)).toBeLessThan(2e-3);
    expect(nearestTo(after, bump(-1, -2.6).point(0.5))).toBeLessThan(2e-3);
    expect([...after.corners].sort((a, b) => a - b)).toEqual(after.corners);
  });

  test('any strokes one over the other: no break, nothing that is no number (seed 93)', () => {
    fc.assert(
      fc.property(
        fc.array(smoothStroke(1), { minLength: 1, maxLength: 3 }),
        fc.constantFrom(ring, half, box),
        (all, outline) => {
          const after = all.reduce((before, stroke) => redrawn(before, stroke), outline);
          for (const v of VS) {
            expect(
              [...after.point(v), ...after.derivative(v, 1), ...after.derivative(v, -1)].every(
                Number.isFinite,
              ),
            ).toBe(true);
          }
          // a short piece may be run through fast: where steps are taken, and between
          const fast = Array.from({ length: 8001 }, (_, i) => i / 8000);
          const longest = Math.max(...fast.map((v) => length2(after.derivative(v, 1))));
          expect(step(after)).toBeLessThan((2 * longest) / 4000 + 0.02);
          expect(
            after.corners.every((v, i) => v >= 0 && v <= 1 && (i === 0 || v > after.corners[i - 1]!)),
          ).toBe(true);
          if (after.closed) expect(after.point(1)).toEqual(after.point(0));
        },
      ),
      { numRuns: 60, seed: 93 },
    );
  });
});

function arcRound(): Curve {
  return functionCurve((t) => ring.point(t), true);
}

test('a dent to the middle of a closed outline goes to the part that was seen, whichever way it was drawn', () => {
  const chord = (y: number) => [line([-0.99, y], [0.99, y]), line([0.99, y], [-0.99, y])];
  for (const dent of [-0.05, 0, 0.05].flatMap(chord))
    for (const side of [-1, 1] as const) {
      const made = redrawn(ring, dent, [0, side * 0.6]);
      const heights = Array.from({ length: 64 }, (_, i) => side * made.point(i / 64)[1]);
      // the seen half is flat now, the other one as it was
      expect(Math.max(...heights)).toBeLessThan(0.2);
      expect(Math.min(...heights)).toBeCloseTo(-1, 2);
    }
  // what is drawn over the hidden half is meant for that
  const hidden = redrawn(ring, line([-0.9, -0.5], [0.9, -0.5]), [0, 1]);
  expect(Math.max(...Array.from({ length: 64 }, (_, i) => hidden.point(i / 64)[1]))).toBeCloseTo(1, 2);
});
