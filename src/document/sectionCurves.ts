/** Sections that were drawn across, on the drawing plane, with their ends on the construction curves. */
import { distance2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Pair } from '../surface/pair.ts';
import { curveOfStroke } from './curves.ts';
import type { Brush } from './document.ts';
import type { Section, SectionStroke } from './surfacePart.ts';

export interface SectionCurve {
  /** mm on the drawing plane, in the direction in which it was drawn */
  readonly points: readonly Vec2[];
  /** 0–1 at each of them */
  readonly pressure: readonly number[];
  readonly isBack: boolean;
}

const STEPS = 96;

/** Fronts and backs in the order of u; those that lie on a plane of their own are left out. */
export function sectionCurves(
  sections: readonly Section[],
  pair: Pair,
  brush: Pick<Brush, 'filter' | 'levels'>,
): readonly SectionCurve[] {
  return sections.flatMap(({ u, front, back }) =>
    [front, back].flatMap((drawn) => {
      const curve = drawn && snapped(drawn, pair, u, brush);
      return curve ? [{ ...curve, isBack: drawn === back }] : [];
    }),
  );
}

/** By the similarity that brings its ends to q_l(u) and q_r(u); the end that is nearer to q_l is the left one. */
function snapped(
  { stroke, half }: SectionStroke,
  pair: Pair,
  u: number,
  brush: Pick<Brush, 'filter' | 'levels'>,
): Omit<SectionCurve, 'isBack'> | null {
  const curve = half === null ? curveOfStroke(stroke, brush) : null;
  if (!curve) return null;
  const [a, b] = [curve.point(0), curve.point(1)];
  const { left, right } = pair.at(u, 1);
  const isForward = distance2(a, left) + distance2(b, right) <= distance2(a, right) + distance2(b, left);
  const [from, to] = isForward ? [left, right] : [right, left];
  const map = similarity(a, b, from, to);
  const us = Array.from({ length: STEPS + 1 }, (_, i) => i / STEPS);
  return map && { points: us.map((t) => map(curve.point(t))), pressure: us.map((t) => curve.pressure(t)) };
}

/** Turns, scales and moves a to c and b to d; null: a is b. */
function similarity(a: Vec2, b: Vec2, c: Vec2, d: Vec2): ((p: Vec2) => Vec2) | null {
  const [x, y] = [b[0] - a[0], b[1] - a[1]];
  const square = x * x + y * y;
  if (!(square > 0)) return null;
  const [vx, vy] = [d[0] - c[0], d[1] - c[1]];
  const re = (vx * x + vy * y) / square;
  const im = (vy * x - vx * y) / square;
  return ([px, py]) => {
    const [dx, dy] = [px - a[0], py - a[1]];
    return [c[0] + re * dx - im * dy, c[1] + im * dx + re * dy];
  };
}
