/** What commands make stays within what files hold: nothing is moved, mirrored or scaled so far that it could not be read again. */
import { FARTHEST, isInReach, type Stroke } from '../stroke/stroke.ts';
import { RANGES } from './limits.ts';
import type { Group } from './solid.ts';
import { type SurfaceForm, strokesOfForm } from './surfacePart.ts';

export const areInReach = (strokes: readonly Stroke[]): boolean =>
  strokes.every(
    ({ samples, plane, view }) =>
      isInReach(plane.origin) &&
      view.height >= RANGES.height.min &&
      view.height <= RANGES.height.max &&
      samples.every(({ x, y }) => isInReach([x, y])),
  );

/** All strokes of a surface, and the chords that sections were drawn over. */
export const isFormInReach = (form: Pick<SurfaceForm, 'strokes' | 'sections' | 'bends'>): boolean =>
  areInReach(strokesOfForm(form)) &&
  form.sections.every(({ front, back, redraws }) =>
    [front, back, ...redraws].every((drawn) => {
      const half = drawn?.half ?? null;
      return half === null || (half >= RANGES.half.min && half <= RANGES.half.max);
    }),
  );

export function isGroupInReach({ strokes, skeleton }: Pick<Group, 'strokes' | 'skeleton'>): boolean {
  const isWithin = (radius: number) => radius >= RANGES.skeletonRadius.min && radius <= FARTHEST;
  const circles = skeleton?.nodes ?? [];
  return areInReach(strokes) && circles.every(({ at, radius }) => isInReach(at) && isWithin(radius));
}
