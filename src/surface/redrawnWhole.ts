/** A closed outline drawn anew all round: q_l and q_r stay at the same v, by arc length between. */
import { cross2, scale2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Curve } from '../stroke/curve.ts';
import { nearestParameter } from '../stroke/nearestPoint.ts';
import type { Outline } from './outline.ts';

/** each half keeps this part of the stroke at least; else both are even */
const LEAST_HALF = 0.1;

export function redrawnWhole(outline: Outline, stroke: Curve): Outline {
  const sense = twiceArea(outline.point) * twiceArea(stroke.point) < 0 ? -1 : 1;
  const nearest = (v: number): number =>
    nearestParameter(stroke.point, stroke.tangent, outline.point(v), true);
  const start = nearest(0);
  const found = wrapped(sense * (nearest(0.5) - start));
  const half = found > LEAST_HALF && found < 1 - LEAST_HALF ? found : 0.5;
  /** t at v, and dt/dv */
  const at = (v: number, side: -1 | 1): readonly [number, number] => {
    const x = wrapped(v);
    const first = side === 1 ? x < 0.5 : x > 0 && x <= 0.5;
    const inside = first ? 2 * x * half : side === -1 && x === 0 ? 1 : half + (2 * x - 1) * (1 - half);
    return [wrapped(start + sense * inside), 2 * sense * (first ? half : 1 - half)];
  };
  return {
    closed: true,
    corners: stroke.corners
      .map((t) => {
        const inside = wrapped(sense * (t - start));
        return wrapped(inside < half ? inside / half / 2 : 0.5 + (inside - half) / (1 - half) / 2);
      })
      .sort((a, b) => a - b),
    point: (v) => stroke.point(at(v, 1)[0]),
    derivative: (v, side) => {
      const [t, pace] = at(v, side);
      const way = sense === 1 ? side : side === 1 ? -1 : 1;
      return scale2(stroke.tangent(t, way), pace * stroke.length);
    },
  };
}

const wrapped = (x: number): number => x - Math.floor(x);
const PROBES = 128;

/** Twice the area, counter-clockwise positive. */
function twiceArea(point: (t: number) => Vec2): number {
  const points = Array.from({ length: PROBES }, (_, i) => point(i / PROBES));
  return points.reduce((sum, p, i) => sum + cross2(p, points[(i + 1) % PROBES]!), 0);
}
