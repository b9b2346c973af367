/** Walking along a line: s is the advance along it, T_l its direction; what sticks out of the line belongs to the section. */
import { once } from '../math/once.ts';
import { add2, cross2, dot2, scale2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Axis } from './axis.ts';
import type { Probe } from './axisProbes.ts';
import type { Spine } from './sheet.ts';
import type { Side2 } from './sideView.ts';

/** `along`: unit, in the side view; `probes`: how far the way goes, and its mean place across. */
export function lineAxis(spine: Spine, view: Side2, along: Vec2, probes: readonly Probe[]): Axis {
  const places = probes.map(({ l }) => dot2(along, l));
  const from = Math.min(...places);
  const length = Math.max(...places) - from;
  const middle = probes.reduce((sum, { l }) => sum + cross2(along, l), 0) / probes.length;
  const across: Vec2 = [-along[1], along[0]];
  const on = (place: number): Vec2 => add2(scale2(along, place), scale2(across, middle));
  return {
    length,
    ends: [on(from), on(from + length)],
    straight: true,
    closed: false,
    breaks: spine.stops,
    at: (u, side) => {
      const station = spine.at(u, side);
      const place = once(() => dot2(along, view.point(station.centre)));
      const speed = once(() => dot2(along, view.flat(station.rate)));
      return {
        walked: () => place() - from,
        speed,
        point: once(() => on(place())),
        rate: once(() => scale2(along, speed())),
        direction: () => along,
      };
    },
  };
}
