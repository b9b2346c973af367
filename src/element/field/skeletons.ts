/**
 * The skeletons to choose from, with radii in place of weights: mm, for a page on which the radius is set to 16 mm. The weights
 * come in tree.ts, for the kernel at hand.
 */
import type { Colour } from '../../field/node.ts';
import { cos, sin, TAU } from '../../math/trig.ts';
import type { Vec2, Vec3 } from '../../math/vec.ts';
import { PAINT } from './palette.ts';

interface PointPiece {
  readonly type: 'point';
  readonly at: Vec3;
  readonly radius: number;
  readonly colour: Colour;
}

export interface LinePiece {
  readonly type: 'segment' | 'loop' | 'curve' | 'spline';
  /** two of a segment; at least 4 control points of a curve; on, off, on … of a spline of quadratic pieces */
  readonly points: readonly Vec3[];
  /** one a point; of a spline, one a point that it goes through */
  readonly radii: readonly number[];
  readonly colour: Colour;
}

export interface ArcPiece {
  readonly type: 'arc';
  readonly centre: Vec3;
  readonly start: Vec3;
  /** about z, radians */
  readonly angle: number;
  /** at both ends */
  readonly radii: readonly number[];
  readonly colour: Colour;
}

/** A line whose weight is a drawn curve. */
export interface WeightCurvePiece {
  readonly type: 'profile';
  readonly points: readonly Vec3[];
  /** that the weight would keep which it has at first */
  readonly radius: number;
  readonly colour: Colour;
}

export interface PlatePiece {
  readonly type: 'plate';
  /** upright, facing the viewer */
  readonly loops: readonly (readonly Vec2[])[];
  readonly radius: number;
  readonly colour: Colour;
}

export type Piece = PointPiece | LinePiece | ArcPiece | WeightCurvePiece | PlatePiece;

/** The radius for which the pieces are given, mm. */
export const NOMINAL = 16;

const line = (colour: Colour, ...ends: readonly (readonly [...Vec3, number])[]): LinePiece => ({
  type: 'segment',
  points: ends.map(([x, y, z]): Vec3 => [x, y, z]),
  radii: ends.map(([, , , radius]) => radius),
  colour,
});
const curve = (...of: Parameters<typeof line>): LinePiece => ({ ...line(...of), type: 'curve' });
const spot = (colour: Colour, x: number, y: number, z: number, radius: number): PointPiece => ({
  type: 'point',
  at: [x, y, z],
  radius,
  colour,
});

const circle = (count: number, radius: (i: number) => number, turn = 0): Vec2[] =>
  Array.from({ length: count }, (_, i) => {
    const angle = turn + (i * TAU) / count;
    return [radius(i) * cos(angle), radius(i) * sin(angle)];
  });

/** A fox. Pairs stand to both sides of the plane of its drawing. */
function animal(): readonly Piece[] {
  const { fox, cream, bark, coal } = PAINT;
  const sides = [-1, 1].flatMap((side): Piece[] => [
    line(fox, [24, -8, 10 * side, 7], [25, -34, 11 * side, 5]),
    line(bark, [25, -36, 11 * side, 5], [26, -60, 11 * side, 5]),
    line(fox, [-36, -6, 10 * side, 10], [-40, -32, 12 * side, 5.5]),
    line(bark, [-40, -34, 12 * side, 5], [-35, -60, 12 * side, 5]),
    line(fox, [42, 52, 9 * side, 6], [37, 66, 13 * side, 4]),
    line(bark, [37, 67, 13 * side, 3.5], [35, 74, 15 * side, 2.5]),
    spot(coal, 57, 47, 8 * side, 2.4),
  ]);
  return [
    line(fox, [-36, 2, 0, 16], [22, 4, 0, 17]),
    line(cream, [16, -8, 0, 8], [34, 8, 0, 11]),
    line(fox, [26, 10, 0, 12], [42, 34, 0, 11]),
    line(fox, [43, 42, 0, 15], [52, 42, 0, 13]),
    line(cream, [55, 36, 0, 8], [75, 34, 0, 4.5]),
    spot(coal, 80, 36, 0, 3.2),
    curve(fox, [-48, 6, 0, 6], [-66, 4, 0, 9], [-84, 14, 0, 12], [-92, 36, 0, 11]),
    line(cream, [-92, 38, 0, 10], [-92, 54, 0, 4]),
    ...sides,
  ];
}

const star = circle(10, (i) => (i % 2 === 0 ? 58 : 24), TAU / 4);
const frame = circle(6, () => 56);

/** By the ids of the choice `skeleton`. */
export const SKELETONS: Readonly<Record<string, () => readonly Piece[]>> = {
  animal,
  point: () => [spot(PAINT.red, 0, 0, 0, NOMINAL)],
  segment: () => [line(PAINT.pear, [-50, 0, 0, NOMINAL], [50, 0, 0, NOMINAL])],
  crossed: () => [
    line(PAINT.red, [-50, -28, 0, NOMINAL], [50, 28, 0, NOMINAL]),
    line(PAINT.blue, [-50, 28, 0, NOMINAL], [50, -28, 0, NOMINAL]),
  ],
  tree: () => [
    line(PAINT.wood, [0, -60, 0, NOMINAL], [0, 0, 0, 12]),
    line(PAINT.leaf, [0, 0, 0, 12], [-38, 50, 14, 8]),
    line(PAINT.pear, [0, 0, 0, 12], [42, 44, -14, 8]),
  ],
  ring: () => [
    {
      type: 'loop',
      points: circle(32, () => 44).map(([x, y]): Vec3 => [x, y, 0]),
      radii: Array.from({ length: 32 }, () => NOMINAL),
      colour: PAINT.violet,
    },
  ],
  curve: () => [
    curve(
      PAINT.teal,
      [-70, -30, 0, 5],
      [-50, 60, 30, 10],
      [0, 40, 0, NOMINAL],
      [0, -40, 0, NOMINAL],
      [50, -60, -30, 10],
      [70, 30, 0, 5],
    ),
  ],
  spline: () => [
    {
      type: 'spline',
      points: [
        [-72, -16, 0],
        [-38, 64, 24],
        [0, 0, 0],
        [38, -64, -24],
        [72, 16, 0],
      ],
      radii: [8, NOMINAL, 8],
      colour: PAINT.leaf,
    },
  ],
  arc: () => [
    {
      type: 'arc',
      centre: [0, 0, 0],
      start: [46, 0, 0],
      angle: 0.7 * TAU,
      radii: [NOMINAL, 8],
      colour: PAINT.fox,
    },
  ],
  profile: () => [
    {
      type: 'profile',
      points: [
        [-66, -24, 0],
        [-26, 20, 0],
        [26, 20, 0],
        [66, -24, 0],
      ],
      radius: NOMINAL,
      colour: PAINT.rose,
    },
  ],
  concave: () => [{ type: 'plate', loops: [star], radius: NOMINAL, colour: PAINT.pear }],
  holed: () => [{ type: 'plate', loops: [frame, circle(24, () => 26)], radius: NOMINAL, colour: PAINT.wood }],
};

export const hasPlate = (skeleton: string): boolean =>
  SKELETONS[skeleton]!().some(({ type }) => type === 'plate');
