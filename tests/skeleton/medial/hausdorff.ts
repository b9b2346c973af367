/** How far two skeletons are apart. */
import type { MedialGraph } from '../../../src/skeleton/medial/axis.ts';

type Place = readonly [number, number];

function placesOf({ nodes, links }: MedialGraph): readonly Place[] {
  const along = links.flatMap(([a, b]) => {
    const [p, q] = [nodes[a]!.at, nodes[b]!.at];
    const count = Math.max(1, Math.ceil(Math.hypot(q[0] - p[0], q[1] - p[1]) / 0.5));
    return Array.from({ length: count + 1 }, (_, i): Place => {
      const t = i / count;
      return [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])];
    });
  });
  return along.length > 0 ? along : nodes.map(({ at }) => at);
}

/** mm */
export function hausdorff(a: MedialGraph, b: MedialGraph): number {
  const [p, q] = [placesOf(a), placesOf(b)];
  const oneWay = (from: readonly Place[], to: readonly Place[]) =>
    Math.max(...from.map(([x, y]) => Math.min(...to.map(([u, v]) => Math.hypot(x - u, y - v)))));
  return Math.max(oneWay(p, q), oneWay(q, p));
}
