/**
 * min |A x − y|² with low ≤ x ≤ high, for tens to a few hundred unknowns, over the normal equations: coordinates in turn, each set to its
 * best within its bounds (Hildreth 1957, d'Esopo 1959), tell which are at bounds; the others are then solved for at once (Cholesky), as far
 * as the bounds allow. By turns alone outlines took 300 rounds; so they take 2 to 6. For rows that are well scaled, and damped where they
 * say little.
 */

export interface Bounded {
  readonly x: readonly number[];
  /** rounds over all unknowns */
  readonly rounds: number;
}

/** AᵀA by rows, and Aᵀy: what rows are summed up in, one after the other. */
export interface Normal {
  readonly matrix: Float64Array;
  readonly right: Float64Array;
}

/** of the largest unknown: a round that changes less is the last */
const SETTLED = 1e-8;
const MOST_ROUNDS = 60;
/** of all unknowns in turn, after each jump */
const TURNS = 2;
/** of the diagonal: what is left of it below is rounding */
const DEPENDENT = 1e-13;

/** `rows[i]` is a row of A; starts at `start`, or within the bounds nearest to it. An unknown that no row has stays there. */
export function boundedLeastSquares(
  rows: readonly ArrayLike<number>[],
  y: readonly number[],
  low: readonly number[],
  high: readonly number[],
  start: readonly number[],
): Bounded {
  const normal = emptyNormal(start.length);
  rows.forEach((row, i) => {
    addRow(normal, row, y[i]!);
  });
  return boundedMinimum(normal, low, high, start);
}

export const emptyNormal = (n: number): Normal => ({
  matrix: new Float64Array(n * n),
  right: new Float64Array(n),
});

/** To the upper triangle: `boundedMinimum` makes it whole. */
export function addRow({ matrix, right }: Normal, row: ArrayLike<number>, y: number): void {
  const n = right.length;
  for (let j = 0; j < n; j++) {
    const a = row[j]!;
    if (a === 0) continue;
    right[j] = right[j]! + a * y;
    const at = j * n;
    for (let k = j; k < n; k++) matrix[at + k] = matrix[at + k]! + a * row[k]!;
  }
}

/** A row with these few entries, `times` over. */
export function addEntries(
  { matrix, right }: Normal,
  entries: readonly (readonly [number, number])[],
  y: number,
  times: number,
): void {
  for (const [j, a] of entries) {
    right[j] = right[j]! + times * a * y;
    for (const [k, b] of entries) {
      const at = j * right.length + k;
      if (k >= j) matrix[at] = matrix[at]! + times * a * b;
    }
  }
}

/** min ½ xᵀ M x − rᵀ x within the bounds, nearly so after the `most` rounds: each comes nearer. */
export function boundedMinimum(
  { matrix, right }: Normal,
  low: ArrayLike<number>,
  high: ArrayLike<number>,
  start: readonly number[],
  most = MOST_ROUNDS,
): Bounded {
  const n = start.length;
  for (let j = 0; j < n; j++) for (let k = 0; k < j; k++) matrix[j * n + k] = matrix[k * n + j]!;
  const x = Float64Array.from(start, (value, j) => Math.min(Math.max(value, low[j]!), high[j]!));
  const search = new Search(matrix, right, low, high, x);
  for (let rounds = 1; ; rounds++) {
    let change = search.jump();
    for (let turn = 0; turn < TURNS; turn++) change = Math.max(change, search.turns());
    const size = x.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    if (change <= SETTLED * size || rounds === most) return { x: [...x], rounds };
  }
}

class Search {
  readonly #matrix: Float64Array;
  readonly #right: Float64Array;
  readonly #low: ArrayLike<number>;
  readonly #high: ArrayLike<number>;
  readonly #x: Float64Array;
  readonly #factor: Float64Array;
  readonly #step: Float64Array;

  constructor(
    matrix: Float64Array,
    right: Float64Array,
    low: ArrayLike<number>,
    high: ArrayLike<number>,
    x: Float64Array,
  ) {
    this.#matrix = matrix;
    this.#right = right;
    this.#low = low;
    this.#high = high;
    this.#x = x;
    this.#factor = new Float64Array(matrix.length);
    this.#step = new Float64Array(x.length);
  }

