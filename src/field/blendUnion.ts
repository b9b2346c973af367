/**
 * Blending union (Kravtsov et al. §1.2): the R-union plus a0 / (1 + (a/a1)² + (b/a2)²). a0 shifts the surface where both
 * operands are near 0 (negative: a groove), a1 and a2 say how far from each surface. All are in units of the values:
 * mm for shapes, field for F − T.
 */
import { FieldError } from '../skeleton/skeleton.ts';
import { type Operation, ROUNDING } from './operation.ts';
import { smoothUnion, smoothUnionValue } from './smoothUnion.ts';

export interface BlendAmounts {
  readonly a0: number;
  /** above 0 */
  readonly a1: number;
  /** above 0 */
  readonly a2: number;
}

export function blendUnion({ a0, a1, a2 }: BlendAmounts): Operation {
  if (!Number.isFinite(a0)) throw new FieldError(`a0 must be a number, got ${a0}`);
  for (const [name, amount] of [['a1', a1] as const, ['a2', a2] as const]) {
    if (!(amount > 0 && amount < Infinity)) throw new FieldError(`${name} must be above 0, got ${amount}`);
  }
  const bump = (a: number, b: number) => {
    const u = a / a1;
    const v = b / a2;
    return a0 / (1 + u * u + v * v);
  };
  /** of the bump: largest where both operands are nearest to 0 */
  const near = (x: Float64Array) => Math.max(x[0]!, -x[1]!, 0);
  const far = (x: Float64Array) => Math.max(-x[0]!, x[1]!);
  return {
    // the bump is steepest at 1/√3 of its width
    stretch: 2 + (0.65 * Math.abs(a0)) / Math.min(a1, a2),
    isExtreme: false,
    range(a, b, out) {
      const top = bump(near(a), near(b));
      const foot = bump(far(a), far(b));
      smoothUnion.range(a, b, out);
      const margin = ROUNDING * (Math.abs(a0) + Math.abs(out[0]!) + Math.abs(out[1]!));
      out[0] = out[0]! + Math.min(top, foot) - margin;
      out[1] = out[1]! + Math.max(top, foot) + margin;
    },
    value: (a, b) => smoothUnionValue(a, b) + bump(a, b),
    evaluate(a, b, out) {
      smoothUnion.evaluate(a, b, out);
      const u = a / a1;
      const v = b / a2;
      const depth = 1 + u * u + v * v;
      const slope = (-2 * a0) / depth / depth;
      out[0]! += a0 / depth;
      out[1]! += (slope * u) / a1;
      out[2]! += (slope * v) / a2;
    },
    reach(level) {
      const bare = smoothUnion.reach(level);
      if (a0 <= 0) return bare;
      // the bump falls and the union's depth grows with c: their only crossing
      let low = bare;
      let high = smoothUnion.reach(level - a0);
      for (let i = 0; i < 50; i++) {
        const c = 0.5 * (low + high);
        if (smoothUnionValue(-c, -c) + bump(c, c) > level) low = c;
        else high = c;
      }
      return high;
    },
  };
}
