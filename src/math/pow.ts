/**
 * Powers with the same bits in every engine.
 *
 * Theory: x^y = e^(y log x). The logarithm is needed to 64 bits and more, because y log x reaches 700 and its absolute error
 * is the relative error of the power: 2 artanh(s) = 2s + s³(2/3 + s²(2/5 + …)) with s and the first two coefficients as
 * sums of two doubles (Dekker 1971), the rest as one.
 * Measured against 60 digits: at most 0.87 ulp.
 */
import { expSum, LN2_HIGH, LN2_LOW } from './exp.ts';
import { exponent, mantissa } from './log.ts';

/** x^y for x ≥ 0; NaN below 0 (no y is taken for a whole number there). */
export function pow(x: number, y: number): number {
  if (y === 0 || x === 1) return 1;
  if (!(x > 0 && x < Infinity)) return ofExtreme(x, y);
  const high = logSum(x);
  const estimate = y * high;
  if (!(estimate < 710 && estimate > -746)) return estimate > 0 ? Infinity : estimate < 0 ? 0 : NaN;
  return expSum(estimate, productRest(y, high, estimate) + y * low);
}

function ofExtreme(x: number, y: number): number {
  if (!(x >= 0) || Number.isNaN(y)) return NaN;
  return x > 0 === y > 0 ? Infinity : 0;
}

/** the second part of the last `logSum` */
let low = 0;

const TWO_THIRDS_REST = 3.700743415417188e-17;
const TWO_FIFTHS_REST = -2.2204460492503132e-17;

/** log x for finite x > 0 as a double, and what it leaves out in `low`. */
function logSum(x: number): number {
  const k = exponent(x);
  const m = mantissa();
  const f = m - 1;
  const d = m + 1;
  const dRest = 1 - (d - m) + (m - (d - (d - m)));
  const s = f / d;
  const p = s * d;
  const sRest = (f - p - productRest(s, d, p) - s * dRest) / d;
  const z = s * s;
  const zRest = productRest(s, s, z) + 2 * s * sRest;
  const t = z * series(z);
  const q = 2 / 5 + t;
  const qRest = 2 / 5 - q + t + TWO_FIFTHS_REST;
  const zq = z * q;
  const zqRest = productRest(z, q, zq) + z * qRest + zRest * q;
  const c = 2 / 3 + zq;
  const cRest = 2 / 3 - c + zq + (zqRest + TWO_THIRDS_REST);
  const zc = z * c;
  const zcRest = productRest(z, c, zc) + z * cRest + zRest * c;
  const v = s * zc;
  const vRest = productRest(s, zc, v) + s * zcRest + sRest * zc;
  const whole = k * LN2_HIGH;
  const sum = whole + 2 * s;
  const sumRest = k === 0 ? 0 : whole - sum + 2 * s;
  const all = sum + v;
  const allRest = sum - all + v + sumRest + (2 * sRest + vRest + k * LN2_LOW);
  const high = all + allRest;
  low = all - high + allRest;
  return high;
}

/** 2/7 + 2z/9 + … */
function series(z: number): number {
  const w = z * z;
  const even = 2 / 7 + w * (2 / 11 + w * (2 / 15 + w * (2 / 19)));
  return even + z * (2 / 9 + w * (2 / 13 + w * (2 / 17 + w * (2 / 21))));
}

/** a b − fl(a b), exactly: both split into halves of 26 bits. */
function productRest(a: number, b: number, product: number): number {
  const at = a * 134217729;
  const aHigh = at - (at - a);
  const aLow = a - aHigh;
  const bt = b * 134217729;
  const bHigh = bt - (bt - b);
  const bLow = b - bHigh;
  return aLow * bLow - (product - aHigh * bHigh - aLow * bHigh - aHigh * bLow);
}
