/** The pen's path while it is down. */
import { LIMITS } from '../document/limits.ts';
import { length2 } from '../math/tuple.ts';
import type { Plane, Stroke, View } from '../stroke/stroke.ts';
import { strokeOn } from './penStroke.ts';
import type { Pen } from './tool.ts';
import type { Viewport } from './viewport.ts';

/** px: a shorter gesture is a dot */
export const LEAST_LENGTH = 12;
/** px, or this share of the length, whichever is more: near enough to the start to close */
const CLOSING = { pixels: 24, share: 0.04, least: 4 } as const;

export interface Trace {
  /** only ever appended to: copying it at each event would cost the square of its length */
  readonly pens: Pen[];
  /** px along the path, and the furthest it has been from its start */
  readonly length: number;
  readonly reach: number;
  /** as one looked when it was begun */
  readonly view: View;
}

export const traceFrom = (pen: Pen, view: View): Trace => ({ pens: [pen], length: 0, reach: 0, view });

/** What a file cannot hold is not drawn. */
export function traced<T extends Trace>(trace: T, more: readonly Pen[]): T {
  const { pens } = trace;
  let { length, reach } = trace;
  const first = pens[0];
  for (const pen of more) {
    const last = pens.at(-1);
    if (!first || !last || pens.length >= LIMITS.samples) break;
    pens.push(pen);
    length += length2([pen.x - last.x, pen.y - last.y]);
    reach = Math.max(reach, length2([pen.x - first.x, pen.y - first.y]));
  }
  return { ...trace, length, reach };
}

/** Near the start again, after having been clearly away from it. */
export function isClosing({ pens, length, reach }: Trace): boolean {
  // of a small loop half its size at most: a ring of a few pixels is one, too
  const most = Math.max(CLOSING.least, 0.5 * reach);
  const tolerance = Math.min(Math.max(CLOSING.pixels, CLOSING.share * length), most);
  const first = pens[0];
  const last = pens.at(-1);
  if (!first || !last || reach < 1.5 * tolerance || length < 4 * tolerance) return false;
  return length2([last.x - first.x, last.y - first.y]) <= tolerance;
}

/** Null where it is too short, or the plane is not under it. */
export const strokeOf = (
  plane: Plane,
  { pens, view, length }: Trace,
  size: Viewport['size'],
  closed = false,
): Stroke | null => (length < LEAST_LENGTH ? null : strokeOn(plane, pens, view, size, closed));
