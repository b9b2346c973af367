/** What hands do to skeletons: graphs of circles that become other graphs. Nothing is changed in place; what is not touched is shared. */
import { distance2, dot2, mix2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { MedialGraph, MedialNode } from '../skeleton/medial/axis.ts';
import { neighboursOf } from '../skeleton/medial/branches.ts';
import { RANGES } from './limits.ts';

const withNode = (graph: MedialGraph, node: number, change: Partial<MedialNode>): MedialGraph => ({
  ...graph,
  nodes: graph.nodes.map((old, i) => (i === node ? { ...old, ...change } : old)),
});

export const moved = (graph: MedialGraph, node: number, at: Vec2): MedialGraph =>
  withNode(graph, node, { at });

/** Within what files may hold; `all`: of every node, as plates have one thickness. */
export function swollen(graph: MedialGraph, node: number, radius: number, all = false): MedialGraph {
  const within = Math.min(Math.max(radius, RANGES.radius.min), RANGES.skeletonRadius.max);
  if (!all) return withNode(graph, node, { radius: within });
  return { ...graph, nodes: graph.nodes.map((old) => ({ ...old, radius: within })) };
}

/** A node at `at` in place of a link, as large as the link is where it comes nearest; it is the last one. */
export function split(graph: MedialGraph, link: number, at: Vec2): MedialGraph {
  const [a, b] = graph.links[link]!;
  const [p, q] = [graph.nodes[a]!, graph.nodes[b]!];
  const t = along(at, p.at, q.at);
  const last = graph.nodes.length;
  const links = graph.links.flatMap((old, i) =>
    i === link
      ? ([
          [a, last],
          [last, b],
        ] as const)
      : [old],
  );
  return { nodes: [...graph.nodes, { at, radius: p.radius + t * (q.radius - p.radius) }], links };
}

/** A node linked to another one; it is the last one. In a loop it goes between that and the next, or the loop would be none. */
export function branched(graph: MedialGraph, node: number, at: Vec2, inLoop = false): MedialGraph {
  if (inLoop) {
    const own = graph.links.flatMap((link, i) => (link.includes(node) ? [i] : []));
    const near = (i: number) => {
      const [a, b] = graph.links[i]!;
      return distance2(at, mix2(graph.nodes[a]!.at, graph.nodes[b]!.at, 0.5));
    };
    const link = own.sort((i, j) => near(i) - near(j))[0];
    if (link !== undefined) return split(graph, link, at);
  }
  const { radius } = graph.nodes[node]!;
  return { nodes: [...graph.nodes, { at, radius }], links: [...graph.links, [node, graph.nodes.length]] };
}

/** Its neighbours are linked where it had two; the last node stays. */
export function without(graph: MedialGraph, node: number): MedialGraph {
  if (graph.nodes.length < 2) return graph;
  const [a, b, ...more] = neighboursOf(graph)[node]!;
  const joins = a !== undefined && b !== undefined && a !== b && more.length === 0;
  const isLinked = graph.links.some((link) => link.includes(a!) && link.includes(b!));
  const kept = graph.links.filter((link) => !link.includes(node));
  const links = joins && !isLinked ? [...kept, [a, b] as const] : kept;
  const index = (i: number) => (i > node ? i - 1 : i);
  return {
    nodes: graph.nodes.filter((_, i) => i !== node),
    links: links.map(([i, j]) => [index(i), index(j)] as const),
  };
}

/** 0–1 along a piece, where it comes nearest to a place. */
export function along(p: Vec2, a: Vec2, b: Vec2): number {
  const e = sub2(b, a);
  return Math.min(Math.max(dot2(sub2(p, a), e) / (dot2(e, e) || 1), 0), 1);
}
