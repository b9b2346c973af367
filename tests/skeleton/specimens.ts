/** Skels of every kind, ordinary and nasty, and points to see them from. Coordinates are float32 numbers. */
import type { Vec3 } from '../../src/math/vec.ts';
import type { PolygonSkel, Skel } from '../../src/skeleton/skels.ts';
import { random } from '../fixtures/random.ts';

const PLANE = { origin: [0.25, -0.5, 0.125], u: [1, 0, 0], v: [0, 1, 0] } as const;
const TILTED = { origin: [-0.5, 0.25, 1], u: [0.75, 0.5, -0.25], v: [-0.125, 1, 0.5] } as const;
const shape = (
  frame: Pick<PolygonSkel, 'origin' | 'u' | 'v'>,
  ...loops: PolygonSkel['loops']
): PolygonSkel => ({
  type: 'polygon',
  ...frame,
  loops,
  weight: 1,
});
const star = Array.from({ length: 10 }, (_, i) => {
  const radius = i % 2 ? 0.5 : 1.5;
  return [
    Math.fround(radius * Math.cos((i * Math.PI) / 5)),
    Math.fround(radius * Math.sin((i * Math.PI) / 5)),
  ] as const;
});
const square = (half: number) =>
  [
    [-half, -half],
    [half, -half],
    [half, half],
    [-half, half],
  ] as const;

export const SPECIMENS: { readonly [K in Skel['type']]: readonly Extract<Skel, { readonly type: K }>[] } = {
  point: [
    { type: 'point', at: [0.25, -0.5, 1], weight: 1 },
    { type: 'point', at: [-0.75, 0.5, 0], weight: -2.5 },
  ],
  segment: [
    { type: 'segment', a: [-1, 0.5, 0.25], b: [0.75, -0.25, 0.5], weights: [1] },
    { type: 'segment', a: [0, 0, 0], b: [1.5, 0, 0], weights: [1.5, -0.75] },
    { type: 'segment', a: [0.5, -1, 0.25], b: [0.5, 0.75, -1], weights: [0.25, 0.5, -0.25, 0.125] },
    { type: 'segment', a: [0, 0, -0.0078125], b: [0, 0.00390625, 0], weights: [64, 0, 4096] },
    { type: 'segment', a: [-40, 30, 2], b: [40, -30, 1], weights: [1, 0.015625] },
  ],
  polygon: [
    shape(PLANE, square(1)),
    shape(TILTED, [
      [0, 0],
      [2, 0],
      [2, 0.5],
      [0.5, 0.5],
      [0.5, 1.75],
      [0, 1.75],
    ]),
    shape(TILTED, star),
    shape(PLANE, square(1.5), [...square(0.5)].reverse()),
    shape(PLANE, [
      [-4, 0],
      [4, 0.015625],
      [4, 0.03125],
    ]),
  ],
};

const at = (origin: Vec3, ...steps: readonly (readonly [number, Vec3])[]): Vec3 => {
  const along = (axis: 0 | 1 | 2) =>
    Math.fround(steps.reduce((sum, [step, direction]) => sum + step * direction[axis], origin[axis]));
  return [along(0), along(1), along(2)];
};

function nastyPoints(skel: Skel): Vec3[] {
  switch (skel.type) {
    case 'point':
      return [at(skel.at, [1e-3, [1, 0, 0]]), at(skel.at, [30, [0.5, 0.5, 1]])];
    case 'segment': {
      const u = [skel.b[0] - skel.a[0], skel.b[1] - skel.a[1], skel.b[2] - skel.a[2]] as const;
      const across = [u[1] - u[2], u[2] - u[0], u[0] - u[1]] as const;
      return [
        at(skel.b, [0.5, u]),
        at(skel.a, [-0.01, u]),
        at(skel.a, [-3, u], [1e-3, across]),
        at(skel.a, [0.5, u], [1e-3, across]),
        at(skel.a, [0.75, across]),
        at(skel.b, [0.01, across]),
        at(skel.a, [40, u], [-25, across]),
      ];
    }
    case 'polygon': {
      const { origin, u, v, loops } = skel;
      const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]] as const;
      const [[x0, y0], [x1, y1]] = [loops[0]![0]!, loops[0]![1]!];
      const over = (x: number, y: number, z: number) => at(origin, [x, u], [y, v], [z, n]);
      return [
        over(x0, y0, 0.375),
        over(0.5 * (x0 + x1), 0.5 * (y0 + y1), -0.25),
        over(2 * x1 - x0, 2 * y1 - y0, 0.5),
        over(0.0625, 0.125, 0.0625),
        over(0.25, 0.25, -1.5),
        over(-2.5, 1.75, 0.125),
        over(12, -20, 9),
      ];
    }
  }
}

/** Points around a skel, and those where formulas break. */
export function pointsAround(skel: Skel, seed: number, count = 6): Vec3[] {
  const next = random(seed);
  const middle: Vec3 = skel.type === 'point' ? skel.at : skel.type === 'segment' ? skel.a : skel.origin;
  const one = () => 2.5 * (2 * next() - 1);
  const spread = Array.from({ length: count }, () =>
    at(middle, [one(), [1, 0, 0]], [one(), [0, 1, 0]], [one(), [0, 0, 1]]),
  );
  return [...nastyPoints(skel), ...spread];
}

export const everySpecimen: readonly Skel[] = Object.values(SPECIMENS).flat();
