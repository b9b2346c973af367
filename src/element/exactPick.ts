/**
 * What a pen points at on a body: a place on its surface itself, and the skel there. Where triangles are seen the place is theirs, which are a part of a
 * cell away from it, moved along the ray; where the surface itself is seen a ray of its own is cast, so that what triangles miss can be picked, too.
 */
import { type Body, CELLS } from '../document/bodies.ts';
import type { BodyPart, SolidPart } from '../document/document.ts';
import type { NamedNode } from '../document/fieldParts.ts';
import { nodeOf } from '../document/solidNode.ts';
import { bindField } from '../field/bind.ts';
import type { FieldNode } from '../field/node.ts';
import { rayAlone } from '../field/rayAlone.ts';
import type { Raycaster } from '../field/raycast.ts';
import { type RayCamera, rayOf } from '../field/rayImage.ts';
import { viewFrom } from '../field/rayScene.ts';
import { skelAt } from '../field/skelAt.ts';
import { type SurfaceHit, surfaceHit } from '../field/surfaceHit.ts';
import type { TreeField } from '../field/treeField.ts';
import { place3 } from '../math/placement.ts';
import { dot3, rotate3, sub3, unrotate3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { bounds } from '../mesh/measure.ts';
import type { Hit } from '../scene/index.ts';
import { type Ray, rayAt } from '../stroke/plane.ts';
import type { Picked } from './picked.ts';

/** cells of the mesh along the ray that are searched: close to an outline the ray is soon out of the body again */
const REACHES = [2, 0.5, 0.125];

/** to each side: what is thinner than their distance may be missed */
const STEPS = 8;
/** pixels to the right and down, nearest first, up to half of one */
const BESIDE: readonly (readonly [x: number, y: number])[] = [
  [0, 0],
  ...Array.from({ length: STEPS }, (_, i) => (0.5 * (i + 1)) / STEPS).flatMap((off): [number, number][] => [
    [off, 0],
    [0, off],
    [-off, 0],
    [0, -off],
  ]),
];

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

/** Whether rays can be cast at it one by one. */
export const isCastable = ({ node }: Pick<NamedNode, 'node'>): boolean => casterOf(node) !== null;

/**
 * The nearest that a ray through a place of the picture meets, of bodies themselves and of `other`, which is a hit of something else. What is thinner
 * than a pixel is met within half a one.
 */
export function pickedAmong(
  bodies: readonly Pick<NamedNode, 'id' | 'node' | 'placement'>[],
  other: Hit | null,
  camera: RayCamera,
  [x, y]: readonly [x: number, y: number],
): Picked | null {
  const { origin, direction } = rayAt(camera.view, camera, x, y);
  let nearest: Picked | null = other && { ...other, skel: null };
  let distance = other ? dot3(sub3(other.point, origin), direction) : Infinity;
  for (const { id, node, placement } of bodies) {
    const seen = { ...camera, view: viewFrom(placement, camera.view) };
    const hit = casterOf(node) && castBeside(casterOf(node)!, seen, x, y, distance);
    if (!hit) continue;
    distance = hit.t;
    const { rotation } = placement;
    const [point, normal] = [place3(placement, hit.at), rotate3(rotation, hit.normal)];
    nearest = { id, point, normal, skel: skelAt(node, ...hit.at) };
  }
  return nearest;
}

/** The ray itself, or the next to it that meets what it has only just passed. */
function castBeside(
  caster: Raycaster,
  camera: RayCamera,
  x: number,
  y: number,
  farthest: number,
): Raycaster['hit'] | null {
  for (const [dx, dy] of BESIDE) {
    if (caster.cast(rayOf(camera, x + dx, y + dy), farthest)) return caster.hit;
    if (dx === 0 && dy === 0 && !caster.passed) return null;
  }
  return null;
}

const casters = new WeakMap<FieldNode, Raycaster | null>();

/** Null for what has no field, which the list of parts tells. */
function casterOf(node: FieldNode): Raycaster | null {
  const known = casters.get(node);
  if (known !== undefined) return known;
  let caster: Raycaster | null = null;
  try {
    caster = rayAlone(fieldOf(node));
  } catch {}
  casters.set(node, caster);
  return caster;
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
