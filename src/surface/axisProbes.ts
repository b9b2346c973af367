/** Places on a spine that tell what its axis is like in a side view: about even in u, both sides of stops. */
import { distance2 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import type { Spine } from './sheet.ts';
import type { Side2 } from './sideView.ts';

/** A place on l, mm in the side view, with l′(u) there. */
export interface Probe {
  readonly u: number;
  readonly side: -1 | 1;
  readonly l: Vec2;
  readonly rate: Vec2;
}

/** probes of the whole way, and of a piece at least */
const PROBES = 160;
const FEWEST = 9;

export function probesOf(spine: Spine, view: Side2): Probe[] {
  return spine.stops.slice(1).flatMap((to, i) => {
    const from = spine.stops[i]!;
    const count = Math.max(Math.ceil(PROBES * (to - from)), FEWEST);
    return Array.from({ length: count + 1 }, (_, k) => {
      const side = k === count ? -1 : 1;
      return probe(spine, view, k === count ? to : from + ((to - from) * k) / count, side);
    });
  });
}

function probe(spine: Spine, view: Side2, u: number, side: -1 | 1): Probe {
  const { centre, rate } = spine.at(u, side);
  return { u, side, l: view.point(centre), rate: view.flat(rate) };
}

/** The diagonal of the box of l, mm. */
export function extentOf(probes: readonly Probe[]): number {
  return extent(probes.map(({ l }) => [l[0], l[1], 0]));
}

/** … and of the spine in space. */
export function depthOf(spine: Spine): number {
  return extent(Array.from({ length: 33 }, (_, i) => spine.at(i / 32, i === 32 ? -1 : 1).centre));
}

function extent(points: readonly Vec3[]): number {
  const sides = ([0, 1, 2] as const).map((k) => {
    const xs = points.map((p) => p[k]);
    return Math.max(...xs) - Math.min(...xs);
  });
  return Math.sqrt(sides.reduce((sum, side) => sum + side * side, 0));
}

/** The length of l, about, mm. */
export function wayOf(probes: readonly Probe[]): number {
  return probes.reduce((sum, { l }, i) => sum + (i > 0 ? distance2(l, probes[i - 1]!.l) : 0), 0);
}
