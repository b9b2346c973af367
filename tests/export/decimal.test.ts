/** Decimal digits: read back to the bit, by float64 and by exact arithmetic, and no shorter text does the same. */
import { describe, expect, it } from 'vitest';
import { ByteWriter } from '../../src/export/bytes.ts';
import { random } from '../fixtures/random.ts';
import { asText } from './readers.ts';

function written(values: readonly number[]): string[] {
  const out = new ByteWriter();
  for (const value of values) {
    out.float(value);
    out.ascii(' ');
  }
  return asText(out.bytes()).trim().split(' ');
}

/** The bits as a float32, whatever they are, but finite. */
function floatOf(bits: number): number {
  const value = new Float32Array(Uint32Array.of(bits).buffer)[0]!;
  return Number.isFinite(value) ? value : 1;
}

/** A decimal as a fraction of whole numbers. */
function fraction(text: string): readonly [bigint, bigint] {
  const [mantissa, exponent = '0'] = text.split('e');
  const [whole, part = ''] = mantissa!.split('.');
  const power = Number(exponent) - part.length;
  const digits = BigInt(whole! + part);
  return power >= 0 ? [digits * 10n ** BigInt(power), 1n] : [digits, 10n ** BigInt(-power)];
}

/** A float64 as a fraction. */
function exact(value: number): readonly [bigint, bigint] {
  let denominator = 1n;
  let numerator = Math.abs(value);
  while (!Number.isInteger(numerator)) {
    numerator *= 2;
    denominator *= 2n;
  }
  return [BigInt(numerator), denominator];
}

/** Nearer to `value` than half way to the next float32 below and above, without any rounding. */
function isNearest(text: string, value: number): boolean {
  const bits = new Uint32Array(Float32Array.of(Math.abs(value)).buffer)[0]!;
  const [n, d] = fraction(text.replace(/^-/, ''));
  return [bits - 1, bits + 1].every((neighbour) => {
    const [a, b] = exact((floatOf(neighbour) + Math.abs(value)) / 2);
    return neighbour > bits ? n * b < a * d : n * b > a * d;
  });
}

const significant = (text: string): number =>
  text.replace(/e.*|-/g, '').replace('.', '').replace(/^0+/, '').replace(/0+$/, '').length;

const LARGEST = 3.4028234663852886e38;
const SAMPLES: readonly number[] = [
  ...[
    0.1,
    1 / 3,
    50,
    99.999,
    123.456,
    1e-4,
    9.9999e-5,
    0.00012345678,
    1e-7,
    16777216,
    999999999,
    1e9,
    3.4e38,
  ],
  ...[1.401298464324817e-45, 1.1754943508222875e-38, 3.4028234663852886e38, 0.5, 8388607.5, 1234567.9],
].map(Math.fround);

/** What is wrong with the text of a value; null when nothing is. */
function complaint(value: number, text: string): string | null {
  const so = `${text} for ${value}`;
  if (!/^-?\d+(\.\d+)?(e-?\d+)?$/.test(text)) return `not a number: ${so}`;
  if (Math.fround(Number(text)) !== value + 0) return `read back as another: ${so}`;
  if (value === 0) return null;
  if (Math.abs(value) < LARGEST && !isNearest(text, value)) return `nearer to a neighbour: ${so}`;
  const digits = significant(text);
  // Whole numbers are written out.
  if (digits === 1 || Number.isInteger(value)) return null;
  const shorter = value.toPrecision(digits - 1);
  return Math.fround(Number(shorter)) === value ? `could be ${shorter}: ${so}` : null;
}

const complaints = (values: readonly number[]): string[] => {
  const texts = written(values);
  return values.map((value, i) => complaint(value, texts[i]!)).filter((found) => found !== null);
};

describe('decimal', () => {
  it('writes what a person would', () => {
    const values = [0, -0, 1, -1, 0.5, 50, 100, -12.25, 0.1, 1000000, 1e-7, -1.5e20].map(Math.fround);
    const texts = ['0', '0', '1', '-1', '0.5', '50', '100', '-12.25', '0.1', '1000000', '1e-7', '-1.5e20'];
    expect(written(values)).toEqual(texts);
  });

  it('is read back to the bit, and no shorter decimal is: chosen values', () => {
    expect(complaints([...SAMPLES, ...SAMPLES.map((x) => -x)])).toEqual([]);
  });

  it('is read back to the bit, and no shorter decimal is: 20,000 of any bits, seed 1', () => {
    const next = random(1);
    expect(complaints(Array.from({ length: 20_000 }, () => floatOf(Math.floor(next() * 2 ** 32))))).toEqual(
      [],
    );
  });

  it('is read back to the bit, and no shorter decimal is: 20,000 coordinates, seed 2', () => {
    const next = random(2);
    const coordinate = () => Math.fround((next() - 0.5) * 10 ** (6 * next() - 2));
    expect(complaints(Array.from({ length: 20_000 }, coordinate))).toEqual([]);
  });
});
