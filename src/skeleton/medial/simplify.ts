/**
 * Few circles for many: a chain is replaced by straight pieces with radii in between, off by no more than a share of the radius (Douglas &
 * Peucker 1973, in place and radius at once), and joints that are closer than their circles are wide become one.
 *
 * Tai et al. 2004 drop a circle that lies nearly straight between its neighbours, one after the other, so that a gentle bend may vanish
 * entirely; here each dropped circle is measured against what stays.
 */
import { dot2, length2, mix2, sub2 } from '../../math/tuple.ts';
import type { MedialGraph, MedialNode } from './axis.ts';
import { type Chain, chainsOf } from './branches.ts';

export interface SimplifyOptions {
  /** share of the radius by which a circle that goes may be off, in place or radius */
  readonly deviation: number;
  /** of a piece, in its larger radius; longer ones are halved */
  readonly longest: number;
  /** joints nearer than this share of the larger radius become one */
  readonly joints: number;
}

export const SIMPLIFYING: SimplifyOptions = { deviation: 0.08, longest: 2.5, joints: 0.35 };

/** of the largest radius of a chain: below it radii count as this, or tips would get a circle a hair */
const LEAST = 0.4;

/** of a skeleton, as long as fewer joints and ends do: what is as thin as a hair is not followed at every width */
const MOST_NODES = 80;
/** shares of the largest radius as which thinner circles count, one after the other, until pieces are few enough: a hair takes none from a body */
const FLOORS = [0, 0.01, 0.03, 0.1];
/** by how much pieces grow then */
const COARSER = 1.6;

export function simplify(graph: MedialGraph, options: SimplifyOptions = SIMPLIFYING): MedialGraph {
  const joined = joinJoints(graph, options.joints);
  const whole = chainsOf(joined);
  let { deviation, longest } = options;
  let chains = whole;
  const largest = joined.nodes.reduce((most, { radius }) => Math.max(most, radius), 0);
  for (let tries = 0; tries < 12 + FLOORS.length; tries++) {
    const floor = (FLOORS[tries] ?? FLOORS.at(-1)!) * largest;
    chains = whole.map((chain) => thinned(joined.nodes, chain, { deviation, longest, floor }));
    if (new Set(chains.flat()).size <= MOST_NODES) break;
    if (tries >= FLOORS.length - 1) [deviation, longest] = [COARSER * deviation, COARSER * longest];
  }
  const used = [...new Set(chains.flat())];
  const index = new Map(used.map((old, i) => [old, i]));
  const links = chains.flatMap((chain) =>
    chain.slice(1).map((b, i) => [index.get(chain[i]!)!, index.get(b)!] as const),
  );
  return { nodes: used.map((old) => joined.nodes[old]!), links };
}

interface Coarse extends Pick<SimplifyOptions, 'deviation' | 'longest'> {
  /** mm: circles count as no smaller */
  readonly floor: number;
}

/** The chain with fewer nodes; a ring keeps four at least. */
function thinned(nodes: readonly MedialNode[], chain: Chain, options: Coarse): Chain {
  const last = chain.length - 1;
  if (last > 3 && chain[0] === chain[last]) {
    const cuts = [0, 1, 2, 3, 4].map((quarter) => Math.round((quarter * last) / 4));
    return cuts
      .slice(1)
      .flatMap((end, i) => between(nodes, chain, cuts[i]!, end, options).slice(i === 0 ? 0 : 1));
  }
  return between(nodes, chain, 0, last, options);
}

function between(
  nodes: readonly MedialNode[],
  chain: Chain,
  from: number,
  to: number,
  options: Coarse,
): Chain {
  const [a, b] = [nodes[chain[from]!]!, nodes[chain[to]!]!];
  const least = Math.max(LEAST * Math.max(...chain.map((node) => nodes[node]!.radius)), options.floor);
  let worst = options.deviation;
  let at = -1;
  for (let i = from + 1; i < to; i++) {
    const node = nodes[chain[i]!]!;
    const off = deviation(node, a, b) / Math.max(node.radius, least);
    if (off > worst) [worst, at] = [off, i];
  }
  if (at < 0) at = tooLong(nodes, chain, from, to, options);
  if (at < 0) return from === to ? [chain[from]!] : [chain[from]!, chain[to]!];
  return [...between(nodes, chain, from, at, options), ...between(nodes, chain, at, to, options).slice(1)];
}

