/** Rows of circles as one graph, and a graph as the rows that its chains are. */
import type { MedialGraph, MedialNode } from '../../skeleton/medial/axis.ts';
import { chainsOf } from '../../skeleton/medial/branches.ts';

export interface Row {
  readonly nodes: readonly MedialNode[];
  /** the last is followed by the first, which is not repeated */
  readonly closed: boolean;
}

export function graphOf(rows: readonly Row[]): MedialGraph {
  let first = 0;
  const links = rows.flatMap(({ nodes, closed }) => {
    const start = first;
    first += nodes.length;
    const last = closed && nodes.length > 2 ? nodes.length : nodes.length - 1;
    return Array.from(
      { length: Math.max(last, 0) },
      (_, i) => [start + i, start + ((i + 1) % nodes.length)] as const,
    );
  });
  return { nodes: rows.flatMap(({ nodes }) => nodes), links };
}

/** Lone nodes are rows of one. */
export function rowsOf(graph: MedialGraph): readonly Row[] {
  return chainsOf(graph).map((chain) => {
    const closed = chain.length > 3 && chain[0] === chain.at(-1);
    const row = closed ? chain.slice(0, -1) : chain;
    return { nodes: row.map((i) => graph.nodes[i]!), closed };
  });
}
