/**
 * The fairest curve as near to the least-squares one as the hand's own tremble.
 *
 * Theory: a smoothing spline, min Σ|c(t_i) − f_i|² + λ∫|c‴|²; ∫|c‴|² spares circles and parabolas, which a penalty on
 * c″ would flatten. λ is the largest that moves the curve nowhere by more than a small multiple of the tremble, which
 * is what plain least squares leaves over: a clean line stays what it is.
 * Why: a surface shows its strokes' curvature. A tremble of 0.4 px that no eye sees in the line made the bands of toon
 * shading wobble by ten pixels, on quadratic curves more than on cubic ones, whose curvature is continuous.
 * Tried: a fixed λ (what calms a pear also halves a wave of 16 mm); a fixed tolerance of 0.25 mm (half circles of
 * radius 10 mm off by 1.4 %).
 */
import { distance2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import { type Basis, combine, spanCount, weightsAt } from './bspline.ts';
import { fitLeastSquares } from './leastSquares.ts';

/** The curve may move by this many times the tremble: less leaves wobble, more rounds what was meant. */
const TREMBLES = 3;
/** Powers of two tried for λ: a factor of two in λ moves a wave's damping little. Integer powers are exact in every engine. */
const POWERS = { from: -14, to: 17 } as const;

/** `count` control points of a cubic that moves by `most` at the most, in the unit of the points; 0: plain least squares. */
export function fitFair(fine: readonly Vec2[], closed: boolean, count: number, most: number): Vec2[] {
  const basis: Basis = { degree: 3, closed, count };
  let best = fitLeastSquares(fine, 3, closed, count);
  const plain = along(best, basis, fine.length);
  const tolerance = Math.min(most, TREMBLES * rms(plain, fine));
  if (tolerance <= 0) return best;
  let soft: number = POWERS.from;
  let stiff: number = POWERS.to;
  while (stiff - soft > 1) {
    const power = Math.floor((soft + stiff) / 2);
    const candidate = fitLeastSquares(fine, 3, closed, count, powerOfTwo(power));
    const near = along(candidate, basis, fine.length).every((p, i) => distance2(p, plain[i]!) <= tolerance);
    if (near) {
      best = candidate;
      soft = power;
    } else stiff = power;
  }
  return best;
}

function rms(a: readonly Vec2[], b: readonly Vec2[]): number {
  const squares = a.reduce((sum, p, i) => sum + square(p[0] - b[i]![0]) + square(p[1] - b[i]![1]), 0);
  return Math.sqrt(squares / a.length);
}

function powerOfTwo(power: number): number {
  let value = 1;
  for (let i = 0; i < Math.abs(power); i++) value *= 2;
  return power < 0 ? 1 / value : value;
}

/** The curve at its data points. */
function along(controls: readonly Vec2[], basis: Basis, points: number): Vec2[] {
  const step = spanCount(basis) / (basis.closed ? points : points - 1);
  return Array.from({ length: points }, (_, i): Vec2 => {
    const { span, weights } = weightsAt(basis, i * step);
    return combine(controls, basis, span, weights);
  });
}

const square = (x: number) => x * x;
