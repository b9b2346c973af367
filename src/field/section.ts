/**
 * Cross sections other than round ones (Tai et al. 2004 §4.2): the plane across a skel is mapped radially, q' = m(q) q, onto
 * that of the plain ("generic") skel, whose field is then taken. This is the inverse of the paper's map T_z: evaluators need
 * T⁻¹, and (19) and (20) print one direction each (FIELD-NOTES §1).
 */

/** [m, ∂m/∂x, ∂m/∂y] */
export type Stretch = Float64Array;

export interface Section {
  /** m at (x, y); 1 at the origin */
  value(x: number, y: number): number;
  evaluate(x: number, y: number, out: Stretch): void;
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
  extent: (r) => [r, r],
};
