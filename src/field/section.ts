/**
 * Cross sections other than round ones (Tai et al. 2004 §4.2): the plane across a skel is mapped radially, q' = m(q) q, onto
 * that of the plain ("generic") skel, whose field is then taken. This is the inverse of the paper's map T_z: evaluators need
 * T⁻¹, and (19) prints T forward and (20) its inverse.
 */

/** [m, ∂m/∂x, ∂m/∂y] */
export type Stretch = Float64Array;

/** [move, bend]: how far q' goes, and how far it is then from where the derivatives at the centre take it */
export type Move = Float64Array;

export interface Section {
  /** m at (x, y); 1 at the origin */
  value(x: number, y: number): number;
  evaluate(x: number, y: number, out: Stretch): void;
  /** Writes bounds on the way of q' when q goes from (x, y), where m is `m`, by at most rx and ry; bend Infinity where not known. */
  move(x: number, y: number, m: number, rx: number, ry: number, out: Move): void;
  /** half sizes of what is mapped into the disc of radius `r` */
  extent(r: number): readonly [x: number, y: number];
}

export const ROUND: Section = {
  value: () => 1,
  evaluate(_x, _y, out) {
    out[0] = 1;
    out[1] = 0;
    out[2] = 0;
  },
  move(_x, _y, _m, rx, ry, out) {
    out[0] = Math.max(rx, ry);
    out[1] = 0;
  },
  extent: (r) => [r, r],
};

/** |q'| as sections compute it: of itself */
const ROUNDING = 1e-13;

/**
 * The farthest way of q' when |q'| goes from `at` to somewhere from `low` to `high`, and the direction by the angle in which
 * a disc of `radius` is seen from the distance `rho`.
 */
export function radialMove(rho: number, radius: number, at: number, low: number, high: number): number {
  const sine = radius < rho ? radius / rho : 1;
  const square = sine * sine;
  // of the chord on the unit circle
  const chord2 = sine < 1 ? (2 * square) / (1 + Math.sqrt(1 - square)) : 4;
  const along = Math.max(high - at, at - low);
  return Math.sqrt(along * along + at * high * chord2) * (1 + ROUNDING) + ROUNDING * high;
}

/** How far a map q' = ρ h(θ) is from linear, `most` a bound on |h'' + h|: its only second derivative is that over ρ, around. */
export const radialBend = (rho: number, radius: number, most: number) =>
  radius < rho ? (0.5 * most * radius * radius) / (rho - radius) : Infinity;

/** The same for |q'| that rises with |x| and |y|. */
export function risingMove(
  length: (x: number, y: number) => number,
  x: number,
  y: number,
  at: number,
  rx: number,
  ry: number,
): number {
  const [ax, ay] = [Math.abs(x), Math.abs(y)];
  const low = length(Math.max(ax - rx, 0), Math.max(ay - ry, 0));
  const rho = Math.sqrt(x * x + y * y);
  return radialMove(rho, Math.max(rx, ry), at, low, length(ax + rx, ay + ry));
}
