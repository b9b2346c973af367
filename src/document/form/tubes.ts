/**
 * Skels of tubes along rows of circles. The field of a line is only half as large at its end, so that the tube would end as a needle: a point
 * there brings the other half.
 */
import type { AnySkel } from '../../field/expand.ts';
import { distance2 } from '../../math/tuple.ts';
import type { Vec3 } from '../../math/vec.ts';
import type { MedialGraph, MedialNode } from '../../skeleton/medial/axis.ts';
import { pointWeight } from '../../skeleton/weight.ts';
import { type Row, rowsOf } from './chains.ts';
import type { Sum } from './form.ts';

/** of what a lone point needs */
const HALF = 0.5;

/** `tubeOf` makes the skel of a row. */
export function chainSkels(
  graph: MedialGraph,
  sum: Sum,
  tubeOf: (row: Row) => AnySkel | null = straight,
): readonly AnySkel[] {
  const ends = new Map<MedialNode, number>();
  for (const end of graph.links.flat()) ends.set(graph.nodes[end]!, 1 + (ends.get(graph.nodes[end]!) ?? 0));
  return rowsOf(graph).flatMap((row) => {
    const tube = tubeOf(row);
    if (!tube) return row.nodes.slice(0, 1).map(lonePoint);
    // of kernels whose lines are infinite the length tells
    const hasTips = !row.closed && sum.kernel.wholeLine !== null;
    const tips = [row.nodes[0]!, row.nodes.at(-1)!].filter((node) => hasTips && ends.get(node) === 1);
    return [tube, ...tips.map((node) => tip(node, sum))];
  });
}

const place = ({ at }: MedialNode): Vec3 => [at[0], at[1], 0];

const lonePoint = (node: MedialNode): AnySkel => ({ type: 'point', at: place(node), radius: node.radius });

function tip(node: MedialNode, { kernel, params, threshold }: Sum): AnySkel {
  const weight = HALF * pointWeight(kernel, params, node.radius, threshold);
  return { type: 'point', at: place(node), weight };
}

/** null where all of it is one place. */
export function straight({ nodes, closed }: Row): AnySkel | null {
  const apart = nodes.filter((node, i) => i === 0 || distance2(node.at, nodes[i - 1]!.at) > 0);
  if (apart.length < 2) return null;
  return {
    type: 'polyline',
    points: apart.map(place),
    radii: apart.map(({ radius }) => radius),
    closed: closed && apart.length > 2,
  };
}
