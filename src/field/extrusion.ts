/**
 * Extrusion along y (Tai et al. (20), whose left side is the generic radius): r² = x² + |y|^α, a slab of half thickness
 * about 1 mm whatever the radius, times the warp's scale in y: a slider for that one is a thickness.
 *
 * Above 1e12 (a radius of 1 km) |y|^α goes on as a square: float32 would overflow not far outside for α = 100.
 */
import { pow } from '../math/pow.ts';
import { FieldError } from '../skeleton/skeleton.ts';
import { risingMove, type Section } from './section.ts';

export interface Extrusion {
  readonly type: 'extrusion';
  /** α, 2–100: how sharp the edges are */
  readonly exponent: number;
}

const MOST = 1e12;

export function extrusion({ exponent }: Extrusion): Section {
  if (!(exponent >= 2 && exponent <= 100)) throw new FieldError(`exponent must be 2–100, got ${exponent}`);
  const highest = pow(MOST, 1 / exponent);
  const power = (y: number) => {
    const beyond = y / highest;
    return Math.abs(beyond) <= 1 ? pow(Math.abs(y), exponent) : MOST * beyond * beyond;
  };
  const generic = (x: number, y: number) => Math.sqrt(x * x + power(y));
  return {
    value(x, y) {
      const rho2 = x * x + y * y;
      return rho2 > 0 ? Math.sqrt((x * x + power(y)) / rho2) : 1;
    },
    evaluate(x, y, out) {
      const rho2 = x * x + y * y;
      const high = power(y);
      const m2 = rho2 > 0 ? (x * x + high) / rho2 : 1;
      const m = Math.sqrt(m2);
      const half = m > 0 && rho2 > 0 ? 1 / (2 * m * rho2) : 0;
      const steep = y === 0 ? 0 : ((Math.abs(y) <= highest ? exponent : 2) * high) / y;
      out[0] = m;
      out[1] = half * 2 * x * (1 - m2);
      out[2] = half * (steep - 2 * y * m2);
    },
    move(x, y, m, rx, ry, out) {
      out[0] = risingMove(generic, x, y, m * Math.sqrt(x * x + y * y), rx, ry);
      out[1] = Infinity;
    },
    extent: (r) => [r, r * r < MOST ? pow(r, 2 / exponent) : highest * (r / Math.sqrt(MOST))],
  };
}
