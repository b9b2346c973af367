/** What strokes of one form have in common. */
import type { Plane, Stroke } from '../stroke/stroke.ts';

/** May two strokes be sides of one form? */
export function belongTogether(a: Stroke, b: Stroke): boolean {
  return a.closed === b.closed && samePlane(a.plane, b.plane);
}

export function samePlane(a: Plane, b: Plane): boolean {
  const same = (key: keyof Plane) => a[key].every((value, i) => value === b[key][i]);
  return a === b || (same('origin') && same('x') && same('y'));
}
