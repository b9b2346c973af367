/** What a pen points at on a body: a place on its surface itself, from the triangles, which are a part of a cell away from it, along the ray; and the skel there. */
import { type Body, CELLS } from '../document/bodies.ts';
import type { BodyPart, SolidPart } from '../document/document.ts';
import { nodeOf } from '../document/solidNode.ts';
import { bindField } from '../field/bind.ts';
import type { FieldNode } from '../field/node.ts';
import { skelAt } from '../field/skelAt.ts';
import { type SurfaceHit, surfaceHit } from '../field/surfaceHit.ts';
import type { TreeField } from '../field/treeField.ts';
import { place3 } from '../math/placement.ts';
import { rotate3, sub3, unrotate3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { bounds } from '../mesh/measure.ts';
import type { Hit } from '../scene/index.ts';
import type { Ray } from '../stroke/plane.ts';
import type { Picked } from './picked.ts';

/** cells of the mesh along the ray that are searched: close to an outline the ray is soon out of the body again */
const REACHES = [2, 0.5, 0.125];

const bound = new WeakMap<FieldNode, TreeField>();

/** The place of the triangles where the surface is not within reach, as beside an outline. */
export function pickedOn(
  hit: Hit,
  part: BodyPart | SolidPart,
  ray: Ray,
  made: Pick<Body, 'mesh' | 'cells'>,
): Picked {
  const { placement } = part;
  const node = nodeOf(part);
  const { rotation, translation } = placement;
  const near = unrotate3(rotation, sub3(hit.point, translation));
  const found = onSurface(fieldOf(node), near, unrotate3(rotation, ray.direction), cellOf(made));
  const skel = skelAt(node, ...(found?.point ?? near));
  if (!found) return { ...hit, skel };
  return {
    id: hit.id,
    point: place3(placement, found.point),
    normal: rotate3(rotation, found.normal),
    skel,
  };
}

function onSurface(field: TreeField, near: Vec3, along: Vec3, cell: number): SurfaceHit | null {
  for (const cells of REACHES) {
    const found = surfaceHit(field, near, along, cells * cell);
    if (found) return found;
  }
  return null;
}

function cellOf({ mesh, cells }: Pick<Body, 'mesh' | 'cells'>): number {
  const { min, max } = bounds(mesh);
  return Math.max(...sub3(max, min)) / (cells || CELLS);
}

function fieldOf(node: FieldNode): TreeField {
  const field = bound.get(node) ?? bindField(node);
  bound.set(node, field);
  return field;
}
