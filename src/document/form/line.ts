/** A polyline with a radius at each of its points (Zhu et al. 2011, §3.2): few, and more where it bends or its radius changes. */
import type { MedialGraph } from '../../skeleton/medial/axis.ts';
import type { Curve } from '../../stroke/curve.ts';
import { graphOf } from './chains.ts';
import { fewOf, fewOfLoop } from './few.ts';
import { type FormKind, type Ink, radiiOf, radiusAt, widthForRadii } from './form.ts';
import { chainSkels } from './tubes.ts';

/** of the radius: what is off by less is not seen */
const OFF = 0.08;
/** places looked at, and those of a stroke that stay */
const LOOKED_AT = 240;
const MOST = 60;

export const line: FormKind = {
  width: (ink, kernel) => widthForRadii(kernel, radiiOf(skeletonOf(ink))),
  make(ink, sum) {
    const skeleton = skeletonOf(ink);
    const skels = chainSkels(skeleton, sum);
    return skels.length > 0 ? { skeleton, skels } : null;
  },
};

const skeletonOf = (ink: Ink): MedialGraph =>
  ink.skeleton ?? graphOf(ink.curves.map((curve) => ({ nodes: nodesOf(ink, curve), closed: curve.closed })));

function nodesOf(ink: Ink, curve: Curve) {
  const count = curve.closed ? LOOKED_AT : LOOKED_AT + 1;
  const even = Array.from({ length: count }, (_, i) => i / LOOKED_AT);
  const places = [...even, ...curve.corners.filter((u) => !even.includes(u))].sort((a, b) => a - b);
  const nodes = places.map((u) => ({ at: curve.point(u), radius: radiusAt(ink, curve, u) }));
  const least = nodes.reduce((low, { radius }) => Math.min(low, radius), Infinity);
  const kept = curve.closed ? fewOfLoop(nodes, OFF * least, MOST) : fewOf(nodes, OFF * least, MOST);
  return kept.map((i) => nodes[i]!);
}
