/** Light as display values, for files. */
import { pow } from '../math/pow.ts';

export { displayBytes, linearRgb, type Rgb } from '../document/paint.ts';

/** Light, 0–1 → display value, 0–1. */
export function display(light: number): number {
  const x = Math.min(1, Math.max(0, light));
  return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055;
}
