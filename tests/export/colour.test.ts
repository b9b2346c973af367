/** Colours: the transfer function of sRGB against the engine's power function, for all 256 values. */
import { describe, expect, it } from 'vitest';
import { displayBytes, linearRgb } from '../../src/export/colour.ts';

const hex = (value: number) => `#${value.toString(16).padStart(2, '0').repeat(3)}`;

describe('colour', () => {
  it('reads hexadecimal digits, large and small', () => {
    expect(displayBytes('#01fFa0')).toEqual([1, 255, 160]);
  });

  it('is linear as IEC 61966-2-1 has it, within two last bits', () => {
    for (let value = 0; value < 256; value++) {
      const display = value / 255;
      const expected = display <= 0.04045 ? display / 12.92 : ((display + 0.055) / 1.055) ** 2.4;
      const found = linearRgb(hex(value))[1];
      expect(Math.abs(found - expected), hex(value)).toBeLessThanOrEqual(4.5e-16 * expected);
    }
  });

  it('keeps black and white and rises between', () => {
    const values = Array.from({ length: 256 }, (_, i) => linearRgb(hex(i))[0]);
    expect(values[0]).toBe(0);
    expect(values[255]).toBe(1);
    expect(values.every((value, i) => i === 0 || value > values[i - 1]!)).toBe(true);
  });
});
