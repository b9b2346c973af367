/** Solids with sharp edges, the smooth fields that meet in them, and points all along those edges, known without a mesh. */
import type { Affine } from '../../src/field/affine.ts';
import { bindField } from '../../src/field/bind.ts';
import type { FieldNode } from '../../src/field/node.ts';
import type { TreeField } from '../../src/field/treeField.ts';
import { random } from '../fixtures/random.ts';
import { along, set, shape } from './meshes.ts';
import { body, box, evaluated, type Point, placed, sphere } from './trees.ts';

export interface CreaseCase {
  readonly name: string;
  readonly node: FieldNode;
  /** |f| / |∇f| is the distance from one of the surfaces, nearly */
  readonly sides: readonly TreeField[];
  /** APART or less from one to the next */
  readonly crease: readonly Point[];
}

/** mm */
const APART = 0.01;

/** Turned, so that no edge lies along the lattice; about two axes. */
const TURN: Affine = (() => {
  const [c, s, d, t] = [Math.cos(0.4), Math.sin(0.4), Math.cos(0.7), Math.sin(0.7)];
  return [c, -s * d, s * t, 0.3, s, c * d, -c * t, -0.2, 0, t, d, 0.1];
})();

const turned = (node: FieldNode): FieldNode => ({ type: 'affine', matrix: TURN, node });
const turnedPoint = ([x, y, z]: Point): Point => {
  const row = (r: number) => TURN[r]! * x + TURN[r + 1]! * y + TURN[r + 2]! * z + TURN[r + 3]!;
  return [row(0), row(4), row(8)];
};

const plane = (normal: Point, offset: number) => shape({ type: 'halfSpace', normal, offset });

function line(a: Point, b: Point): Point[] {
  const count = Math.ceil(Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]) / APART);
  return Array.from({ length: count + 1 }, (_, i) => {
    const at = (axis: 0 | 1 | 2) => a[axis] + ((b[axis] - a[axis]) * i) / count;
    return [at(0), at(1), at(2)];
  });
}

function circle(radius: number, from: number, to: number, place: (c: number, s: number) => Point): Point[] {
  const count = Math.ceil((radius * (to - from)) / APART);
  return Array.from({ length: count + 1 }, (_, i) => {
    const angle = from + ((to - from) * i) / count;
    return place(radius * Math.cos(angle), radius * Math.sin(angle));
  });
}

const AXES = [0, 1, 2] as const;
const SIGNS = [-1, 1] as const;

/** The 12 edges of the parallelepiped |n_i · x| ≤ w_i, which `corner` of three signs gives the corners of. */
function edges(corner: (signs: Point) => Point): [Point, Point][] {
  return AXES.flatMap((axis) =>
    SIGNS.flatMap((u) =>
      SIGNS.map((v): [Point, Point] => {
        const at = (w: number) => {
          const signs: [number, number, number] = [0, 0, 0];
          signs[axis] = w;
          signs[(axis + 1) % 3] = u;
          signs[(axis + 2) % 3] = v;
          return corner(signs);
        };
        return [at(-1), at(1)];
      }),
    ),
  );
}

function known(
  name: string,
  node: FieldNode,
  sides: readonly FieldNode[],
  crease: readonly Point[],
): CreaseCase {
  return {
    name,
    node: turned(node),
    sides: sides.map((side) => bindField(turned(side))),
    crease: crease.map(turnedPoint),
  };
}

const HALF: Point = [5, 3, 4];
const faces = (half: Point): FieldNode[] =>
  AXES.flatMap((axis) =>
    SIGNS.map((sign) => {
      const normal: [number, number, number] = [0, 0, 0];
      normal[axis] = sign;
      return plane(normal, half[axis]);
    }),
  );

function aBox(): CreaseCase {
  const corner = (signs: Point): Point => [signs[0] * HALF[0], signs[1] * HALF[1], signs[2] * HALF[2]];
  return known(
    'a box',
    box(...HALF),
    faces(HALF),
    edges(corner).flatMap(([a, b]) => line(a, b)),
  );
}

function aCylinder(): CreaseCase {
  const [radius, half] = [4, 5];
  const rims = SIGNS.flatMap((y) => circle(radius, 0, 2 * Math.PI, (c, s) => [c, y * half, s]));
  const wall = shape({ type: 'cylinder', radius, half: 100 });
  return known(
    'a cylinder',
    shape({ type: 'cylinder', radius, half }),
    [wall, plane([0, 1, 0], half), plane([0, -1, 0], half)],
    rims,
  );
}

/** The corner (5, 5, 5) bitten off. */
function bittenBox(): CreaseCase {
  const [a, r] = [5, 4];
  const ball = placed(sphere(r), a, a, a);
  const whole = edges(([x, y, z]) => [a * x, a * y, a * z]);
  const straight = whole.map(([from, to]): [Point, Point] => {
    const isBitten = to.every((x) => x === a);
    if (!isBitten) return [from, to];
    return [from, to.map((x, k) => (x === from[k] ? x : a - r)) as unknown as Point];
  });
  const arcs = AXES.flatMap((axis) =>
    circle(r, Math.PI, 1.5 * Math.PI, (c, s) => {
      const at: [number, number, number] = [a, a, a];
      at[(axis + 1) % 3]! += c;
      at[(axis + 2) % 3]! += s;
      return at;
    }),
  );
  return known(
    'a box minus a sphere',
    set('subtraction', 'hard', box(a, a, a), ball),
    [...faces([a, a, a]), ball],
    [...straight.flatMap(([from, to]) => line(from, to)), ...arcs],
  );
}

