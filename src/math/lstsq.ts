/**
 * Small dense least squares, min |A x − y|, by Householder reflections (normal equations would square the condition).
 * For hundreds of rows and tens of unknowns; banded systems have banded.ts.
 */

/** `rows[i]` is a row of A, at least as many as unknowns. RangeError when the columns of A are not independent. */
export function leastSquares(rows: readonly (readonly number[])[], y: readonly number[]): number[] {
  const n = rows[0]?.length ?? 0;
  if (rows.length < n || rows.length !== y.length) {
    throw new RangeError(`${rows.length} rows and ${y.length} values for ${n} unknowns`);
  }
  const a = rows.map((row) => [...row]);
  const b = [...y];
  const scale = Math.sqrt(a.reduce((sum, row) => sum + row.reduce((s, v) => s + v * v, 0), 0));
  for (let k = 0; k < n; k++) reflect(a, b, k, 1e-13 * scale);
  return backSubstituted(a, b, n);
}

/** Makes column k zero below the diagonal. */
function reflect(a: number[][], b: number[], k: number, tiny: number): void {
  let norm = 0;
  for (let i = k; i < a.length; i++) norm += a[i]![k]! * a[i]![k]!;
  norm = Math.sqrt(norm);
  if (!(norm > tiny)) throw new RangeError(`unknown ${k} is not determined by the rows`);
  const top = a[k]![k]!;
  const diagonal = top > 0 ? -norm : norm;
  const v = a.map((row, i) => (i < k ? 0 : row[k]!));
  v[k] = top - diagonal;
  const beta = 1 / (norm * (norm + Math.abs(top)));
  for (let j = k; j <= a[k]!.length; j++) {
    const isRight = j === a[k]!.length;
    let dot = 0;
    for (let i = k; i < a.length; i++) dot += v[i]! * (isRight ? b[i]! : a[i]![j]!);
    for (let i = k; i < a.length; i++) {
      if (isRight) b[i]! -= beta * dot * v[i]!;
      else a[i]![j]! -= beta * dot * v[i]!;
    }
  }
}

function backSubstituted(a: readonly (readonly number[])[], b: readonly number[], n: number): number[] {
  const x = new Array<number>(n).fill(0);
  for (let i = n - 1; i >= 0; i--) {
    let sum = b[i]!;
    for (let j = i + 1; j < n; j++) sum -= a[i]![j]! * x[j]!;
    x[i] = sum / a[i]![i]!;
  }
  return x;
}
