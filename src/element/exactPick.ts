/** What a pen points at on a body, on its surface itself: from the triangles, which are a part of a cell away from it, along the ray. */
import { type Body, CELLS } from '../document/bodies.ts';
import type { BodyPart } from '../document/document.ts';
import { bindField } from '../field/bind.ts';
import type { FieldNode } from '../field/node.ts';
import { surfaceHit } from '../field/surfaceHit.ts';
import type { TreeField } from '../field/treeField.ts';
import { place3 } from '../math/placement.ts';
import { rotate3, sub3, unrotate3 } from '../math/tuple.ts';
import { bounds } from '../mesh/measure.ts';
import type { Hit } from '../scene/index.ts';
import type { Ray } from '../stroke/plane.ts';

/** cells of the mesh along the ray that are searched */
const REACH = 2;

const bound = new WeakMap<FieldNode, TreeField>();

/** The hit of the triangles where the surface is not within reach, as beside an outline. */
export function exactHit(
  hit: Hit,
  { node, placement }: BodyPart,
  ray: Ray,
  made: Pick<Body, 'mesh' | 'cells'>,
): Hit {
  const { min, max } = bounds(made.mesh);
  const cell = Math.max(...sub3(max, min)) / (made.cells || CELLS);
  const field = bound.get(node) ?? bindField(node);
  bound.set(node, field);
  const { rotation, translation } = placement;
  const near = unrotate3(rotation, sub3(hit.point, translation));
  const found = surfaceHit(field, near, unrotate3(rotation, ray.direction), REACH * cell);
  if (!found) return hit;
  return { id: hit.id, point: place3(placement, found.point), normal: rotate3(rotation, found.normal) };
}
