/** Strokes that cannot be of one form, and where they are: asked of files, and of what commands make. */
import type { Stroke } from '../stroke/stroke.ts';
import type { Fault } from './samples.ts';
import { SAME_PLACE, type Section, type SectionStroke } from './surfacePart.ts';
import { belongTogether, samePlane } from './together.ts';

/** Strokes of one form lie on the plane of the first, and are open or closed like it. */
export function strayIn(strokes: readonly Stroke[]): Fault | null {
  const i = strokes.findIndex((stroke) => !belongTogether(strokes[0]!, stroke));
  const expected = 'a stroke on the very plane of strokes[0], open or closed like it';
  return i < 0 ? null : { expected, path: ['strokes', i] };
}

/** Sections are in order, and those drawn across lie on the plane of the construction curves. */
export function straySection([first]: readonly Stroke[], sections: readonly Section[]): Fault | null {
  for (const [i, { u, front, back }] of sections.entries()) {
    const path = ['sections', i];
    const before = sections[i - 1];
    if (before && (u < before.u || Math.abs(u - before.u) < SAME_PLACE))
      return { expected: `${SAME_PLACE} more than the u of the section before`, path: [...path, 'u'] };
    const isStray = (drawn: SectionStroke | null) =>
      drawn?.half === null && !(first && samePlane(first.plane, drawn.stroke.plane));
    if (isStray(front)) return { expected: ON_PLANE, path: [...path, 'front'] };
    if (isStray(back)) return { expected: ON_PLANE, path: [...path, 'back'] };
  }
  return null;
}

const ON_PLANE = 'a stroke on the very plane of strokes[0]';
