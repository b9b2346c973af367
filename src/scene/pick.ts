/** What lies under a point of the screen: the nearest hit over all parts, through a bounding volume hierarchy. */

import {
  type BufferGeometry,
  type Camera,
  DoubleSide,
  Raycaster,
  Triangle,
  Vector2,
  Vector3,
} from 'three/webgpu';
import { MeshBVH } from 'three-mesh-bvh';
import type { Vec3 } from '../math/vec.ts';
import type { Part } from './part.ts';

export interface Hit {
  /** mm */
  readonly point: Vec3;
  /** unit, outward, interpolated from the vertices */
  readonly normal: Vec3;
  /** of the item */
  readonly id: string;
}

// Built at the first pick of a geometry, gone with it.
const hierarchies = new WeakMap<BufferGeometry, MeshBVH>();

function hierarchy(geometry: BufferGeometry): MeshBVH {
  let built = hierarchies.get(geometry);
  if (!built) {
    // Indirect: a hierarchy otherwise reorders the index, and that is the document's own.
    built = new MeshBVH(geometry, { indirect: true });
    hierarchies.set(geometry, built);
  }
  return built;
}

/** x, y from −1 to 1, right and up; items with the ids of `except` are looked through. */
export function pick(
  parts: Iterable<Part>,
  camera: Camera,
  x: number,
  y: number,
  except: readonly string[] = [],
): Hit | null {
  const caster = new Raycaster();
  caster.setFromCamera(new Vector2(x, y), camera);
  let nearest: Hit | null = null;
  let distance = Infinity;
  for (const { geometry, item } of parts) {
    if (item.mesh.indices.length === 0 || except.includes(item.id)) continue;
    const hit = hierarchy(geometry).raycastFirst(caster.ray, DoubleSide);
    if (!hit || hit.distance >= distance || !hit.face) continue;
    distance = hit.distance;
    const corners = [hit.face.a, hit.face.b, hit.face.c] as const;
    nearest = { point: hit.point.toArray(), normal: smoothNormal(geometry, corners, hit.point), id: item.id };
  }
  return nearest;
}

function smoothNormal(
  geometry: BufferGeometry,
  corners: readonly [number, number, number],
  point: Vector3,
): Vec3 {
  const at = (name: 'position' | 'normal', i: number) =>
    new Vector3().fromBufferAttribute(geometry.getAttribute(name), corners[i] ?? 0);
  const triangle = new Triangle(at('position', 0), at('position', 1), at('position', 2));
  const shares = triangle.getBarycoord(point, new Vector3()) ?? new Vector3(1, 0, 0);
  const normal = new Vector3();
  normal.addScaledVector(at('normal', 0), shares.x);
  normal.addScaledVector(at('normal', 1), shares.y);
  normal.addScaledVector(at('normal', 2), shares.z);
  if (normal.lengthSq() === 0) triangle.getNormal(normal);
  return normal.normalize().toArray();
}
