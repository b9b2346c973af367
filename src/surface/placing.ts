/** Stand-in for stand.ts. */
import { dot2 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import type { Pair } from './pair.ts';
import { ringAt } from './ring.ts';
import type { Stand } from './stand.ts';

export interface Standing {
  readonly closed: boolean;
  readonly length: number;
  readonly stops: readonly { readonly u: number; readonly pole: boolean }[];
  at(u: number, side: -1 | 1): Stand;
}

export function standingOf(pair: Pair): Standing {
  const isPole = (u: number): boolean => pair.stops.some((stop) => stop.pole && stop.u === u);
  return {
    closed: pair.closed,
    length: pair.length,
    stops: pair.stops,
    at: (u, side) => ringAt(pair, u, side, isPole(u)),
  };
}

/** How a stand maps (x, y) of an outline: centre + x half + y depth. */
export interface Axes {
  readonly centre: Vec3;
  readonly half: Vec3;
  readonly depth: Vec3;
}

export function axesOf({ left, right, radius }: Stand): Axes {
  return {
    centre: flat([(left[0] + right[0]) / 2, (left[1] + right[1]) / 2]),
    half: flat([(right[0] - left[0]) / 2, (right[1] - left[1]) / 2]),
    depth: [0, 0, radius],
  };
}

/** Their derivatives by u. */
export function ratesOf({ axis, dCentre, dHalf }: Stand): Axes {
  return { centre: flat(dCentre), half: flat([-dHalf[0], -dHalf[1]]), depth: [0, 0, dot2(dHalf, axis)] };
}

function flat([x, y]: Vec2): Vec3 {
  return [x, y, 0];
}
