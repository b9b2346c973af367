/** A lone point: a ball of the brush's radius. */
import type { MedialGraph } from '../../skeleton/medial/axis.ts';
import { type FormKind, type Ink, radiiOf, widthForRadii } from './form.ts';

export const point: FormKind = {
  width: (ink, kernel) => widthForRadii(kernel, radiiOf(skeletonOf(ink))),
  make(ink) {
    const skeleton = skeletonOf(ink);
    if (skeleton.nodes.length === 0) return null;
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
