/**
 * atan and atan2 for inner loops: the same bits in every engine, no table, no allocation, one division.
 *
 * Theory: the angle is taken from the nearest of 0, π/4, π/2, … by the addition theorem, with the division that makes the
 * tangent left to the end; what remains is below tan(π/8), where a polynomial of eleven terms (Chebyshev, 5.5e-18) does.
 * Departure from trig.ts, whose atan2 knows zeros, signs and infinities: this one is for finite arguments that are not both 0,
 * a zero counts as positive, and it is one function with one series, which engines can inline (the Cauchy segment: 52 ns
 * against 63 with the engine's atan2 on the same machine). The series is summed by pairs and fours (Estrin), and every octant has
 * its own base, so that little waits for what comes before it: 5 ns less than two rows of Horner and a mirror at the end.
 * Measured against 60 digits: at most 1.8 ulp.
 */

import { PI } from './trig.ts';

const TAN_8 = 0.41421356237309503;
const QUARTER = 0.7853981633974483;
const QUARTER_REST = 3.061616997868383e-17;
const HALF = 1.5707963267948966;
const HALF_REST = 6.123233995736766e-17;
/** 3π/4 */
const THREE = 2.356194490192345;
const THREE_REST = 9.184850993605148e-17;
const PI_REST = 1.2246467991473532e-16;

/** The angle of (x, y), −π…π. Finite arguments, not both 0. */
export function fastAtan2(y: number, x: number): number {
  const ay = y < 0 ? -y : y;
  let n = ay;
  let d = x;
  let base = 0;
  let rest = 0;
  if (TAN_8 * ay >= (x < 0 ? -x : x)) {
    n = -x;
    d = ay;
    base = HALF;
    rest = HALF_REST;
  } else if (x > 0) {
    if (ay > TAN_8 * x) {
      n = ay - x;
      d = ay + x;
      base = QUARTER;
      rest = QUARTER_REST;
    }
  } else if (ay > -TAN_8 * x) {
    n = -ay - x;
    d = ay - x;
    base = THREE;
    rest = THREE_REST;
  } else {
    base = PI;
    rest = PI_REST;
  }
  const t = n / d;
  const z = t * t;
  const w = z * z;
  const v = w * w;
  const low =
    -0.3333333333333333 + z * 0.1999999999999548 + w * (-0.14285714284657894 + z * 0.11111111014561013);
  const middle =
    -0.09090904549884611 + z * 0.07692182535116648 + w * (-0.06664502215671447 + z * 0.058580687568615106);
  const high = -0.05085030492810941 + z * 0.03921955253255129 + w * -0.019162068915902577;
  const angle = base + (t + (t * z * (low + v * (middle + v * high)) + rest));
  return y < 0 ? -angle : angle;
}
