/** Sheets known in closed form, for the tests of what moves sheets. */
import { add3, cross3, length3, scale3, sub3 } from '../../src/math/tuple.ts';
import type { Vec2, Vec3 } from '../../src/math/vec.ts';
import type { Sheet, SheetRow, Spine, Station } from '../../src/surface/sheet.ts';

/** A centre curve with its first two derivatives, in the plane z = 0. */
export interface Centre {
  readonly at: (u: number) => readonly [c: Vec3, rate: Vec3, second: Vec3];
  readonly closed?: boolean;
}

export const upright: Centre = {
  at: (u) => [
    [0, 100 * u, 0],
    [0, 100, 0],
    [0, 0, 0],
  ],
};

/** sin waves across the way up */
export function wavy(height: number, waves: number): Centre {
  const w = 2 * Math.PI * waves;
  return {
    at: (u) => [
      [height * Math.sin(w * u), 100 * u, 0],
      [height * w * Math.cos(w * u), 100, 0],
      [-height * w * w * Math.sin(w * u), 0, 0],
    ],
  };
}

/** A cubic Bézier curve through the given control points. */
export function cubic(...[a, b, c, d]: readonly [Vec2, Vec2, Vec2, Vec2]): Centre {
  const along = (f: (k: 0 | 1) => number): Vec3 => [f(0), f(1), 0];
  return {
    at: (u) => {
      const v = 1 - u;
      return [
        along((k) => v * v * v * a[k] + 3 * v * v * u * b[k] + 3 * v * u * u * c[k] + u * u * u * d[k]),
        along((k) => 3 * (v * v * (b[k] - a[k]) + 2 * v * u * (c[k] - b[k]) + u * u * (d[k] - c[k]))),
        along((k) => 6 * (v * (c[k] - 2 * b[k] + a[k]) + u * (d[k] - 2 * c[k] + b[k]))),
      ];
    },
  };
}

/** Part of a circle of radius 60 from the angle `from`, radians. */
export function arc(from: number, turn: number, closed = false): Centre {
  return {
    closed,
    at: (u) => {
      const a = from + turn * u;
      const [c, s] = [60 * Math.cos(a), 60 * Math.sin(a)];
      return [
        [c, s, 0],
        [-turn * s, turn * c, 0],
        [-turn * turn * c, -turn * turn * s, 0],
      ];
    },
  };
}

const OUT: Vec3 = [0, 0, 1];

export function spineOf({ at, closed = false }: Centre): Spine {
  const station = (u: number): Station => {
    const [centre, rate, second] = at(u);
    const speed = length3(rate);
    const turning = cross3(rate, second)[2] / (speed * speed);
    return { centre, rate, normal: scale3(rate, 1 / speed), spin: [0, 0, turning] };
  };
  return { closed, stops: [0, 1], at: station };
}

/** The point at v of the ellipse on the section: from the left of the way over the front. */
export function pointOf(centre: Centre, radius: (u: number) => number, u: number, v: number): Vec3 {
  const [c, rate] = centre.at(u);
  const left = scale3(cross3(OUT, rate), 1 / length3(rate));
  const [cos, sin] = [Math.cos(2 * Math.PI * v), Math.sin(2 * Math.PI * v)];
  return add3(c, add3(scale3(left, radius(u) * cos), scale3(OUT, 0.7 * radius(u) * sin)));
}

/** A closed sheet with ellipses as sections, rows at `us` and columns at `vs`, normals outward. */
export function ellipses(
  centre: Centre,
  radius: (u: number) => number,
  us: readonly number[],
  vs: readonly number[],
): Sheet {
  const rows = us.map((u): SheetRow => {
    const at = (x: number, y: number): Vec3 => pointOf(centre, radius, x, y);
    const normals = vs.map((v) => {
      const [du, dv] = [slope3((x) => at(x, v), u), slope3((y) => at(u, y), v)];
      const n = cross3(du, dv);
      return scale3(n, -1 / length3(n));
    });
    return {
      points: Float64Array.from(vs.flatMap((v) => at(u, v))),
      normals: Float64Array.from(normals.flat()),
      joined: u !== us[0],
      at: { u, side: u === us[us.length - 1] ? -1 : 1 },
    };
  });
  return { rows, columns: { vs, joined: vs.map((_, i) => i > 0) }, spine: spineOf(centre) };
}

/** Central difference of the fourth order. */
export function slope3(f: (t: number) => Vec3, t: number, h = 1e-3): Vec3 {
  const near = scale3(sub3(f(t + h), f(t - h)), 8);
  return scale3(sub3(near, sub3(f(t + 2 * h), f(t - 2 * h))), 1 / (12 * h));
}

export const evenly = (count: number): number[] => Array.from({ length: count + 1 }, (_, i) => i / count);

export function pointIn(row: { readonly points: Float64Array }, j: number): Vec3 {
  return [row.points[3 * j]!, row.points[3 * j + 1]!, row.points[3 * j + 2]!];
}

export function normalIn(row: { readonly normals: Float64Array }, j: number): Vec3 {
  return [row.normals[3 * j]!, row.normals[3 * j + 1]!, row.normals[3 * j + 2]!];
}
