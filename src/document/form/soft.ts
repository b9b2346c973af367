/** A soft body: a surface that goes through the outline (docs/silhouettes.md). What crosses itself is the outline of what it goes round. */
import { untangle } from '../../math/untangle.ts';
import type { Vec2 } from '../../math/vec.ts';
import { skeletonSkels } from '../../skeleton/medial/edited.ts';
import type { Loop } from '../../skeleton/medial/outline.ts';
import { silhouetteOf } from '../../skeleton/medial/silhouette.ts';
import { widthOf } from '../../skeleton/medial/width.ts';
import type { Curve } from '../../stroke/curve.ts';
import { type FormKind, type Ink, PLAIN } from './form.ts';

/** places along a loop, beside its corners */
const PLACES = 240;
const ROUGH = 80;

export const soft: FormKind = {
  // found together with the skels
  width: () => PLAIN,
  make(ink, { kernel, threshold }) {
    const { skeleton } = ink;
    const found = skeleton
      ? skeletonSkels(skeleton, kernel, widthOf([skeleton], kernel, PLAIN), threshold)
      : silhouetteOf(loopsOf(ink), kernel, PLAIN, threshold, { quick: ink.isRough });
    if (!found) return null;
    const { graph, skels, params, most, atBound, ratio } = found;
    return { skeleton: skeleton ?? graph, skels, params, figures: { most, atBound, ratio } };
  },
};

/** As they are drawn, crossings and all. */
export const loopsDrawn = (curves: readonly Curve[], places = PLACES): readonly Loop[] =>
  curves.map((curve) => loopOf(curve, places));

/** Simple ones. */
export function loopsOf({ curves, isRough }: Ink): readonly Loop[] {
  const [outer, ...holes] = loopsDrawn(curves, isRough ? ROUGH : PLACES);
  return outer ? untangle(outer, holes) : [];
}

/** Its corners are among the places. */
export function loopOf(curve: Curve, places: number): Loop {
  const even = Array.from({ length: places }, (_, i) => i / places);
  const near = 0.3 / places;
  const between = even.filter((u) => curve.corners.every((corner) => Math.abs(u - corner) > near));
  return [...between, ...curve.corners].sort((a, b) => a - b).map((u): Vec2 => curve.point(u));
}
