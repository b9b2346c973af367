/**
 * Symmetric positive definite systems with few diagonals, solved in O(n·b²) by Cholesky's factorisation.
 *
 * The cyclic system of a closed curve is solved by bordering: the last b unknowns are taken out, which leaves an open
 * band; the small dense rest (their Schur complement) is solved by the same routine with full bandwidth. Tried instead:
 * Woodbury on the wrapped corners, which needs twice the right-hand sides.
 */

/** Lower diagonals by row: `rows[i][d]` is the entry (i, i − d); on a cyclic matrix the index i − d wraps. */
export type BandRows = readonly (readonly number[])[];

/**
 * Solves A x = y for several right-hand sides, `columns[k][i]`. Every row of `rows` has bandwidth + 1 entries
 * (those outside the matrix are ignored). RangeError when A is not positive definite.
 */
export function solveBanded(rows: BandRows, columns: readonly (readonly number[])[]): number[][] {
  const factor = factorise(rows);
  return columns.map((y) => backward(factor, forward(factor, y)));
}

/** The same for a cyclic band matrix; needs more than twice as many rows as its bandwidth, else it is dense. */
export function solveCyclicBanded(rows: BandRows, columns: readonly (readonly number[])[]): number[][] {
  const n = rows.length;
  const b = (rows[0]?.length ?? 1) - 1;
  if (b === 0) return solveBanded(rows, columns);
  if (n <= 2 * b) return solveBanded(denseRows(rows), columns);
  const inner = n - b;
  const coupling = Array.from({ length: b }, (_, k) => couplingColumn(rows, inner, inner + k));
  const factor = factorise(rows.slice(0, inner));
  const solved = coupling.map((c) => backward(factor, forward(factor, c)));
  const schur = Array.from({ length: b }, (_, i) =>
    Array.from({ length: b }, (_, d) =>
      d > i ? 0 : rows[inner + i]![d]! - dot(coupling[i]!, solved[i - d]!),
    ),
  );
  const small = factorise(schur);
  return columns.map((y) => {
    const head = backward(factor, forward(factor, y.slice(0, inner)));
    const rest = Array.from({ length: b }, (_, k) => y[inner + k]! - dot(coupling[k]!, head));
    const tail = backward(small, forward(small, rest));
    return [...head.map((h, i) => tail.reduce((sum, t, k) => sum - solved[k]![i]! * t, h)), ...tail];
  });
}

/** L with A = L Lᵀ, stored like A. */
function factorise(rows: BandRows): number[][] {
  const factor = rows.map((row) => [...row]);
  factor.forEach((row, i) => {
    for (let d = Math.min(row.length - 1, i); d >= 0; d--) {
      const j = i - d;
      const other = factor[j]!;
      let sum = row[d]!;
      // columns before j that both rows reach
      for (let k = 1; d + k < row.length && k < other.length && k <= j; k++) sum -= row[d + k]! * other[k]!;
      if (d > 0) row[d] = sum / other[0]!;
      else if (sum > 0) row[0] = Math.sqrt(sum);
      else throw new RangeError(`matrix is not positive definite: pivot ${sum} in row ${i}`);
    }
  });
  return factor;
}

function forward(factor: BandRows, y: readonly number[]): number[] {
  const x = [...y];
  factor.forEach((row, i) => {
    let sum = x[i]!;
    for (let d = 1; d < row.length && d <= i; d++) sum -= row[d]! * x[i - d]!;
    x[i] = sum / row[0]!;
  });
  return x;
}

function backward(factor: BandRows, y: readonly number[]): number[] {
  const x = [...y];
  for (let i = factor.length - 1; i >= 0; i--) {
    const row = factor[i]!;
    const value = x[i]! / row[0]!;
    x[i] = value;
    for (let d = 1; d < row.length && d <= i; d++) x[i - d]! -= row[d]! * value;
  }
  return x;
}

/** What unknown `column` (one of those taken out) contributes to the first `inner` equations. */
function couplingColumn(rows: BandRows, inner: number, column: number): number[] {
  const n = rows.length;
  const out = new Array<number>(inner).fill(0);
  const row = rows[column]!;
  for (let d = 1; d < row.length; d++) {
    if (column - d < inner) out[column - d]! += row[d]!;
    const wrapped = (column + d) % n;
    if (wrapped < inner && column + d >= n) out[wrapped]! += rows[wrapped]![d]!;
  }
  return out;
}

/** A cyclic matrix so small that its band overlaps itself, as full lower rows. */
function denseRows(rows: BandRows): number[][] {
  const n = rows.length;
  const dense = Array.from({ length: n }, () => new Array<number>(n).fill(0));
  rows.forEach((row, i) => {
    row.forEach((value, d) => {
      const j = (((i - d) % n) + n) % n;
      dense[i]![j]! += value;
      if (d > 0) dense[j]![i]! += value;
    });
  });
  return dense.map((row, i) => Array.from({ length: n }, (_, d) => (d > i ? 0 : row[i - d]!)));
}

function dot(a: readonly number[], b: readonly number[]): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += a[i]! * b[i]!;
  return sum;
}
