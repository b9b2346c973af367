/**
 * From a place close to the surface along a ray onto the surface itself: Newton's steps, and halves where these leave what is left between
 * two signs.
 */
import { add3, length3, scale3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Field } from '../shape/shape.ts';

export interface SurfaceHit {
  readonly point: Vec3;
  /** unit, out of the body */
  readonly normal: Vec3;
}

const STEPS = 40;
/** of the reach */
const CLOSE = 1e-9;

/** Within `reach` mm before or behind `near`; null where the field has one sign along all of that, or no slope. */
export function surfaceHit(
  field: Pick<Field, 'evaluate'>,
  near: Vec3,
  along: Vec3,
  reach: number,
): SurfaceHit | null {
  const out = new Float64Array(4);
  const at = (t: number): Vec3 => {
    const place = add3(near, scale3(along, t));
    field.evaluate(...place, out);
    return place;
  };
  at(-reach);
  const isInside = out[0]! > 0;
  at(reach);
  if (out[0]! > 0 === isInside) return null;
  let [low, high, t] = [-reach, reach, 0];
  for (let i = 0; i < STEPS; i++) {
    at(t);
    if (out[0]! > 0 === isInside) low = t;
    else high = t;
    const step = -out[0]! / (out[1]! * along[0] + out[2]! * along[1] + out[3]! * along[2]);
    if (Math.abs(step) < CLOSE * reach) break;
    t = t + step > low && t + step < high ? t + step : 0.5 * (low + high);
  }
  const point = at(t);
  const slope: Vec3 = [out[1]!, out[2]!, out[3]!];
  const length = length3(slope);
  return length > 0 ? { point, normal: scale3(slope, -1 / length) } : null;
}
