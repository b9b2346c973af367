/** A polyline with a radius at each of its points (Zhu et al. 2011, §3.2). */
import { distance2 } from '../../math/tuple.ts';
import type { MedialGraph } from '../../skeleton/medial/axis.ts';
import { widthFor } from '../../skeleton/weight.ts';
import { type FormKind, type Ink, PLAIN, radiusAt } from './form.ts';

/** mm between points along a stroke, in radii; no more than this many */
const STEP = 1;
const MOST = 60;

export const line: FormKind = {
  width: (ink, kernel) =>
    widthFor(kernel, PLAIN, Math.min(...chainOf(ink).nodes.map(({ radius }) => radius))),
  make(ink) {
    const skeleton = chainOf(ink);
    return { skeleton, skels: chainSkels(skeleton) };
  },
};

function chainOf(ink: Ink): MedialGraph {
  const { curves, brush, skeleton } = ink;
  if (skeleton) return skeleton;
  const curve = curves[0]!;
  const pieces = Math.min(MOST, Math.max(2, Math.ceil(curve.length / (STEP * brush.radius))));
  const nodes = Array.from({ length: pieces + 1 }, (_, i) => ({
    at: curve.point(i / pieces),
    radius: radiusAt(ink, i / pieces),
  }));
  return { nodes, links: nodes.slice(1).map((_, i) => [i, i + 1] as const) };
}

/** A segment a link; nodes that nothing is linked to are points. */
export function chainSkels({ nodes, links }: MedialGraph) {
  const linked = new Set(links.flat());
  const segments = links
    .map(([a, b]) => [nodes[a]!, nodes[b]!] as const)
    .filter(([a, b]) => distance2(a.at, b.at) > 0)
    .map(([a, b]) => ({
      type: 'segment' as const,
      a: [a.at[0], a.at[1], 0] as const,
      b: [b.at[0], b.at[1], 0] as const,
      radii: [a.radius, b.radius] as const,
    }));
  const points = nodes
    .filter((_, i) => !linked.has(i))
    .map(({ at, radius }) => ({ type: 'point' as const, at: [at[0], at[1], 0] as const, radius }));
  return [...segments, ...points];
}
