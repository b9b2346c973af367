/** The parameter in [0, 1] at which a plane curve is nearest to a place: probes, then the sign of (point − place)·tangent halved. */
import { distance2, dot2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';

/** between probes a curve should not turn by more than a quarter */
const PROBES = 256;
/** 256 · 2⁴⁸ is beyond what a double in [0, 1] resolves */
const HALVINGS = 48;

/**
 * `tangent` need not be unit. On closed curves 1 counts as 0. Where two places are equally near the smaller
 * parameter is given; a place that is not a number gives 0.
 */
export function nearestParameter(
  point: (t: number) => Vec2,
  tangent: (t: number) => Vec2,
  place: Vec2,
  closed: boolean,
): number {
  let best = 0;
  let least = Infinity;
  for (let i = 0; i <= PROBES; i++) {
    const away = distance2(point(i / PROBES), place);
    if (away < least) [best, least] = [i, away];
  }
  let [low, high] = [(best - 1) / PROBES, (best + 1) / PROBES];
  if (!closed) [low, high] = [Math.max(low, 0), Math.min(high, 1)];
  const wrap = (t: number): number => (closed ? t - Math.floor(t) : t);
  for (let i = 0; i < HALVINGS; i++) {
    const middle = 0.5 * (low + high);
    const t = wrap(middle);
    if (dot2(sub2(point(t), place), tangent(t)) > 0) high = middle;
    else low = middle;
  }
  const candidates = [best / PROBES, wrap(low), wrap(high)];
  const distances = candidates.map((t) => distance2(point(t), place));
  const nearest = distances.reduce((at, d, i) => (d < distances[at]! ? i : at), 0);
  return closed && candidates[nearest] === 1 ? 0 : candidates[nearest]!;
}
