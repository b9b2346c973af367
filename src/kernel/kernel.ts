/**
 * What the rest of the field knows of a kernel: its value, and how it integrates itself along a line and over an edge
 * of a polygon. Skeletons bring a point into these frames, so that K kernels and P skeletons are K + P files.
 *
 * Everything here is in kernel units (1/s, R, or the size of the skel for kernels without a width): raw millimetres
 * at scales of 1e±6 overflow float32, whose WGSL twins have the same frames.
 */
import type { Change } from './change.ts';

export interface ParamSpec {
  readonly name: 's' | 'R' | 'n';
  /** allowed, ends included; what lies outside is refused when a field is built */
  readonly min: number;
  readonly max: number;
  readonly default: number;
  /** in words, with unit */
  readonly help: string;
}

/** By parameter name; a kernel without a width has none. */
export type KernelParams = Readonly<Partial<Record<ParamSpec['name'], number>>>;

/** A point seen from a straight segment. Mutable: one is filled again for each evaluation, nothing is allocated. */
export class LineFrame {
  /** squared distance from the line */
  rho2 = 0;
  /** the ends along the line, measured from the foot of the perpendicular; beta − alpha = length */
  alpha = 0;
  beta = 0;
  length = 0;
  /** w(t) = Σ weights[k] t^k, t from the end at alpha */
  readonly weights = new Float64Array(4);
  /** of w: 0–3 */
  degree = 0;
  /** singular kernels see no squared distance below this */
  floor2 = 0;
  /** n of the power kernel; others ignore it */
  exponent = 4;
  /** false where the value is enough: only the first number of the integral is written then */
  slopes = true;
}

/** A point seen from an edge of a planar polygon; the origin is the point's projection on the plane. */
export class EdgeFrame {
  /** signed distance of the origin from the edge's line: positive where the origin lies on its left */
  d = 0;
  /** the ends along the edge, measured from the foot of the perpendicular; beta − alpha = length */
  alpha = 0;
  beta = 0;
  length = 0;
  /** signed height of the point above the plane */
  z = 0;
  /** singular kernels see no z² below this */
  floor2 = 0;
  exponent = 4;
  slopes = true;
}

/**
 * What an integral leaves in `out`.
 * line: [∫ w f, A, B], gradient = 2 A perp + B u (perp from the line to the point, u along it)
 * edge: [value, A, B], value and gradient of the polygon = Σ value, Σ A n + B z, n = (u_y, −u_x) out of the polygon
 */
export type Integral = Float64Array;

/** A line with the weight w0 + w1 t, t from its first end: kernel units but for the place. */
export interface LinearLine {
  /** the first end, mm */
  readonly a: ArrayLike<number>;
  /** the direction */
  readonly u: ArrayLike<number>;
  /** kernel units of a millimetre */
  readonly per: number;
  readonly length: number;
  readonly w0: number;
  readonly w1: number;
}

/** The integral over a line from the point itself on, mm. */
export interface LineField {
  value(x: number, y: number, z: number): number;
  /** Adds `factor` times value and gradient to `out`. */
  add(x: number, y: number, z: number, factor: number, out: Float64Array): void;
}

export interface Kernel {
  readonly name: string;
  /** what people read */
  readonly label: string;
  readonly params: readonly ParamSpec[];
  /** f(c r) = c^homogeneity f(r) for kernels without a width; 0 for the others */
  readonly homogeneity: number;
  /** kernel units: zero beyond; Infinity where it never is */
  readonly support: number;
  /** kernel units, squared: what becomes `floor2` of the frames; 0 for kernels that are finite everywhere */
  readonly floor2: { readonly line: number; readonly plate: number };
  /** mm of one kernel unit; `size` (mm) is the skel's, for kernels without a width */
  unit(params: KernelParams, size: number): number;
  /** f at squared distance `r2` */
  value(r2: number, exponent: number): number;
  /** df/d(r²) */
  slope(r2: number, exponent: number): number;
  /** how the field changes over a box */
  readonly change: Change;
  /** Over a segment of a length above 0, weight of degree 0–3. */
  line(frame: LineFrame, out: Integral): void;
  /** A quicker way for linear weights, with nothing in between; null for lines for which it is none. */
  readonly linear?: (line: LinearLine) => LineField | null;
  /** One edge's share of a planar polygon of weight 1; null where polygons have no field. */
  readonly edge: ((frame: EdgeFrame, out: Integral) => void) | null;
  /** ∫ f over an infinite line at squared distance r2: for weights from radii; null where it diverges */
  readonly wholeLine: ((r2: number, exponent: number) => number) | null;
  /** ∫ f over an infinite plane at squared distance r2; null where it diverges, Infinity for exponents for which it does */
  readonly wholePlane: ((r2: number, exponent: number) => number) | null;
}
