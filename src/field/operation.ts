/**
 * Two field values become one. All operations are unions: a ∩ b = −(−a ∪ −b), a \ b = −(−a ∪ b), so that their care in
 * float32 is taken in one place.
 */
export interface Operation {
  value(a: number, b: number): number;
  /** Writes [value, ∂/∂a, ∂/∂b]. */
  evaluate(a: number, b: number, out: Float64Array): void;
  /** The c ≥ 0 for which the result is at most `level` ≤ 0 wherever a and b are at most −c. */
  reach(level: number): number;
}
