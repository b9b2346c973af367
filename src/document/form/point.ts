/** A lone point: a ball of the brush's radius. */
import type { MedialGraph } from '../../skeleton/medial/axis.ts';
import { widthFor } from '../../skeleton/weight.ts';
import { type FormKind, type Ink, PLAIN } from './form.ts';

export const point: FormKind = {
  width: (ink, kernel) =>
    widthFor(kernel, PLAIN, Math.min(...skeletonOf(ink).nodes.map(({ radius }) => radius))),
  make(ink) {
    const skeleton = skeletonOf(ink);
    const skels = skeleton.nodes.map(({ at, radius }) => ({
      type: 'point' as const,
      at: [at[0], at[1], 0] as const,
      radius,
    }));
    return { skeleton, skels };
  },
};

function skeletonOf({ curves, brush, skeleton }: Ink): MedialGraph {
  return (
    skeleton ?? { nodes: curves.map((curve) => ({ at: curve.point(0.5), radius: brush.radius })), links: [] }
  );
}
