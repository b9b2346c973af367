/** What the pen drew, on a plane. */
import { cross3, dot3 } from '../math/tuple.ts';
import { facingPlane, onPlane, rayAt } from '../stroke/plane.ts';
import { isInReach, type Plane, type Sample, type Stroke, type View } from '../stroke/stroke.ts';
import type { Pen } from './tool.ts';
import type { Viewport } from './viewport.ts';

/** Cosine between line of sight and plane normal below which strokes would stretch over five times. */
const EDGE_ON = 0.2;

export function isEdgeOn(plane: Plane, view: View): boolean {
  const facing = facingPlane(view, plane.origin);
  return Math.abs(dot3(cross3(plane.x, plane.y), cross3(facing.x, facing.y))) < EDGE_ON;
}

/** A stroke along the pens, as seen in `view`; null: it lies nowhere. */
export function strokeOn(
  plane: Plane,
  pens: readonly Pen[],
  view: View,
  size: Viewport['size'],
  closed = false,
): Stroke | null {
  const start = pens[0]?.time ?? 0;
  const samples: Sample[] = [];
  for (const pen of pens) {
    const p = onPlane(rayAt(view, size, pen.x, pen.y), plane);
    if (!p || !isInReach(p)) continue;
    const { pressure, tiltX, tiltY } = pen;
    samples.push({ x: p[0], y: p[1], pressure, tiltX, tiltY, time: pen.time - start });
  }
  if (samples.length < 2 || !isInReach(plane.origin)) return null;
  return { samples, plane, view, pointer: pens[0]?.pointer ?? 'mouse', closed };
}
