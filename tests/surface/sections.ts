/** Outlines of sections known in closed form. */
import type { Vec2 } from '../../src/math/vec.ts';
import type { Outline } from '../../src/surface/outline.ts';

type Point = (v: number) => Vec2;

/** A smooth outline with its derivative by differences of fourth order (1e-12). */
export function smooth(point: Point, closed: boolean): Outline {
  const h = 1e-3;
  const wrap = (v: number): Vec2 => point(closed ? v : v);
  return {
    closed,
    corners: [],
    point,
    derivative: (v) =>
      [0, 1].map((k) => {
        const at = (d: number): number => wrap(v + d * h)[k]!;
        return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
      }) as unknown as Vec2,
  };
}

/** Half an ellipse from q_l to q_r, `height` half chords high (negative: hollow). */
export function arch(height: number): Outline {
  return {
    closed: false,
    corners: [],
    point: (v) => [-Math.cos(Math.PI * v), height * Math.sin(Math.PI * v)],
    derivative: (v) => [Math.PI * Math.sin(Math.PI * v), Math.PI * height * Math.cos(Math.PI * v)],
  };
}

export const STRAIGHT: Outline = {
  closed: false,
  corners: [],
  point: (v) => [2 * v - 1, 0],
  derivative: () => [2, 0],
};

/** An ellipse, front first. */
export function oval(height: number): Outline {
  return {
    closed: true,
    corners: [],
    point: (v) => [-Math.cos(2 * Math.PI * v), height * Math.sin(2 * Math.PI * v)],
    derivative: (v) => [
      2 * Math.PI * Math.sin(2 * Math.PI * v),
      2 * Math.PI * height * Math.cos(2 * Math.PI * v),
    ],
  };
}

/** A round outline with `count` bumps. */
export function bumpy(count: number, depth: number): Outline {
  return smooth((v) => {
    const angle = 2 * Math.PI * v;
    const r = 1 - depth * (1 - Math.cos(count * angle));
    return [-r * Math.cos(angle), r * Math.sin(angle)];
  }, true);
}

/** Straight lines from place to place, each at its v (from 0 to 1); corners where they meet. */
export function lines(
  places: readonly (readonly [v: number, x: number, y: number])[],
  closed: boolean,
): Outline {
  const piece = (v: number, side: -1 | 1): number => {
    let i = 0;
    while (i + 2 < places.length && (side === 1 ? v >= places[i + 1]![0] : v > places[i + 1]![0])) i++;
    return i;
  };
  const inner = places.slice(closed ? 0 : 1, -1).map(([v]) => v);
  return {
    closed,
    corners: inner,
    point: (v) => {
      const i = piece(v, 1);
      const [from, to] = [places[i]!, places[i + 1]!];
      const t = (v - from[0]) / (to[0] - from[0]);
      return [from[1] * (1 - t) + to[1] * t, from[2] * (1 - t) + to[2] * t];
    },
    derivative: (v, side) => {
      const i = piece(v, side);
      const [from, to] = [places[i]!, places[i + 1]!];
      return [(to[1] - from[1]) / (to[0] - from[0]), (to[2] - from[2]) / (to[0] - from[0])];
    },
  };
}

/** A ridge: q_l, the ridge at v, q_r. */
export function ridge(v: number, x: number, y: number): Outline {
  return lines(
    [
      [0, -1, 0],
      [v, x, y],
      [1, 1, 0],
    ],
    false,
  );
}

/** A square with its corners at q_l, q_r, front and back. */
export const DIAMOND = lines(
  [
    [0, -1, 0],
    [0.25, 0, 1],
    [0.5, 1, 0],
    [0.75, 0, -1],
    [1, -1, 0],
  ],
  true,
);
