/**
 * Bounding volumes of skels (Zhu et al. 2011, table 1): around each all that may be inside of the body, a sphere about a point, a
 * cylinder and two spheres about a segment, the same about the edges of a polygon and a prism over it. Their size is the offset
 * distance (eqs. 17–19, put right: docs/fields.md, Offsets) for T over the number of skels that overlap.
 */
import { cross3, dot3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { PolygonSkel, Skel } from '../skeleton/skels.ts';
import { boundTerms } from './bind.ts';
import type { SkelsNode } from './node.ts';
import { piecesOf } from './pieces.ts';

/** skels that may overlap in a place: N of eq. 18 */
export const OVERLAP = 8;

export type Volume = Sphere | Cylinder | Prism;

export interface Sphere {
  readonly type: 'sphere';
  readonly centre: Vec3;
  readonly radius: number;
}

export interface Cylinder {
  readonly type: 'cylinder';
  readonly a: Vec3;
  readonly b: Vec3;
  readonly radius: number;
}

/** Over a polygon, as far to both sides of its plane. */
export interface Prism {
  readonly type: 'prism';
  readonly origin: Vec3;
  readonly u: Vec3;
  readonly v: Vec3;
  readonly loops: PolygonSkel['loops'];
  readonly radius: number;
}

/** Of all of a body's skels: where none reaches, nothing is inside. Those of skels with cross sections are too small. */
export function boundingVolumes(node: SkelsNode, overlap = OVERLAP): readonly Volume[] {
  const pieces = piecesOf(node);
  const shared = node.threshold / Math.min(pieces.length, overlap);
  return pieces.flatMap(({ skel, term, number }) => {
    const { field, factor } = boundTerms(term, node)[number]!;
    return volumesOf(skel, field.offset(shared / Math.abs(factor)));
  });
}

/** `radius`: the offset distance, mm. */
function volumesOf(skel: Skel, radius: number): readonly Volume[] {
  if (!(radius > 0)) return [];
  const sphere = (centre: Vec3): Volume => ({ type: 'sphere', centre, radius });
  const along = (a: Vec3, b: Vec3): Volume => ({ type: 'cylinder', a, b, radius });
  switch (skel.type) {
    case 'point':
      return [sphere(skel.at)];
    case 'segment':
      return [along(skel.a, skel.b), sphere(skel.a), sphere(skel.b)];
    case 'polygon': {
      const { origin, u, v, loops } = skel;
      const at = ([x, y]: readonly [number, number]): Vec3 => [
        origin[0] + x * u[0] + y * v[0],
        origin[1] + x * u[1] + y * v[1],
        origin[2] + x * u[2] + y * v[2],
      ];
      const rims = loops.flatMap((loop) =>
        loop.flatMap((corner, i) => [
          sphere(at(corner)),
          along(at(corner), at(loop[(i + 1) % loop.length]!)),
        ]),
      );
      return [...rims, { type: 'prism', origin, u, v, loops, radius }];
    }
    default:
      return [];
  }
}

/** The parts of the line from `from` along the unit vector `ray` within a volume, mm; of a prism they may be several. */
export function within(volume: Volume, from: Vec3, ray: Vec3): readonly (readonly [number, number])[] {
  switch (volume.type) {
    case 'sphere': {
      const to = sub3(volume.centre, from);
      const along = dot3(to, ray);
      return about(along, volume.radius * volume.radius - dot3(to, to) + along * along);
    }
    case 'cylinder':
      return withinCylinder(volume, from, ray);
    case 'prism':
      return withinPrism(volume, from, ray);
  }
}

const about = (middle: number, square: number): readonly (readonly [number, number])[] =>
  square > 0 ? [[middle - Math.sqrt(square), middle + Math.sqrt(square)]] : [];

function withinCylinder({ a, b, radius }: Cylinder, from: Vec3, ray: Vec3) {
  const axis = sub3(b, a);
  const length2 = dot3(axis, axis);
  if (length2 === 0) return [];
  const off = sub3(from, a);
  const [start, rise] = [dot3(off, axis) / length2, dot3(ray, axis) / length2];
  const across = (v: Vec3, share: number): Vec3 => [
    v[0] - share * axis[0],
    v[1] - share * axis[1],
    v[2] - share * axis[2],
  ];
  const [p, q] = [across(off, start), across(ray, rise)];
  const qq = dot3(q, q);
  const caps = slab(start, rise, 0, 1);
  if (!(qq > 1e-24)) return dot3(p, p) < radius * radius ? caps : [];
  const middle = -dot3(p, q) / qq;
  return meet(about(middle, (radius * radius - dot3(p, p)) / qq + middle * middle), caps);
}

/** In the plane of a prism: between crossings with its edges, of which every other part is within. */
function withinPrism({ origin, u, v, loops, radius }: Prism, from: Vec3, ray: Vec3) {
  const off = sub3(from, origin);
  const n = cross3(u, v);
  const caps = slab(dot3(off, n), dot3(ray, n), -radius, radius);
  const [x, y, dx, dy] = [dot3(off, u), dot3(off, v), dot3(ray, u), dot3(ray, v)];
  if (!(dx * dx + dy * dy > 1e-24)) return isWithin(loops, x, y) ? caps : [];
  const crossings = loops
    .flatMap((loop) => loop.map((a, i) => [a, loop[(i + 1) % loop.length]!] as const))
    .flatMap(([a, b]) => {
      const side = ([px, py]: readonly [number, number]) => (px - x) * dy - (py - y) * dx;
      const [sideA, sideB] = [side(a), side(b)];
      if (sideA > 0 === sideB > 0) return [];
      const share = sideA / (sideA - sideB);
      const [cx, cy] = [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];
      return [((cx - x) * dx + (cy - y) * dy) / (dx * dx + dy * dy)];
    })
    .sort((s, t) => s - t);
  const parts = crossings.flatMap((t, i) => (i % 2 === 0 ? [[t, crossings[i + 1] ?? t] as const] : []));
  return meet(parts, caps);
}

function isWithin(loops: PolygonSkel['loops'], x: number, y: number): boolean {
  const edges = loops.flatMap((loop) => loop.map((a, i) => [a, loop[(i + 1) % loop.length]!] as const));
  const right = edges.filter(
    ([a, b]) => a[1] > y !== b[1] > y && x < a[0] + ((y - a[1]) / (b[1] - a[1])) * (b[0] - a[0]),
  );
  return right.length % 2 === 1;
}

/** Where start + rise t is from low to high. */
function slab(
  start: number,
  rise: number,
  low: number,
  high: number,
): readonly (readonly [number, number])[] {
  if (rise === 0) return start >= low && start <= high ? [[-Infinity, Infinity]] : [];
  const [s, t] = [(low - start) / rise, (high - start) / rise];
  return [[Math.min(s, t), Math.max(s, t)]];
}

type Parts = readonly (readonly [number, number])[];

function meet(a: Parts, b: Parts): Parts {
  return a.flatMap(([s, t]) =>
    b.flatMap(([p, q]) =>
      Math.max(s, p) < Math.min(t, q) ? [[Math.max(s, p), Math.min(t, q)] as const] : [],
    ),
  );
}
