/** What l is like when looked at as a line: how far it strays from one, and whether it runs along it without swinging about. */
import { atan2, cos, sin } from '../math/trig.ts';
import { add2, cross2, dot2, length2, scale2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Probe } from './axisProbes.ts';

/** l is straight when it strays from a line by this part of its extent */
const STRAIGHT = 0.05;
/** … and one with the line when it strays by no more than rounding */
const EXACT = 1e-12;
/** cosine of the swing (30°) that leaves l′ as the direction of a straight l */
const QUIET = 0.866;
/** slower than this part of the extent for the whole way, l stands still */
const STILL = 1e-4;

export interface Way {
  /** unit, from start to end */
  readonly along: Vec2;
  readonly straight: boolean;
  readonly exact: boolean;
  /** l′ is everywhere about along the line */
  readonly quiet: boolean;
}

/** `extent`: of the probes, mm, above 0. `closed`: the way has no chord. */
export function lineOf(probes: readonly Probe[], extent: number, closed: boolean): Way {
  const chord = sub2(probes[probes.length - 1]!.l, probes[0]!.l);
  const along =
    !closed && length2(chord) > 0.5 * extent ? scale2(chord, 1 / length2(chord)) : longest(probes);
  const across = probes.map(({ l }) => cross2(along, l));
  const stray = (Math.max(...across) - Math.min(...across)) / extent;
  const quiet = probes.every(({ rate }) => {
    const speed = length2(rate);
    return speed > STILL * extent && dot2(rate, along) >= QUIET * speed;
  });
  return { along, straight: stray <= STRAIGHT, exact: stray <= EXACT, quiet };
}

/** The direction in which the points are spread most, pointing as the way does first. */
function longest(probes: readonly Probe[]): Vec2 {
  const n = probes.length;
  const mean = scale2(
    probes.reduce<Vec2>((sum, { l }) => add2(sum, l), [0, 0]),
    1 / n,
  );
  let [xx, xy, yy] = [0, 0, 0];
  for (const { l } of probes) {
    const [x, y] = sub2(l, mean);
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const angle = 0.5 * atan2(2 * xy, xx - yy);
  const along: Vec2 = [cos(angle), sin(angle)];
  const places = probes.map(({ l }) => dot2(along, l));
  const forth = places.indexOf(Math.max(...places)) >= places.indexOf(Math.min(...places));
  return forth ? along : scale2(along, -1);
}
