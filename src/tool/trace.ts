/** The pen's path while it is down, and the stroke it is on a plane. */
import { LIMITS } from '../document/limits.ts';
import { length2 } from '../math/tuple.ts';
import type { Plane, Stroke, View } from '../stroke/stroke.ts';
import { strokeOn } from './penStroke.ts';
import type { Pen } from './tool.ts';
import type { Viewport } from './viewport.ts';

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

/** Null where it is too short, or the plane is not under it. */
export const strokeOf = (
  plane: Plane,
  { pens, view, length }: Trace,
  size: Viewport['size'],
  closed = false,
): Stroke | null => (length < LEAST_LENGTH ? null : strokeOn(plane, pens, view, size, closed));
