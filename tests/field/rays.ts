/** Where rays meet fields, by intervals alone: halves of the ray, each dropped when the field around it is proven to have one sign. */
import type { Ray } from '../../src/field/raycast.ts';
import type { TreeField } from '../../src/field/treeField.ts';
import type { Vec3 } from '../../src/math/vec.ts';

const range = new Float64Array(2);

export const placeOn = ({ from, along }: Pick<Ray, 'from' | 'along'>, t: number): Vec3 => [
  from[0] + t * along[0],
  from[1] + t * along[1],
  from[2] + t * along[2],
];

export interface Truth {
  /** mm along the ray; null: surely none, but for what is thinner along the ray than `least` */
  readonly t: number | null;
  /** the value next to 0 that the ray has before, where it meets nothing for longer than `least` */
  readonly touch: number;
}

/** The first place between two, mm, at which the field turns from outside to inside; `least`: mm, what is looked at as one place. */
export function firstHit(field: TreeField, ray: Ray, start: number, end: number, least: number): Truth {
  const valueAt = (t: number) => field.value(...placeOn(ray, t));
  let touch = -Infinity;
  const parts: (readonly [number, number])[] = [[start, end]];
  for (let part = parts.pop(); part; part = parts.pop()) {
    const [low, high] = part;
    const middle = 0.5 * (low + high);
    field.range(...placeOn(ray, middle), 0.5 * (high - low), range);
    if (range[1]! <= 0) continue;
    if (high - low <= least || range[0]! > 0) {
      const inside = [high, middle, low].findLast((t) => valueAt(t) > 0);
      touch = Math.max(touch, valueAt(low), valueAt(middle), valueAt(high));
      if (inside === undefined) continue;
      return { t: bisected(valueAt, Math.max(low - least, start), inside), touch };
    }
    parts.push([middle, high], [low, middle]);
  }
  return { t: null, touch };
}

function bisected(valueAt: (t: number) => number, outside: number, inside: number): number {
  let [low, high] = [outside, inside];
  for (let i = 0; i < 60; i++) {
    const middle = 0.5 * (low + high);
    if (valueAt(middle) > 0) high = middle;
    else low = middle;
  }
  return high;
}
