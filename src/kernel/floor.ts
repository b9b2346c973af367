/**
 * Where singular kernels stop growing, as squared distances in units of the skel's size: the field is finite everywhere, and
 * an isosurface is untouched while its radius is larger.
 *
 * Lines: 2⁻⁴⁰ of the length, the digits in which a point's distance from the axis is known. Plates: beside the plate and
 * close to its plane terms of size z^(2−n) cancel to nothing, so that n decides; clamped |z| changes the field there by
 * (z/distance)², which with these is below what cancels.
 */
export const LINE_FLOOR2 = 8.271806125530277e-25;

/** by n: |z| = 2⁻³⁰, 2⁻²⁰, 2⁻¹⁴, 2⁻⁹ */
export const PLATE_FLOOR2 = {
  1: 8.673617379884035e-19,
  2: 9.094947017729282e-13,
  3: 3.725290298461914e-9,
  5: 3.814697265625e-6,
} as const;
