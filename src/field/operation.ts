/**
 * Two field values become one. All operations are unions: a ∩ b = −(−a ∪ −b), a \ b = −(−a ∪ b), so that their care in
 * float32 is taken in one place.
 */
export interface Operation {
  value(a: number, b: number): number;
  /** Writes [value, ∂/∂a, ∂/∂b]. */
  evaluate(a: number, b: number, out: Float64Array): void;
  /** Writes [low, high] of the results for a and b in their intervals [low, high]. */
  range(a: Float64Array, b: Float64Array, out: Float64Array): void;
  /** the largest that ∂/∂a and ∂/∂b come to */
  readonly stretch: number;
  /** what it is 0 on is what the larger operand is 0 on: its surface has an edge where they meet */
  readonly isExtreme: boolean;
  /** The c ≥ 0 for which the result is at most `level` ≤ 0 wherever a and b are at most −c. */
  reach(level: number): number;
}

/** of the operands: what a value loses */
export const ROUNDING = 4e-15;

/** The range of what rises with both operands: the values of both ends. */
export function monotone(value: Operation['value']): Operation['range'] {
  return (a, b, out) => {
    const low = value(a[0]!, b[0]!);
    const high = value(a[1]!, b[1]!);
    out[0] = low - ROUNDING * Math.abs(low);
    out[1] = high + ROUNDING * Math.abs(high);
  };
}
