/**
 * A medial axis in its connected pieces, each with the loops around it: circles of one piece say nothing of another's outline.
 *
 * Against all circles at once a hair beside a body lost its skeleton: by the share of a radius the body's circles were the nearest to it.
 */
import type { MedialAxis, MedialGraph } from './axis.ts';
import { neighboursOf, subgraph } from './branches.ts';
import type { Loop } from './outline.ts';

export interface Piece {
  readonly graph: MedialGraph;
  readonly loops: readonly Loop[];
}

/** `loops` are those that the axis is of; one that no triangle touches is left out. */
export function piecesOf(axis: MedialAxis, loops: readonly Loop[]): readonly Piece[] {
  const piece = connected(axis);
  const count = Math.max(-1, ...piece) + 1;
  if (count < 2) return [{ graph: axis, loops }];
  const around = pieceOfLoop(axis, loops, piece);
  return Array.from({ length: count }, (_, own) => ({
    graph: subgraph(axis, (node) => piece[node] === own),
    loops: loops.filter((_, i) => around[i] === own),
  }));
}

export function joined(graphs: readonly MedialGraph[]): MedialGraph {
  let first = 0;
  const links = graphs.flatMap((graph) => {
    const from = first;
    first += graph.nodes.length;
    return graph.links.map(([a, b]) => [a + from, b + from] as const);
  });
  return { nodes: graphs.flatMap(({ nodes }) => nodes), links };
}

/** Of each node: its piece, counted from 0. */
function connected(graph: MedialGraph): readonly number[] {
  const near = neighboursOf(graph);
  const piece = near.map(() => -1);
  let count = 0;
  for (const start of near.keys()) {
    if (piece[start] !== -1) continue;
    const open = [start];
    piece[start] = count;
    for (let at = open.pop(); at !== undefined; at = open.pop()) {
      for (const other of near[at]!) {
        if (piece[other] !== -1) continue;
        piece[other] = count;
        open.push(other);
      }
    }
    count++;
  }
  return piece;
}

/** Of each loop: the piece whose triangles most of its places are corners of; pieces may touch at a place. */
function pieceOfLoop(
  { triangulation: { points, triangles } }: MedialAxis,
  loops: readonly Loop[],
  piece: readonly number[],
): readonly number[] {
  const at = new Map(Array.from(triangles, (corner, k) => [points[corner]!, piece[Math.floor(k / 3)]!]));
  return loops.map((loop) => {
    const votes = new Map<number, number>();
    for (const place of loop) {
      const own = at.get(place);
      if (own !== undefined) votes.set(own, (votes.get(own) ?? 0) + 1);
    }
    return [...votes].reduce((most, vote) => (vote[1] > most[1] ? vote : most), [-1, 0])[0];
  });
}
