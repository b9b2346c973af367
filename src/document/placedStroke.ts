/** Strokes that are moved with their group: their plane goes, what was drawn on it stays. */
import { isUnmoved, type Placement, place3 } from '../math/placement.ts';
import { rotate3 } from '../math/tuple.ts';
import type { Stroke } from '../stroke/stroke.ts';

export function placedStroke(stroke: Stroke, by: Placement): Stroke {
  if (isUnmoved(by)) return stroke;
  const { origin, x, y } = stroke.plane;
  const turned = (v: typeof x) => rotate3(by.rotation, v);
  return { ...stroke, plane: { origin: place3(by, origin), x: turned(x), y: turned(y) } };
}