/** A place in the middle of a piece that is longer than its circles are wide, so that weights can follow the outline there; −1: it is not. */
function tooLong(
  nodes: readonly MedialNode[],
  chain: Chain,
  from: number,
  to: number,
  { longest, floor }: Coarse,
): number {
  const [a, b] = [nodes[chain[from]!]!, nodes[chain[to]!]!];
  const length = length2(sub2(b.at, a.at));
  if (to - from < 2 || length <= longest * Math.max(a.radius, b.radius, floor)) return -1;
  const off = (i: number) => Math.abs(length2(sub2(nodes[chain[i]!]!.at, a.at)) - 0.5 * length);
  let at = from + 1;
  for (let i = from + 2; i < to; i++) if (off(i) < off(at)) at = i;
  return at;
}

/** mm from the piece between two circles, in place and radius. */
function deviation(node: MedialNode, a: MedialNode, b: MedialNode): number {
  const along = sub2(b.at, a.at);
  const t = Math.min(Math.max(dot2(sub2(node.at, a.at), along) / (dot2(along, along) || 1), 0), 1);
  const aside = length2(sub2(node.at, mix2(a.at, b.at, t)));
  return Math.max(aside, Math.abs(node.radius - (a.radius + t * (b.radius - a.radius))));
}

/** Short chains between two joints become the larger of them, as long as there are any; rings stay. */
function joinJoints(graph: MedialGraph, share: number): MedialGraph {
  const chains = chainsOf(graph);
  const ends = new Map<number, number>();
  const between = new Map<number, number>();
  const key = (chain: Chain) => {
    const [a, b] = [chain[0]!, chain.at(-1)!];
    return Math.min(a, b) * graph.nodes.length + Math.max(a, b);
  };
  for (const chain of chains) {
    for (const end of [chain[0]!, chain.at(-1)!]) ends.set(end, (ends.get(end) ?? 0) + 1);
    between.set(key(chain), (between.get(key(chain)) ?? 0) + 1);
  }
  const touched = new Set<number>();
  const short = chains.filter((chain) => {
    const [first, last] = [chain[0]!, chain.at(-1)!];
    if (first === last || !(ends.get(first)! > 2 && ends.get(last)! > 2)) return false;
    const [a, b] = [graph.nodes[first]!, graph.nodes[last]!];
    if (between.get(key(chain))! > 1 || touched.has(first) || touched.has(last)) return false;
    if (!(length2(sub2(a.at, b.at)) < share * Math.max(a.radius, b.radius))) return false;
    touched.add(first).add(last);
    return true;
  });
  return short.length > 0 ? joinJoints(merged(graph, short), share) : graph;
}

function merged({ nodes, links }: MedialGraph, chains: readonly Chain[]): MedialGraph {
  const into = new Map<number, number>();
  for (const chain of chains) {
    const [a, b] = [chain[0]!, chain.at(-1)!];
    const stays = nodes[a]!.radius >= nodes[b]!.radius ? a : b;
    for (const node of chain) if (node !== stays) into.set(node, stays);
  }
  const index = new Map(nodes.flatMap((_, i) => (into.has(i) ? [] : [i])).map((old, i) => [old, i]));
  const to = (node: number) => index.get(into.get(node) ?? node)!;
  const kept = links.map(([i, j]) => [to(i), to(j)] as const).filter(([i, j]) => i !== j);
  return { nodes: nodes.filter((_, i) => !into.has(i)), links: unique(kept) };
}

function unique(links: readonly (readonly [number, number])[]): (readonly [number, number])[] {
  return [...new Map(links.map((link) => [`${Math.min(...link)} ${Math.max(...link)}`, link])).values()];
}
