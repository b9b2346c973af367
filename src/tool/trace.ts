/** The pen's path while it is down, and the stroke it is on a plane. */
import { LIMITS } from '../document/limits.ts';
import { length2 } from '../math/tuple.ts';
import type { ScreenSize } from '../stroke/plane.ts';
import { onPlane, rayAt } from '../stroke/plane.ts';
import { isInReach, type Plane, type Sample, type Stroke, type View } from '../stroke/stroke.ts';
import type { Pen } from './tool.ts';

/** px: a shorter gesture is a dot */
export const LEAST_LENGTH = 12;

export interface Trace {
  /** only ever appended to: copying it at each event would cost the square of its length */
  readonly pens: Pen[];
  /** px along the path */
  readonly length: number;
  /** as one looked when it was begun */
  readonly view: View;
}

export const traceFrom = (pen: Pen, view: View): Trace => ({ pens: [pen], length: 0, view });

/** What a file cannot hold is not drawn. */
export function traced(trace: Trace, more: readonly Pen[]): Trace {
  let { length } = trace;
  for (const pen of more) {
    const last = trace.pens.at(-1) ?? pen;
    if (trace.pens.length >= LIMITS.samples) break;
    trace.pens.push(pen);
    length += length2([pen.x - last.x, pen.y - last.y]);
  }
  return { ...trace, length };
}

/** null where it is too short, or the plane is not under it. */
export function strokeOn(
  plane: Plane,
  { pens, view, length }: Trace,
  size: ScreenSize,
  closed = false,
): Stroke | null {
  if (length < LEAST_LENGTH || !isInReach(plane.origin)) return null;
  const start = pens[0]?.time ?? 0;
  const samples = pens.flatMap((pen): Sample[] => {
    const p = onPlane(rayAt(view, size, pen.x, pen.y), plane);
    if (!p || !isInReach(p)) return [];
    const { pressure, tiltX, tiltY } = pen;
    return [{ x: p[0], y: p[1], pressure, tiltX, tiltY, time: pen.time - start }];
  });
  return samples.length < 2 ? null : { samples, plane, view, pointer: pens[0]?.pointer ?? 'mouse', closed };
}
