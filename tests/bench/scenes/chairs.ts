/** Chairs of plates: twenty polygon skels of twenty vertices each, the limit of Zhu et al. 2011; one, and rows of them. */
import type { Affine } from '../../../src/field/affine.ts';
import type { FieldNode, SkelsNode, Term } from '../../../src/field/node.ts';
import type { Vec2, Vec3 } from '../../../src/math/vec.ts';
import type { PolygonSkel } from '../../../src/skeleton/skels.ts';
import { random } from '../../fixtures/random.ts';

/** mm from one chair to the next, which is some 1.2 wide */
const APART = 2;
const SIDES: Vec3 = [0, 0, 1];
const UP: Vec3 = [0, 1, 0];
const ACROSS: Vec3 = [1, 0, 0];

const BODY = { type: 'skels', kernel: 'cauchy', params: { s: 20 }, threshold: 0.004 } as const;

/** A rectangle about the origin of its plane with round corners, five vertices each. */
function outline(x: number, y: number): Vec2[] {
  const round = 0.5 * Math.min(x, y);
  return Array.from({ length: 20 }, (_, i) => {
    const angle = (Math.PI / 2) * (Math.floor(i / 5) + (i % 5) / 4);
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const corner = Math.PI / 4 + (Math.PI / 2) * Math.floor(i / 5);
    return [
      Math.sign(Math.cos(corner)) * (x - round) + round * c,
      Math.sign(Math.sin(corner)) * (y - round) + round * s,
    ];
  });
}

const plate = (origin: Vec3, u: Vec3, v: Vec3, x: number, y: number): PolygonSkel => ({
  type: 'polygon',
  origin,
  u,
  v,
  loops: [outline(x, y)],
  weight: 1,
});

/** Width, depth and height vary by the seed: seat, back of seven, legs, arms of four, stretchers. */
function plates(seed: number): PolygonSkel[] {
  const next = random(seed);
  const some = (size: number) => size * (0.9 + 0.2 * next());
  const [wide, deep, high] = [some(0.5), some(0.5), some(1)];
  const pair = [-1, 1] as const;
  const corners = pair.flatMap((x) => pair.map((z): readonly [number, number] => [x, z]));
  const slats = Array.from({ length: 5 }, (_, i) => 0.4 * (i - 2) * wide);
  return [
    plate([0, 0, 0], SIDES, ACROSS, deep, wide),
    plate([0, high, -deep], ACROSS, UP, wide, 0.1),
    plate([0, 0.3 * high, -deep], ACROSS, UP, wide, 0.06),
    ...slats.map((x) => plate([x, 0.55 * high, -deep], ACROSS, UP, 0.06, 0.45 * high)),
    ...corners.map(([x, z]) => plate([0.9 * x * wide, -0.35, 0.9 * z * deep], SIDES, UP, 0.08, 0.4)),
    ...pair.map((x) => plate([x * wide, 0.35, 0], SIDES, ACROSS, deep, 0.06)),
    ...pair.map((x) => plate([x * wide, 0.17, 0.8 * deep], SIDES, UP, 0.06, 0.2)),
    ...pair.map((x) => plate([0.9 * x * wide, -0.5, 0], SIDES, UP, 0.9 * deep, 0.05)),
    ...pair.map((z) => plate([0, -0.45, 0.9 * z * deep], ACROSS, UP, 0.9 * wide, 0.05)),
  ];
}

const body = (skels: readonly Term[]): SkelsNode => ({ ...BODY, skels });

export const chair = (seed: number): SkelsNode => body(plates(seed).map((skel) => ({ skel })));

/** Where the i-th of `rows` times `rows` stands, turned by quarters. */
function stand(i: number, rows: number): Affine {
  const [x, z] = [APART * (i % rows), APART * Math.floor(i / rows)];
  const [c, s] = (
    [
      [1, 0],
      [0, 1],
      [-1, 0],
      [0, -1],
    ] as const
  )[i % 4]!;
  return [c, 0, s, x, 0, 1, 0, 0, -s, 0, c, z];
}

function moved([a, , b, x, , , , , c, , d, z]: Affine, skel: PolygonSkel): PolygonSkel {
  const turned = ([px, py, pz]: Vec3): Vec3 => [a * px + b * pz, py, c * px + d * pz];
  const [ox, oy, oz] = turned(skel.origin);
  return { ...skel, origin: [ox + x, oy, oz + z], u: turned(skel.u), v: turned(skel.v) };
}

/** A field of chairs as one sum: 2,000 skels for ten rows. */
export function chairsAsSum(rows = 10): SkelsNode {
  const all = Array.from({ length: rows * rows }, (_, i) =>
    plates(i + 1).map((skel) => ({ skel: moved(stand(i, rows), skel) })),
  );
  return body(all.flat());
}

/** The same chairs as parts of a union, each to be moved by itself. */
export function chairsAsParts(rows = 10): FieldNode {
  const parts = Array.from({ length: rows * rows }, (_, i): FieldNode => {
    return { type: 'affine', matrix: stand(i, rows), node: chair(i + 1) };
  });
  return { type: 'union', form: 'hard', parts };
}
