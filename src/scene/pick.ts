/**
 * What lies under a point of the screen: the nearest hit over all parts, through a bounding volume hierarchy; of meshes on the device
 * their boxes.
 */

import {
  Box3,
  type BufferGeometry,
  type Camera,
  DoubleSide,
  type Ray,
  Raycaster,
  Triangle,
  Vector2,
  Vector3,
} from 'three/webgpu';
import { MeshBVH } from 'three-mesh-bvh';
import type { Vec3 } from '../math/vec.ts';
import type { Box } from '../mesh/mesh.ts';
import { isOnDevice } from './deviceMesh.ts';
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
    if (except.includes(item.id)) continue;
    const { mesh } = item;
    const hit = isOnDevice(mesh) ? onBox(mesh.box, caster.ray) : onTriangles(geometry, caster.ray);
    if (!hit || hit.distance >= distance) continue;
    distance = hit.distance;
    nearest = { point: hit.point.toArray(), normal: hit.normal, id: item.id };
  }
  return nearest;
}

interface Found {
  readonly distance: number;
  readonly point: Vector3;
  readonly normal: Vec3;
}

function onTriangles(geometry: BufferGeometry, ray: Ray): Found | null {
  if (geometry.index?.count === 0) return null;
  const hit = hierarchy(geometry).raycastFirst(ray, DoubleSide);
  if (!hit?.face) return null;
  const corners = [hit.face.a, hit.face.b, hit.face.c] as const;
  return { ...hit, normal: smoothNormal(geometry, corners, hit.point) };
}

/** Where the ray enters, or leaves where it begins within: the triangles themselves are on the device. */
function onBox(box: Box, ray: Ray): Found | null {
  const [min, max] = [new Vector3(...box.min), new Vector3(...box.max)];
  const point = ray.intersectBox(new Box3(min, max), new Vector3());
  if (!point) return null;
  const sides = [...min.sub(point), ...max.sub(point)].map(Math.abs);
  const side = sides.indexOf(Math.min(...sides));
  const normal = new Vector3().setComponent(side % 3, side < 3 ? -1 : 1);
  return { point, distance: point.distanceTo(ray.origin), normal: normal.toArray() };
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
