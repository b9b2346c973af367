import { describe, expect, test } from 'vitest';
import type { Vec2 } from '../../src/math/vec.ts';
import { CLOSED_TOLERANCE, isClosed, joinEnds } from '../../src/stroke/closed.ts';
import { type Path, pathOf, toVec } from '../../src/stroke/path.ts';
import { penStroke, samplesAt } from '../fixtures/pen.ts';
import { ellipse, halfCircle, polygon, polyline, type Shape, spiral } from '../fixtures/shapes.ts';

const drawn = (shape: Shape, overshoot: number, seed: number) =>
  pathOf(penStroke(shape, { seed, overshoot, jitter: 0.05 }), false);

/** Crossings of a closed path with itself. */
function crossings(path: Path): number {
  const p = path.points.map(toVec);
  const n = p.length;
  const side = (a: Vec2, b: Vec2, c: Vec2) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  let count = 0;
  for (let i = 0; i < n; i++) {
    for (let j = i + 2; j < n; j++) {
      if (i === 0 && j === n - 1) continue;
      const [a, b, c, d] = [p[i]!, p[i + 1]!, p[j]!, p[(j + 1) % n]!];
      if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) count++;
    }
  }
  return count;
}

function area(path: Path): number {
  return path.points.reduce((sum, p, i) => {
    const q = path.points[(i + 1) % path.points.length]!;
    return sum + 0.5 * (p.x * q.y - q.x * p.y);
  }, 0);
}

describe('closed', () => {
  for (const miss of [-7.5, -4, -1.25, 0, 1.25, 4, 7.5, 15]) {
    for (const seed of [1, 2, 3]) {
      test(`an ellipse missed by ${miss} mm is closed and encloses what it should (seed ${seed})`, () => {
        const path = drawn(ellipse(50, 35), miss, seed);
        expect(isClosed(path, CLOSED_TOLERANCE)).toBe(true);
        const ring = joinEnds(path);
        expect(ring.closed).toBe(true);
        expect(crossings(ring)).toBe(0);
        expect(area(ring) / (Math.PI * 50 * 35)).toBeCloseTo(1, 1.6);
        const step = Math.max(...ring.points.map((_, i) => ring.lengths[i + 1]! - ring.lengths[i]!));
        expect(step).toBeLessThan(Math.max(2, -miss + 1.5));
      });
    }
  }

  test('an overshoot that crosses is cut at the crossing', () => {
    // drifts outwards or inwards by 3 mm a turn, so that the end passes the start at an angle
    for (const drift of [-3, 3]) {
      const wobble: Shape = (t) => {
        const a = 2 * Math.PI * 1.06 * t;
        const r =
          40 + drift * (t - 0.5) + 3 * Math.sin(40 * (t > 0.9 ? t - 0.9 : 0)) - 2 * (t < 0.06 ? 0.06 - t : 0);
        return [r * Math.cos(a), r * Math.sin(a)];
      };
      const ring = joinEnds(drawn(wobble, 0, 1));
      expect(crossings(ring)).toBe(0);
      expect(ring.length).toBeLessThan(2 * Math.PI * 40 * 1.03);
    }
  });

  test('an overshoot alongside is bent onto the start: no step remains', () => {
    const ring = joinEnds(drawn(spiral(40, 42.5, 1.05), 0, 1));
    const n = ring.points.length;
    const around = [n - 3, n - 2, n - 1, 0, 1, 2, 3].map((i) => ring.points[i]!);
    const radii = around.map((p) => Math.hypot(p.x, p.y));
    expect(Math.max(...radii) - Math.min(...radii)).toBeLessThan(0.5);
    expect(crossings(ring)).toBe(0);
  });

  test('a triangle that stops short gets its corner back', () => {
    const triangle = polyline(polygon(3, 50));
    for (const short of [2, 5, 8]) {
      const ring = joinEnds(drawn(triangle, -short, 1));
      expect(Math.min(...ring.points.map((p) => Math.hypot(p.x - 50, p.y)))).toBeLessThan(0.6);
      expect(area(ring) / ((3 * Math.sqrt(3) * 2500) / 4)).toBeCloseTo(1, 1.7);
    }
  });

  test('open strokes are open: lines, half circles, spirals, waves, a C', () => {
    const open: readonly Shape[] = [
      (t) => [100 * t, 0],
      halfCircle(40),
      spiral(5, 50, 3),
      (t) => [120 * t, 10 * Math.sin(9 * t)],
      (t) => [40 * Math.cos(5.5 * t), 40 * Math.sin(5.5 * t)],
    ];
    for (const shape of open) expect(isClosed(drawn(shape, 0, 1), CLOSED_TOLERANCE)).toBe(false);
  });

  test('a long scribble is not closed by chance', () => {
    const scribble: Shape = (t) => [60 * Math.sin(41 * t) + 55 * t, 60 * Math.sin(53 * t)];
    const path = drawn(scribble, 0, 1);
    const gap = Math.hypot(
      path.points.at(-1)!.x - path.points[0]!.x,
      path.points.at(-1)!.y - path.points[0]!.y,
    );
    expect(gap / path.length).toBeLessThan(CLOSED_TOLERANCE);
    expect(isClosed(path, CLOSED_TOLERANCE)).toBe(false);
  });

  test('the tolerance decides', () => {
    const path = pathOf(samplesAt([...polygon(60, 50)].slice(0, 59)), false);
    expect(isClosed(path, 0.04)).toBe(true);
    expect(isClosed(path, 0.001)).toBe(false);
  });

  test('any stroke can be closed by force: three points, a line, a half circle', () => {
    const triangle = joinEnds(
      pathOf(
        samplesAt([
          [0, 0],
          [30, 0],
          [15, 30],
        ]),
        false,
      ),
    );
    expect(triangle.closed).toBe(true);
    expect(triangle.points).toHaveLength(3);
    expect(
      joinEnds(
        pathOf(
          samplesAt([
            [0, 0],
            [10, 0],
            [20, 0],
          ]),
          false,
        ),
      ).length,
    ).toBeGreaterThan(20);
    const half = joinEnds(drawn(halfCircle(40), 0, 1));
    expect(Math.abs(area(half)) / (Math.PI * 800)).toBeCloseTo(1, 1.6);
  });
});
