/** All shapes. A new one is a file (and its WGSL twin), a member of the union and a line in the list. */
import { FieldError } from '../skeleton/skeleton.ts';
import { type BoxShape, box } from './box.ts';
import { type Capsule, capsule } from './capsule.ts';
import { type Cylinder, cylinder } from './cylinder.ts';
import { type Ellipsoid, ellipsoid } from './ellipsoid.ts';
import { type HalfSpace, halfSpace } from './halfSpace.ts';
import { type Quadric, quadric } from './quadric.ts';
import { type RoundedBox, roundedBox } from './roundedBox.ts';
import type { ShapeField, ShapeKind } from './shape.ts';
import { type Sphere, sphere } from './sphere.ts';
import { type Torus, torus } from './torus.ts';

export type Shape =
  | Sphere
  | Ellipsoid
  | BoxShape
  | RoundedBox
  | Cylinder
  | Capsule
  | Torus
  | HalfSpace
  | Quadric;

export type ShapeName = Shape['type'];

export const shapes: { readonly [K in ShapeName]: ShapeKind<Extract<Shape, { type: K }>> } = {
  sphere,
  ellipsoid,
  box,
  roundedBox,
  cylinder,
  capsule,
  torus,
  halfSpace,
  quadric,
};

/** The kind of a shape; FieldError for one that is not in the list. */
export function kindOf<S extends Shape>(shape: S): ShapeKind<S> {
  const kind = Object.hasOwn(shapes, shape.type) ? shapes[shape.type] : null;
  if (!kind) throw new FieldError(`unknown shape '${shape.type}'`);
  // the list pairs each name with its own type, which the compiler cannot follow through a union
  return kind as unknown as ShapeKind<S>;
}

/** The field of a shape in its own frame; FieldError says what is wrong with it. */
export function bindShape(shape: Shape): ShapeField {
  return kindOf(shape).bind(shape);
}
