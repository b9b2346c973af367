/**
 * Analytic FRep primitives: plain data that becomes a field of its own. Inside is where the value is positive: shapes are
 * minus their distance (or a function whose gradient has length 1 on the surface), so that they meet convolution
 * sums, which come in as F − T (Kravtsov et al. §1.2, whose operations need a surface at 0).
 */
import type { Vec3 } from '../math/vec.ts';
import type { Box, FieldValue, Spread } from '../skeleton/skeleton.ts';
import { FieldError } from '../skeleton/skeleton.ts';

export interface Field {
  value(x: number, y: number, z: number): number;
  /** Writes value and gradient. Where no gradient is (a medial axis) any of the neighbouring ones, or zero. */
  evaluate(x: number, y: number, z: number, out: FieldValue): void;
  /** mm; holds all of the inside; null when that is unbounded */
  readonly box: Box | null;
  /** mm; holds all points with a value above `level` ≤ 0; null when they are unbounded, or not known to be bounded */
  boxAbove(level: number): Box | null;
}

/** The smooth sides of a shape that has edges. */
export interface Facets {
  readonly count: number;
  /** the one that the nearest place of the surface is on */
  nearest(x: number, y: number, z: number): number;
  /** Writes value and gradient of a field that is 0 on that side and on its continuation beyond the edges. */
  evaluate(facet: number, x: number, y: number, z: number, out: FieldValue): void;
}

/** A field that knows what it may be within a ball. */
export interface ShapeField extends Field {
  /** of shapes with sharp edges */
  readonly facets?: Facets;
  /** Writes the spread within `radius` mm. */
  spread(x: number, y: number, z: number, radius: number, out: Spread): void;
}

/** One kind of shape, in its own frame (axes along y); placed by an affine node of the tree. */
export interface ShapeKind<S> {
  readonly name: string;
  /** what people read */
  readonly label: string;
  /** the value is the signed distance everywhere */
  readonly exact: boolean;
  /** the first is what a menu begins with, the others are awkward; tests run over all */
  readonly examples: readonly S[];
  /** what the WGSL twin takes after the point, 12 numbers in all at most */
  readonly takes: readonly ('f32' | 'vec3f')[];
  /** those, in its order */
  numbers(shape: S): readonly number[];
  /** Checks what types cannot say; throws FieldError. */
  bind(shape: S): ShapeField;
}

/** Refuses what is no size in mm. */
export function requireSize(value: number, what: string): void {
  if (!(value > 0 && value < Infinity)) throw new FieldError(`${what} must be above 0 mm, got ${value}`);
}

/** The box about the origin. */
export function boxAbout(half: Vec3, grown = 0): Box {
  const [x, y, z] = [half[0] + grown, half[1] + grown, half[2] + grown];
  return { min: [-x, -y, -z], max: [x, y, z] };
}

type Distance = Pick<Field, 'value' | 'evaluate'>;

/** A field that is a distance, its inside within `half` of the origin. */
export function distanceField(half: Vec3, field: Distance): ShapeField {
  const size = Math.max(...half);
  return {
    ...field,
    box: boxAbout(half),
    boxAbove: (level) => boxAbout(half, -level),
    spread(x, y, z, radius, out) {
      const value = field.value(x, y, z);
      const most = radius + ROUNDING * (Math.abs(x) + Math.abs(y) + Math.abs(z) + radius + size);
      flatSpread(value - most, value + most, out);
    },
  };
}

/**
 * The same for convex shapes, whose distance is nowhere above what its gradient says: from the centred form comes the upper end,
 * from the radius the lower one.
 */
export function convexField(half: Vec3, field: Distance): ShapeField {
  const size = Math.max(...half);
  return {
    ...distanceField(half, field),
    spread(x, y, z, radius, out) {
      field.evaluate(x, y, z, out);
      const value = out[0]!;
      const most = radius + ROUNDING * (Math.abs(x) + Math.abs(y) + Math.abs(z) + radius + size);
      out[0] = value - radius;
      out[4] = most;
      out[5] = value - most;
      out[6] = value + most;
    },
  };
}

/** of the coordinates, sizes and terms that a value is made of */
export const ROUNDING = 4e-15;

/** An interval, and no gradient that would say more. */
export function flatSpread(low: number, high: number, out: Spread): void {
  const half = 0.5 * (high - low);
  out.fill(0);
  out[0] = low + half;
  out[4] = half;
  out[5] = low;
  out[6] = high;
}

/** −1 or 1, never 0: a point on a plane of symmetry still has a side. */
export function side(x: number): number {
  return x < 0 ? -1 : 1;
}
