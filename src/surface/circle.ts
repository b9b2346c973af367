import { cos, sin, TAU } from '../math/trig.ts';
import type { Vec2 } from '../math/vec.ts';

/** (cos v, sin v) of each column, v = 2π j / columns. */
export type Circle = readonly Vec2[];

/** Quarter turns are exact, so that points on an axis of the circle stay on it to the last bit. */
export function unitCircle(columns: number): Circle {
  return Array.from({ length: columns }, (_, j) => {
    if ((4 * j) % columns === 0) return QUARTERS[(4 * j) / columns]!;
    const angle = (TAU * j) / columns;
    return [cos(angle), sin(angle)];
  });
}

/** With the first once more at the end, as rows of the grid have it. */
export function closedCircle(columns: number): Circle {
  const circle = unitCircle(columns);
  return [...circle, circle[0]!];
}

const QUARTERS: Circle = [
  [1, 0],
  [0, 1],
  [-1, 0],
  [0, -1],
];
