/**
 * Super-quadric cross section: |x|^α + |y|^α = r^α (Tai et al. (19); the other convention of (18) is not used). 2 is
 * round, 1 a diamond, below 1 a star with concave sides, 100 nearly a square.
 *
 * With t = min/max of |x|, |y|: m = (1 + t^α)^{1/α} / √(1 + t²), which neither over- nor underflows in float32 (the literal
 * form does at 59 % of the points that were tried for α = 50). For α < 1 the field has a crease on both axes; there the slope is
 * finite but arbitrary.
 */
import { pow } from '../math/pow.ts';
import { FieldError } from '../skeleton/skeleton.ts';
import { radialBend, risingMove, type Section } from './section.ts';

export interface SuperQuadric {
  readonly type: 'superQuadric';
  /** α, 0.3–100 */
  readonly exponent: number;
}

/** Closer to an axis the slope of t^α is not followed. */
const CREASE = 1e-6;

/** A norm's second derivative around, largest on the diagonal, and twice its first; without a bound at the axes below 2. */
export function superQuadricBend(exponent: number): number {
  const around = Math.max((exponent - 1) * pow(2, 1 / exponent - 0.5), 1);
  return exponent >= 2 ? Math.sqrt(around * around + 4) : Infinity;
}

export function superQuadric({ exponent }: SuperQuadric): Section {
  if (!(exponent >= 0.3 && exponent <= 100))
    throw new FieldError(`exponent must be 0.3–100, got ${exponent}`);
  const stretch = (t: number, s: number) => pow(1 + s, 1 / exponent) / Math.sqrt(1 + t * t);
  const bend = superQuadricBend(exponent);
  const generic = (x: number, y: number) => {
    const large = Math.max(x, y);
    const t = large === 0 ? 0 : Math.min(x, y) / large;
    return large * pow(1 + pow(t, exponent), 1 / exponent);
  };
  return {
    value(x, y) {
      const large = Math.max(Math.abs(x), Math.abs(y));
      if (large === 0) return 1;
      const t = Math.min(Math.abs(x), Math.abs(y)) / large;
      return stretch(t, pow(t, exponent));
    },
    evaluate(x, y, out) {
      const wide = Math.abs(x) >= Math.abs(y);
      const large = wide ? x : y;
      const small = wide ? y : x;
      const inverse = large === 0 ? 0 : 1 / Math.abs(large);
      const t = large === 0 ? 0 : Math.abs(small) / Math.abs(large);
      const s = pow(t, exponent);
      const m = stretch(t, s);
      const slope = m * (s / (Math.max(t, CREASE) * (1 + s)) - t / (1 + t * t));
      // t falls with the larger coordinate and rises with the smaller
      const alongLarge = -slope * t * inverse * (large < 0 ? -1 : 1);
      const alongSmall = slope * inverse * (small < 0 ? -1 : 1);
      out[0] = m;
      out[1] = wide ? alongLarge : alongSmall;
      out[2] = wide ? alongSmall : alongLarge;
    },
    move(x, y, m, rx, ry, out) {
      out[0] = risingMove(generic, x, y, m * Math.sqrt(x * x + y * y), rx, ry);
      out[1] = radialBend(Math.sqrt(x * x + y * y), Math.max(rx, ry), bend);
    },
    extent: (r) => [r, r],
  };
}
