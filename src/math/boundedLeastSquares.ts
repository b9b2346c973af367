/**
 * min |A x − y|² with low ≤ x ≤ high, for tens to a few hundred unknowns: coordinates in turn, each set to its best within its bounds
 * (Hildreth 1957, d'Esopo 1959; Gauss–Seidel on the normal equations). For rows that are well scaled, and damped where they say little.
 */

export interface Bounded {
  readonly x: readonly number[];
  /** rounds over all unknowns */
  readonly rounds: number;
}

/** of the largest unknown: a round that changes less is the last */
const SETTLED = 1e-8;
const MOST_ROUNDS = 1000;

/** `rows[i]` is a row of A; starts at `start`, or within the bounds nearest to it. An unknown that no row has stays there. */
export function boundedLeastSquares(
  rows: readonly ArrayLike<number>[],
  y: readonly number[],
  low: readonly number[],
  high: readonly number[],
  start: readonly number[],
): Bounded {
  const n = start.length;
  const normal = normalMatrix(rows, n);
  const right = Float64Array.from({ length: n }, (_, j) =>
    rows.reduce((sum, row, i) => sum + row[j]! * y[i]!, 0),
  );
  const x = start.map((value, j) => Math.min(Math.max(value, low[j]!), high[j]!));
  for (let rounds = 1; ; rounds++) {
    let change = 0;
    for (let j = 0; j < n; j++) {
      const own = normal[j * n + j]!;
      if (!(own > 0)) continue;
      let rest = right[j]!;
      for (let k = 0; k < n; k++) rest -= normal[j * n + k]! * x[k]!;
      const next = Math.min(Math.max(x[j]! + rest / own, low[j]!), high[j]!);
      change = Math.max(change, Math.abs(next - x[j]!));
      x[j] = next;
    }
    const size = x.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    if (change <= SETTLED * size || rounds === MOST_ROUNDS) return { x, rounds };
  }
}

/** AᵀA, by rows. */
function normalMatrix(rows: readonly ArrayLike<number>[], n: number): Float64Array {
  const normal = new Float64Array(n * n);
  for (const row of rows) {
    for (let j = 0; j < n; j++) {
      const a = row[j]!;
      if (a === 0) continue;
      for (let k = j; k < n; k++) normal[j * n + k]! += a * row[k]!;
    }
  }
  for (let j = 0; j < n; j++) for (let k = 0; k < j; k++) normal[j * n + k] = normal[k * n + j]!;
  return normal;
}