/** Of three directions that are not square to each other. */
function slabs(): CreaseCase {
  const normals = (
    [
      [1, 0.1, 0],
      [0.3, 1, 0.1],
      [0.2, -0.3, 1],
    ] as const
  ).map((n): Point => {
    const length = Math.hypot(...n);
    return [n[0] / length, n[1] / length, n[2] / length];
  });
  const widths: Point = [4, 3, 5];
  // Cramer's rule
  const cross = (u: Point, v: Point): Point => [
    u[1] * v[2] - u[2] * v[1],
    u[2] * v[0] - u[0] * v[2],
    u[0] * v[1] - u[1] * v[0],
  ];
  const [n0, n1, n2] = normals as unknown as [Point, Point, Point];
  const duals = [cross(n1, n2), cross(n2, n0), cross(n0, n1)] as const;
  const whole = n0[0] * duals[0][0] + n0[1] * duals[0][1] + n0[2] * duals[0][2];
  const corner = (signs: Point): Point => {
    const at = (k: 0 | 1 | 2) =>
      AXES.reduce<number>((sum, i) => sum + (signs[i] * widths[i] * duals[i][k]) / whole, 0);
    return [at(0), at(1), at(2)];
  };
  const parts = AXES.map((i) => along(normals[i]!, box(30, widths[i], 30)));
  const sides = AXES.flatMap((i) =>
    SIGNS.map((sign) => {
      const [x, y, z] = normals[i]!;
      return plane([sign * x, sign * y, sign * z], widths[i]);
    }),
  );
  const all = edges(corner).flatMap(([a, b]) => line(a, b));
  return known('three slabs', set('intersection', 'hard', ...parts), sides, all);
}

const limb = (a: Point, b: Point, from: number, to: number) =>
  ({ skel: { type: 'segment', a, b, radii: [from, to] } }) as const;

/** A whale: a body of limbs; its mouth, a plate's body, is taken away. */
function whale(): CreaseCase {
  const trunk = body([
    limb([-6, 0.5, 0], [0, 0, 0], 0.8, 2.5),
    limb([0, 0, 0], [5, 0, 0], 2.5, 2.2),
    limb([-6, 0.5, 0], [-8, 1, 2], 0.6, 0.6),
    limb([-6, 0.5, 0], [-8, 1, -2], 0.6, 0.6),
  ]);
  const loop = [
    [3, -5],
    [10, -5],
    [10, 5],
    [3, 5],
  ] as const;
  const mouth = body([
    {
      skel: {
        type: 'polygon',
        origin: [0, -0.2, 0],
        u: [1, 0, 0],
        v: [0, 0, 1],
        loops: [loop],
        weight: 0.145,
      },
    },
  ]);
  return traced('a whale with a mouth', 'subtraction', trunk, mouth);
}

function crossed(): CreaseCase {
  const one = body([limb([-6, 0, 0], [6, 1, 0], 2.4, 2)]);
  const other = body([limb([0, -6, 0], [1, 6, 0.5], 1, 1)]);
  return traced('two bodies', 'union', one, other);
}

function traced(name: string, type: 'subtraction' | 'union', a: FieldNode, b: FieldNode): CreaseCase {
  const sides = [bindField(a), bindField(b)] as const;
  return { name, node: set(type, 'hard', a, b), sides, crease: intersection(...sides) };
}

/** The nearest point with f = g = 0, by Gauss–Newton, and the direction of the curve there; null where none is found. */
function onBoth(f: TreeField, g: TreeField, from: Point): { readonly at: Point; readonly way: Point } | null {
  let at = from;
  for (let i = 0; i < 40; i++) {
    const [u, ux, uy, uz] = evaluated(f, at);
    const [v, vx, vy, vz] = evaluated(g, at);
    const [uu, uv, vv] = [
      ux * ux + uy * uy + uz * uz,
      ux * vx + uy * vy + uz * vz,
      vx * vx + vy * vy + vz * vz,
    ];
    const whole = uu * vv - uv * uv;
    const way: Point = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    if (!(whole > 1e-12 * uu * vv)) return null;
    if (Math.abs(u) < 1e-11 && Math.abs(v) < 1e-11) {
      const length = Math.sqrt(whole);
      return { at, way: [way[0] / length, way[1] / length, way[2] / length] };
    }
    const [p, q] = [(u * vv - v * uv) / whole, (v * uu - u * uv) / whole];
    const step: Point = [p * ux + q * vx, p * uy + q * vy, p * uz + q * vz];
    // far away slopes say little
    const k = Math.min(1, 0.5 / Math.hypot(...step));
    at = [at[0] - k * step[0], at[1] - k * step[1], at[2] - k * step[2]];
  }
  return null;
}

/** All closed curves f = g = 0 that starts drawn by lot lead to. */
function intersection(f: TreeField, g: TreeField): Point[] {
  const next = random(94);
  const all: Point[] = [];
  const distance = (p: Point, q: Point) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  for (let i = 0; i < 200; i++) {
    const start = onBoth(f, g, [16 * next() - 8, 6 * next() - 3, 8 * next() - 4]);
    if (!start || all.some((p) => distance(p, start.at) < 2 * APART)) continue;
    let here = start;
    do {
      all.push(here.at);
      const [x, y, z] = here.at;
      const [dx, dy, dz] = here.way;
      here = onBoth(f, g, [x + 0.9 * APART * dx, y + 0.9 * APART * dy, z + 0.9 * APART * dz])!;
    } while (distance(here.at, start.at) > 0.6 * APART);
  }
  return all;
}

export const creaseCases = (): readonly CreaseCase[] => [
  aBox(),
  aCylinder(),
  bittenBox(),
  slabs(),
  whale(),
  crossed(),
];
