/**
 * Stretches of the axis on which l stands still or turns back, where l′/|l′| says nothing (thesis 6.1 leaves it undefined):
 * there its direction is led from one end to the other, and where l turned back, s runs backwards from then on.
 */
import { atan2, cos, sin } from '../math/trig.ts';
import { cross2, dot2, length2, scale2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Probe } from './axisProbes.ts';

/** cosine of the turn (120°) between neighbouring probes that is a turning back */
const BACK = -0.5;

export interface Hold {
  readonly from: number;
  readonly to: number;
  readonly start: Vec2;
  /** radians */
  readonly turn: number;
  /** whether l goes the other way afterwards */
  readonly back: boolean;
}

/** Ascending; `still`: mm for each u below which l stands still. */
export function holdsOf(probes: readonly Probe[], still: number): Hold[] {
  const holds: Hold[] = [];
  let sign = 1;
  let before: Probe | null = null;
  let between = 0;
  for (const here of probes) {
    if (!(length2(here.rate) > still)) {
      between++;
      continue;
    }
    const to = scale2(here.rate, sign / length2(here.rate));
    if (before === null) {
      if (between > 1) holds.push({ from: 0, to: here.u, start: to, turn: 0, back: false });
    } else {
      const start = scale2(before.rate, sign / length2(before.rate));
      const corner = before.u === here.u;
      const back = !corner && dot2(start, to) < BACK;
      if (back || (between > 1 && here.u > before.u)) {
        const end = back ? scale2(to, -1) : to;
        const turn = atan2(cross2(start, end), dot2(start, end));
        holds.push({ from: before.u, to: here.u, start, turn, back });
        if (back) sign = -sign;
      }
    }
    before = here;
    between = 0;
  }
  if (before !== null && between > 1) {
    const start = scale2(before.rate, sign / length2(before.rate));
    holds.push({ from: before.u, to: 1, start, turn: 0, back: false });
  }
  return holds;
}

export function holdAt(holds: readonly Hold[], u: number): Hold | undefined {
  return holds.find(({ from, to }) => u > from && u < to);
}

/** −1 where l runs against s. */
export function signAt(holds: readonly Hold[], u: number): 1 | -1 {
  return holds.filter(({ to, back }) => back && to <= u).length % 2 === 0 ? 1 : -1;
}

/** T_l at u of a hold. */
export function directionIn({ from, to, start, turn }: Hold, u: number): Vec2 {
  const angle = (turn * (u - from)) / (to - from);
  const [[x, y], c, s] = [start, cos(angle), sin(angle)];
  return [c * x - s * y, s * x + c * y];
}
