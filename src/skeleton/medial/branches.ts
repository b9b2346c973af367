/** A graph of medial circles as chains between its joints and ends. */
import type { MedialGraph, MedialNode } from './axis.ts';

/** Nodes in a row, joints or ends first and last; a ring without a joint has the same node at both. */
export type Chain = readonly number[];

export function neighboursOf({ nodes, links }: MedialGraph): readonly (readonly number[])[] {
  const near: number[][] = nodes.map(() => []);
  for (const [a, b] of links) {
    near[a]!.push(b);
    near[b]!.push(a);
  }
  return near;
}

/** All chains; lone nodes are chains of one. */
export function chainsOf(graph: MedialGraph): Chain[] {
  const near = neighboursOf(graph);
  const used = new Set<number>();
  const key = (a: number, b: number) => (a < b ? a * near.length + b : b * near.length + a);
  const chains: Chain[] = [];
  const follow = (start: number) => {
    for (const next of near[start]!) {
      if (used.has(key(start, next))) continue;
      chains.push(walk(near, used, key, start, next));
    }
  };
  near.forEach((others, at) => {
    if (others.length !== 2) follow(at);
    if (others.length === 0) chains.push([at]);
  });
  for (const at of near.keys()) follow(at);
  return chains;
}

function walk(
  near: readonly (readonly number[])[],
  used: Set<number>,
  key: (a: number, b: number) => number,
  start: number,
  next: number,
): Chain {
  const chain = [start, next];
  used.add(key(start, next));
  for (let at = next; at !== start && near[at]!.length === 2; ) {
    const onwards = near[at]!.find((other) => !used.has(key(at, other)));
    if (onwards === undefined) break;
    used.add(key(at, onwards));
    chain.push(onwards);
    at = onwards;
  }
  return chain;
}

/** Only these nodes, and the links between them. */
export function subgraph({ nodes, links }: MedialGraph, isKept: (node: number) => boolean): MedialGraph {
  const index = new Map(nodes.flatMap((_, i) => (isKept(i) ? [i] : [])).map((old, i) => [old, i]));
  const pairs = links.flatMap(([a, b]) => {
    const [i, j] = [index.get(a), index.get(b)];
    return i === undefined || j === undefined ? [] : [[i, j] as const];
  });
  return { nodes: [...index.keys()].map((old) => nodes[old]!), links: pairs };
}

/** of the largest radius: no circle counts as less */
const LEAST = 1e-3;

/** Nodes that are numbers, none much smaller than the others, and links between two of them, each once. */
export function sound({ nodes, links }: MedialGraph): MedialGraph {
  const isSound = ({ at, radius }: MedialNode) =>
    Number.isFinite(at[0]) && Number.isFinite(at[1]) && radius > 0 && radius < Infinity;
  const kept = [...nodes.keys()].filter((i) => isSound(nodes[i]!));
  const index = new Map(kept.map((old, i) => [old, i]));
  const largest = kept.reduce((most, i) => Math.max(most, nodes[i]!.radius), 0);
  const pairs = new Map<number, readonly [number, number]>();
  for (const [a, b] of links) {
    const [i, j] = [index.get(a), index.get(b)];
    if (i === undefined || j === undefined || i === j) continue;
    pairs.set(Math.min(i, j) * kept.length + Math.max(i, j), [i, j]);
  }
  return {
    nodes: kept.map((i) => ({ at: nodes[i]!.at, radius: Math.max(nodes[i]!.radius, LEAST * largest) })),
    links: [...pairs.values()],
  };
}
