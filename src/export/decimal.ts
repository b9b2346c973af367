/**
 * Decimal digits of a float32: as few as lead back to the same bits. (String() writes the float64 that holds it, with
 * 17 digits where 8 do.) Only + − × ÷ and rounding for the usual range, so that it is fast and the same everywhere;
 * decimals within a ten-millionth of the border to a neighbour get another digit, because readers that go by
 * float64 might round them across.
 */
export interface Digits {
  /** digits / 10^places × 10^exponent is the value */
  readonly digits: number;
  readonly places: number;
  readonly exponent: number;
}

export const POWERS: readonly number[] = Array.from({ length: 17 }, (_, i) => Number(`1e${i}`));

/** Outside of these an exponent is shorter. */
const LEAST_PLAIN = 1e-4;
const MOST_PLAIN = 1e9;

/** Of a float32 that is finite and not negative. */
export function digitsOf(value: number): Digits {
  if (value === 0) return { digits: 0, places: 0, exponent: 0 };
  if (value < LEAST_PLAIN || value >= MOST_PLAIN) return withExponent(value);
  for (let places = 0; ; places++) {
    const digits = Math.round(value * POWERS[places]!);
    if (places === MOST_PLACES || leadsTo(value, digits / POWERS[places]!)) {
      return { digits, places, exponent: 0 };
    }
  }
}

/** nine digits always do, and a plain value begins with at most four zeros */
const MOST_PLACES = 14;

function withExponent(value: number): Digits {
  for (let precision = 1; ; precision++) {
    const text = value.toExponential(precision - 1);
    if (precision < 17 && !leadsTo(value, Number(text))) continue;
    const [mantissa, exponent] = text.split('e');
    return {
      digits: Number(mantissa!.replace('.', '')),
      places: precision - 1,
      exponent: Number(exponent),
    };
  }
}

function leadsTo(value: number, decimal: number): boolean {
  return Math.fround(decimal) === value && Math.fround(value + (decimal - value) * 1.0000001) === value;
}