  /** Each unknown in turn; the largest change. */
  turns(): number {
    const x = this.#x;
    let change = 0;
    for (let j = 0; j < x.length; j++) {
      const own = this.#matrix[j * x.length + j]!;
      if (!(own > 0)) continue;
      const next = this.#within(j, x[j]! + this.#rest(j) / own);
      change = Math.max(change, Math.abs(next - x[j]!));
      x[j] = next;
    }
    return change;
  }

  /** All that are not held by a bound at once, each up to its own bound if that is better, or else all up to the first; the largest change. */
  jump(): number {
    const x = this.#x;
    const free: number[] = [];
    const rests: number[] = [];
    for (let j = 0; j < x.length; j++) {
      const rest = this.#rest(j);
      if (!(this.#matrix[j * x.length + j]! > 0)) continue;
      if (x[j]! <= this.#low[j]! && rest <= 0) continue;
      if (x[j]! >= this.#high[j]! && rest >= 0) continue;
      this.#step[free.length] = rest;
      free.push(j);
      rests.push(rest);
    }
    this.#solve(free);
    const cut = free.map((j, i) => this.#within(j, x[j]! + this.#step[i]!) - x[j]!);
    if (this.#gain(free, rests, cut) < 0) {
      let share = 1;
      free.forEach((j, i) => {
        const by = this.#step[i]!;
        const room = by > 0 ? this.#high[j]! - x[j]! : this.#low[j]! - x[j]!;
        if (by !== 0 && room / by < share) share = room / by;
      });
      for (const i of cut.keys()) cut[i] = share * this.#step[i]!;
    }
    let change = 0;
    free.forEach((j, i) => {
      x[j] = this.#within(j, x[j]! + cut[i]!);
      change = Math.max(change, Math.abs(cut[i]!));
    });
    return change;
  }

  /** By how much the sum of squares, halved, falls with a step. */
  #gain(free: readonly number[], rests: readonly number[], step: readonly number[]): number {
    const n = this.#x.length;
    let gain = 0;
    free.forEach((j, i) => {
      let sum = rests[i]!;
      for (let k = 0; k < free.length; k++) sum -= 0.5 * this.#matrix[j * n + free[k]!]! * step[k]!;
      gain += sum * step[i]!;
    });
    return gain;
  }

  #within(j: number, value: number): number {
    return Math.min(Math.max(value, this.#low[j]!), this.#high[j]!);
  }

  /** What the others leave of the right side. */
  #rest(j: number): number {
    const x = this.#x;
    const at = j * x.length;
    let rest = this.#right[j]!;
    for (let k = 0; k < x.length; k++) rest -= this.#matrix[at + k]! * x[k]!;
    return rest;
  }

  /** Cholesky for these unknowns, the right side in `#step` and the solution, too; those that depend on others stay. */
  #solve(free: readonly number[]): void {
    const f = this.#factor;
    const step = this.#step;
    const n = this.#x.length;
    for (let i = 0; i < free.length; i++) {
      const row = free[i]! * n;
      let value = step[i]!;
      for (let j = 0; j <= i; j++) {
        let sum = this.#matrix[row + free[j]!]!;
        for (let k = 0; k < j; k++) sum -= f[i * n + k]! * f[j * n + k]!;
        if (j < i) {
          f[i * n + j] = sum / f[j * n + j]!;
          value -= f[i * n + j]! * step[j]!;
        } else f[i * n + i] = sum > DEPENDENT * this.#matrix[row + free[i]!]! ? Math.sqrt(sum) : Infinity;
      }
      step[i] = value / f[i * n + i]!;
    }
    for (let i = free.length - 1; i >= 0; i--) {
      let value = step[i]!;
      for (let k = i + 1; k < free.length; k++) value -= f[k * n + i]! * step[k]!;
      step[i] = value / f[i * n + i]!;
    }
  }
}
