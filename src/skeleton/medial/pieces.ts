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

/**
 * `loops` are those that the axis is of; one that no triangle touches is left out. Pieces of one loop, which is pinched between them, count
 * as one.
 */
export function piecesOf(axis: MedialAxis, loops: readonly Loop[]): readonly Piece[] {
  const piece = connected(axis);
  const votes = votesOf(axis, loops, piece);
  const around = votes.map((of) => mostOf(of));
  const merged = piece.map((own) => (around.includes(own) ? own : hostOf(own, votes, around)));
  const owns = [...new Set(merged)];
  if (owns.length < 2) return [{ graph: axis, loops }];
  return owns.map((own) => ({
    graph: subgraph(axis, (node) => merged[node] === own),
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

/** Of each loop: how many of its places are corners of each piece's triangles; pieces may touch at a place. */
function votesOf(
  { triangulation: { points, triangles } }: MedialAxis,
  loops: readonly Loop[],
  piece: readonly number[],
): readonly ReadonlyMap<number, number>[] {
  const at = new Map(Array.from(triangles, (corner, k) => [points[corner]!, piece[Math.floor(k / 3)]!]));
  return loops.map((loop) => {
    const votes = new Map<number, number>();
    for (const place of loop) {
      const own = at.get(place);
      if (own !== undefined) votes.set(own, (votes.get(own) ?? 0) + 1);
    }
    return votes;
  });
}

/** −1: nobody voted. */
const mostOf = (votes: ReadonlyMap<number, number>): number =>
  [...votes].reduce((most, vote) => (vote[1] > most[1] ? vote : most), [-1, 0])[0];

/** The piece that has the loop which a piece without loops has most of. */
function hostOf(
  own: number,
  votes: readonly ReadonlyMap<number, number>[],
  around: readonly number[],
): number {
  const shares = votes.map((of) => of.get(own) ?? 0);
  return around[shares.indexOf(Math.max(...shares))] ?? own;
}
