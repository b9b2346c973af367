/** Strokes known in closed form, and what is asked of their solids. Shared by the tests of this folder. */
import fc from 'fast-check';
import { cross3, dot3, length3, sub3 } from '../../src/math/tuple.ts';
import type { Vec2, Vec3 } from '../../src/math/vec.ts';
import { eachTriangle } from '../../src/mesh/measure.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { functionCurve, polylineCurve } from '../../src/stroke/arcLength.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import type { Plane } from '../../src/stroke/stroke.ts';

export const FLAT: Plane = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] };
/** tilted and moved; its axes are exact to rounding */
export const TILTED: Plane = { origin: [5, -7, 11], x: [0.6, 0.8, 0], y: [0, 0, 1] };

export function line(...points: Vec2[]): Curve {
  return polylineCurve(points, false);
}

export function polygon(...points: Vec2[]): Curve {
  return polylineCurve(points, true);
}

/** Half a circle from (x, r) to (x, −r), bulging to the right (1) or the left (−1). */
export function halfCircle(radius: number, bulge: 1 | -1, x = 0): Curve {
  return functionCurve(
    (t) => [x + bulge * radius * Math.sin(Math.PI * t), radius * Math.cos(Math.PI * t)],
    false,
  );
}

/** Counter-clockwise (1) or clockwise (−1) from the angle `start`, radians. */
export function circle(x: number, y: number, radius: number, sense: 1 | -1 = 1, start = 0): Curve {
  return functionCurve((t) => {
    const angle = start + sense * 2 * Math.PI * t;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  }, true);
}

export function reversed(curve: Curve): Curve {
  const { length, closed, corners } = curve;
  return {
    length,
    closed,
    corners: corners.map((u) => (closed && u === 0 ? 0 : 1 - u)).sort((a, b) => a - b),
    point: (u) => curve.point(1 - u),
    tangent: (u, side = 1) => {
      const [x, y] = curve.tangent(1 - u, side === 1 ? -1 : 1);
      return [-x, -y];
    },
    pressure: (u) => curve.pressure(1 - u),
  };
}

export function withPressure(curve: Curve, pressure: (u: number) => number): Curve {
  return { ...curve, pressure };
}

/** Open strokes of size about `scale`: a straight way with three waves of random height and phase on it. */
export function smoothStroke(scale: number): fc.Arbitrary<Curve> {
  // doubles by lot are nearly all next to nothing
  const number = fc.integer({ min: -10_000, max: 10_000 }).map((i) => i / 10_000);
  return fc.array(number, { minLength: 16, maxLength: 16 }).map((c) => {
    const wave = (t: number, i: number): number =>
      [1, 2, 3].reduce(
        (sum, k) => sum + (0.4 / k) * c[i + k]! * Math.sin(Math.PI * k * t + 3 * c[i + 3 + k]!),
        0,
      );
    return functionCurve(
      (t) => [scale * (c[0]! + c[1]! * t + wave(t, 2)), scale * (c[8]! + (1.5 + c[9]!) * t + wave(t, 9))],
      false,
    );
  });
}

/** Open or closed strokes with corners: straight lines between random points. */
export function bentStroke(closed: boolean): fc.Arbitrary<Curve> {
  const x = fc.integer({ min: -50, max: 50 });
  return fc
    .array(fc.tuple(x, x), { minLength: 3, maxLength: 7 })
    .map((points) => polylineCurve(points, closed));
}

/** The least cosine between a triangle and the normal of one of its corners. */
export function normalAgreement(mesh: Mesh): number {
  let least = 1;
  eachTriangle(mesh, (a, b, c, triangle) => {
    const face = cross3(sub3(b, a), sub3(c, a));
    for (let k = 0; k < 3; k++) {
      const normal = normalOf(mesh, mesh.indices[3 * triangle + k]!);
      least = Math.min(least, dot3(face, normal) / length3(face));
    }
  });
  return least;
}

/** The largest distance of a normal's length from 1. */
export function normalError(mesh: Mesh): number {
  let most = 0;
  for (let i = 0; i < mesh.normals.length / 3; i++) {
    most = Math.max(most, Math.abs(length3(normalOf(mesh, i)) - 1));
  }
  return most;
}

/** Positions of the vertices that have a copy with another normal (farther apart than `cosine`): creases. */
export function creases(mesh: Mesh, cosine = 0.99): Vec3[] {
  const seen = new Map<string, Vec3[]>();
  for (const i of mesh.indices) {
    const key = pointOf(mesh, i).join();
    const normals = seen.get(key) ?? [];
    normals.push(normalOf(mesh, i));
    seen.set(key, normals);
  }
  const sharp = [...seen].filter(([, all]) => all.some((n) => dot3(n, all[0]!) < cosine));
  return sharp.map(([key]) => key.split(',').map(Number) as unknown as Vec3);
}

export function pointOf({ positions }: Mesh, i: number): Vec3 {
  return [positions[3 * i]!, positions[3 * i + 1]!, positions[3 * i + 2]!];
}

export function normalOf({ normals }: Mesh, i: number): Vec3 {
  return [normals[3 * i]!, normals[3 * i + 1]!, normals[3 * i + 2]!];
}

/** The largest distance from a vertex of one mesh to the nearest vertex of the other. */
export function vertexDistance(a: Mesh, b: Mesh): number {
  const points = Array.from({ length: b.positions.length / 3 }, (_, i) => pointOf(b, i));
  let most = 0;
  for (const i of a.indices) {
    const p = pointOf(a, i);
    most = Math.max(most, Math.min(...points.map((q) => length3(sub3(p, q)))));
  }
  return most;
}
