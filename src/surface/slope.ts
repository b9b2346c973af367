/** Derivatives of functions known by their values between breaks: five of them, never across a break. */

/** u between the values: their error is h⁴f⁽⁵⁾/30, and a thousandth smooths no feature that a pen can draw */
const STEP = 1e-3;
const PLACES = [0, 1, 2, 3, 4] as const;

/** df/du at u, at a break on its `side`; values may jump by multiples of `period`. */
export function slope(
  f: (u: number, side: -1 | 1) => number,
  u: number,
  side: -1 | 1,
  breaks: readonly number[],
  period = Infinity,
): number {
  const [from, to] = pieceOf(breaks, u, side);
  const step = Math.min(STEP, (to - from) / 4);
  if (!(step > 0)) return 0;
  const first = Math.min(Math.max(u - 2 * step, from), to - 4 * step);
  if (first === u - 2 * step)
    return central(f, [first, first + step, first + 3 * step, Math.min(first + 4 * step, to)], step, period);
  const centre = f(u, side);
  const values = PLACES.map((i) => {
    const value = f(i === 4 ? Math.min(first + 4 * step, to) : first + i * step, i === 4 ? -1 : 1) - centre;
    return period < Infinity ? value - period * Math.round(value / period) : value;
  });
  const x = (u - first) / step;
  return PLACES.reduce<number>((sum, i) => sum + values[i]! * weight(i, x), 0) / step;
}

/** (f(−2) − 8 f(−1) + 8 f(1) − f(2))/12 for each step: with u in the middle of the places its own value has no weight. */
function central(
  f: (u: number, side: -1 | 1) => number,
  [a, b, c, d]: readonly [number, number, number, number],
  step: number,
  period: number,
): number {
  const [before, after] = [f(b, 1), f(c, 1)];
  // no two values that are compared are further apart than two steps
  const gap = (x: number): number => (period < Infinity ? x - period * Math.round(x / period) : x);
  const middle = gap(after - before);
  return (gap(f(a, 1) - before) + 7 * middle - gap(f(d, -1) - after)) / (12 * step);
}

/** The derivative at x of the quartic that is 1 at place i and 0 at the others. */
function weight(i: number, x: number): number {
  let sum = 0;
  for (const j of PLACES) {
    if (j === i) continue;
    let product = 1 / (i - j);
    for (const k of PLACES) if (k !== i && k !== j) product *= (x - k) / (i - k);
    sum += product;
  }
  return sum;
}

/** The two breaks around u. */
function pieceOf(breaks: readonly number[], u: number, side: -1 | 1): readonly [number, number] {
  for (let i = 1; i < breaks.length - 1; i++) {
    if (side === 1 ? u < breaks[i]! : u <= breaks[i]!) return [breaks[i - 1]!, breaks[i]!];
  }
  return [breaks[breaks.length - 2]!, breaks[breaks.length - 1]!];
}
