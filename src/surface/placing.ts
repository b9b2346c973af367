/** Stands (stand.ts) as linear maps of outlines into space, and how those change with u. */
import { dot2, scale2 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import type { Source } from './source.ts';
import type { Stand } from './stand.ts';

/** (x, y) of an outline is at centre + x half + y depth. */
export interface Axes {
  readonly centre: Vec3;
  readonly half: Vec3;
  readonly depth: Vec3;
}

export interface Placing {
  readonly axes: Axes;
  /** by u */
  readonly rates: Axes;
}

/** u over which the change along one stroke is measured, by differences of second order: 1e-8 of what it is */
const STEP = 1e-4;

export function axesOf({ left, right, radius }: Stand): Axes {
  return {
    centre: flat([(left[0] + right[0]) / 2, (left[1] + right[1]) / 2]),
    half: flat([(right[0] - left[0]) / 2, (right[1] - left[1]) / 2]),
    depth: [0, 0, radius],
  };
}

export function placingAt(source: Source, u: number, side: -1 | 1): Placing {
  const stand = source.stand(u, side);
  const axes = axesOf(stand);
  return { axes, rates: source.paired ? ratesOf(stand) : differences(source, axes, u, side) };
}

function ratesOf({ axis, dCentre, dHalf }: Stand): Axes {
  return { centre: flat(dCentre), half: flat(scale2(dHalf, -1)), depth: [0, 0, dot2(dHalf, axis)] };
}

/** A stroke's curvature is not known where its tube does not need it. */
function differences(source: Source, here: Axes, u: number, wished: -1 | 1): Axes {
  const { stops } = source;
  // one value for both sides where it is smooth
  const side = stops.some((stop) => stop.u === u) ? wished : 1;
  const room = Math.min(...stops.map((stop) => (stop.u - u) * side).filter((way) => way > 0));
  const step = side * Math.min(STEP, room / 4);
  const [one, two] = [axesOf(source.stand(u + step, 1)), axesOf(source.stand(u + 2 * step, 1))];
  const rate = (key: keyof Axes): Vec3 => {
    const at = (k: 0 | 1 | 2): number => (4 * one[key][k] - 3 * here[key][k] - two[key][k]) / (2 * step);
    return [at(0), at(1), at(2)];
  };
  return { centre: rate('centre'), half: rate('half'), depth: rate('depth') };
}

function flat([x, y]: Vec2): Vec3 {
  return [x, y, 0];
}
