/** A stroke that is too short for a line: where it is. */
import type { Vec2 } from '../../math/vec.ts';
import type { Curve } from '../../stroke/curve.ts';
import type { Sample } from '../../stroke/stroke.ts';

/** null without samples. */
export function dotOf(samples: readonly Sample[]): Curve | null {
  const [first] = samples;
  if (!first) return null;
  const at: Vec2 = [first.x, first.y];
  return {
    closed: false,
    length: 0,
    corners: [],
    point: () => at,
    tangent: () => [1, 0],
    pressure: () => first.pressure,
  };
}
