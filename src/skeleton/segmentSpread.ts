/**
 * What the field of a segment may be within a ball: how far the segment is from the centre, and whether the ball comes so
 * near to its line that singular kernels are clamped.
 */
import type { Kernel, LineFrame } from '../kernel/kernel.ts';
import { GaussSources } from './gaussSources.ts';
import type { See } from './sight.ts';
import { Spreader } from './spread.ts';
import { weightRange } from './weightRange.ts';

/** of the length: what a distance from the axis loses when it is made orthogonal once */
const BLUR = 2e-15;

/** lengths from which on places on the segment, and so their weights, are off by the last digits of the distance */
const DISTANT = 1e3;
const STRAY = 1e-14;

/** `a` (mm) and `u`: the first end and the direction; `per`: kernel units of a millimetre. */
export function segmentSpreader(
  kernel: Kernel,
  frame: LineFrame,
  a: Float64Array,
  u: Float64Array,
  per: number,
): Spreader {
  const { length, exponent, floor2 } = frame;
  const extent = { dimension: 1, size: length, turns: 1, ...weightRange(frame) } as const;
  // twice the distance at which a line is clamped
  const clear = 2 * Math.sqrt(floor2);
  const { change } = kernel;
  const sources = change.type === 'relative' ? new GaussSources(change, frame, extent.most, a, u, per) : null;
  const see: See = ({ x, y, z, radius }, sight) => {
    const vx = (x - a[0]!) * per;
    const vy = (y - a[1]!) * per;
    const vz = (z - a[2]!) * per;
    const t = vx * u[0]! + vy * u[1]! + vz * u[2]!;
    const nearest = t < 0 ? 0 : t > length ? length : t;
    const room = clear > 0 ? away(vx, vy, vz, t, u) - radius * per - BLUR * (length + Math.abs(t)) : 0;
    sight.distance = Math.max(away(vx, vy, vz, nearest, u) - BLUR * length, 0);
    sight.isClear = room >= clear;
    sight.slack = 0;
    if (!(sight.distance > DISTANT * length)) return;
    const near = Math.max(sight.distance - radius * per, 0);
    sight.slack = STRAY * (sight.distance / length) * spreader.most(near * near);
  };
  const spreader = new Spreader(kernel, exponent, extent, per, see, sources);
  return spreader;
}

/** From a place on the line. */
function away(vx: number, vy: number, vz: number, t: number, u: Float64Array): number {
  const x = vx - t * u[0]!;
  const y = vy - t * u[1]!;
  const z = vz - t * u[2]!;
  return Math.sqrt(x * x + y * y + z * z);
}
