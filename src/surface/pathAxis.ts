/** Walking along the path: s is the arc length of l, T_l = ± l′/|l′|, and where that says nothing what holds.ts leads it through. */
import { once } from '../math/once.ts';
import { dot2, length2, scale2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import { arcTable } from './arcTable.ts';
import type { Axis } from './axis.ts';
import { type Probe, wayOf } from './axisProbes.ts';
import { directionIn, holdAt, holdsOf, signAt } from './holds.ts';
import type { Spine } from './sheet.ts';
import type { Side2 } from './sideView.ts';

/** slower than this part of the mean, l stands still */
const STILL = 1e-4;
/** … and this slow its direction is rounding */
const NOISE = 1e-9;

export function pathAxis(spine: Spine, view: Side2, probes: readonly Probe[], closed: boolean): Axis {
  const mean = wayOf(probes);
  const holds = holdsOf(probes, STILL * mean);
  const rateAt = (u: number, side: -1 | 1): Vec2 => view.flat(spine.at(u, side).rate);
  const direction = (u: number, side: -1 | 1, rate: Vec2): Vec2 => {
    const hold = holdAt(holds, u);
    if (hold) return directionIn(hold, u);
    const moving = movingRate(rateAt, rate, u, side, spine.stops, NOISE * mean);
    return scale2(moving, signAt(holds, u) / (length2(moving) || 1));
  };
  const speed = (u: number, side: -1 | 1, rate: Vec2): number =>
    holdAt(holds, u) ? dot2(rate, direction(u, side, rate)) : signAt(holds, u) * length2(rate);
  const edges = holds.flatMap(({ from, to }) => [from, to]);
  const breaks = [...new Set([...spine.stops, ...edges])].sort((a, b) => a - b);
  const table = arcTable((u) => speed(u, 1, rateAt(u, 1)), breaks);
  return {
    length: table.most - table.least,
    ends: [probes[0]!.l, probes[probes.length - 1]!.l],
    straight: false,
    closed,
    breaks,
    at: (u, side) => {
      const station = spine.at(u, side);
      const rate = once(() => view.flat(station.rate));
      return {
        walked: () => table.upTo(u) - table.least,
        speed: once(() => speed(u, side, rate())),
        point: once(() => view.point(station.centre)),
        rate,
        direction: once(() => direction(u, side, rate())),
      };
    },
  };
}

/** l′ at u, or a little further inside the piece where it vanishes (poles). */
function movingRate(
  rateAt: (u: number, side: -1 | 1) => Vec2,
  here: Vec2,
  u: number,
  side: -1 | 1,
  stops: readonly number[],
  still: number,
): Vec2 {
  if (length2(here) > still) return here;
  const edge = side === 1 ? stops.find((stop) => stop > u) : stops.findLast((stop) => stop < u);
  for (const part of [1e-6, 1e-4, 1e-2, 0.1]) {
    const inside = rateAt(u + part * ((edge ?? u) - u), side);
    if (length2(inside) > still) return inside;
  }
  return [1, 0];
}
