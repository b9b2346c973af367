/**
 * The pruning of Tai et al. 2004, §5.1: along the triangles from a junction to an end or the next junction, circles go that lie mostly in the
 * one before (overlapping), or behind it (ordering), and those in a straight row with even radii (proportionality). For comparison, and as a choice.
 *
 * "The common edge" of two triangles that are no longer neighbours is read as the one by which the later is entered.
 */
import { dot2, length2, sub2 } from '../../math/tuple.ts';
import type { Vec2 } from '../../math/vec.ts';
import type { MedialAxis, MedialGraph, MedialNode } from './axis.ts';
import { chainsOf } from './branches.ts';

/** τ: how much of the later circle must be in the one before */
const OVERLAP = 0.6;
/** π/18, as a cosine */
const STRAIGHT = 0.984807753012208;
const PROPORTION = 0.1;

export function prunePaper(axis: MedialAxis): MedialGraph {
  const chains = chainsOf(axis).map((chain) => {
    const [first, last] = [axis.degrees[chain[0]!]!, axis.degrees[chain.at(-1)!]!];
    return prunedChain(axis, first < 3 && last === 3 ? [...chain].reverse() : chain);
  });
  const used = [...new Set(chains.flat())];
  const index = new Map(used.map((old, i) => [old, i]));
  const links = chains.flatMap((chain) =>
    chain.slice(1).map((b, i) => [index.get(chain[i]!)!, index.get(b)!] as const),
  );
  return { nodes: used.map((old) => axis.nodes[old]!), links };
}

function prunedChain(axis: MedialAxis, chain: readonly number[]): number[] {
  const { nodes, degrees } = axis;
  const kept = [chain[0]!];
  for (let i = 1; i < chain.length; i++) {
    const [r, q, p] = [chain[i]!, kept.at(-1)!, kept.at(-2)];
    const isSleeve = degrees[r] === 2 && i < chain.length - 1;
    if (isSleeve && (overlaps(nodes[q]!, nodes[r]!) || isBehind(axis, q, r, chain[i - 1]!))) continue;
    if (p !== undefined && isProportional(nodes[p]!, nodes[q]!, nodes[r]!)) kept.pop();
    kept.push(r);
  }
  return kept;
}

const overlaps = (q: MedialNode, r: MedialNode): boolean =>
  length2(sub2(q.at, r.at)) + OVERLAP * r.radius <= q.radius;

function isBehind({ nodes, triangulation }: MedialAxis, q: number, r: number, before: number): boolean {
  const { points, triangles, across } = triangulation;
  const edge = [3 * r, 3 * r + 1, 3 * r + 2].find((k) => across[k] === before);
  if (edge === undefined) return false;
  const [a, b] = [points[triangles[edge]!]!, points[triangles[edge % 3 === 2 ? edge - 2 : edge + 1]!]!];
  const along = sub2(b, a);
  // the triangle lies to the left of its edges
  const inwards: Vec2 = [-along[1], along[0]];
  return dot2(sub2(nodes[r]!.at, nodes[q]!.at), inwards) <= 0;
}

function isProportional(p: MedialNode, q: MedialNode, r: MedialNode): boolean {
  const [pq, qr, pr] = [sub2(q.at, p.at), sub2(r.at, q.at), sub2(r.at, p.at)];
  if (!(dot2(pq, qr) >= STRAIGHT * length2(pq) * length2(qr))) return false;
  const grown = r.radius - p.radius;
  // radii that are alike are in any proportion; as the quotient it would be noise
  const share = length2(pq) / length2(pr);
  const off = q.radius - p.radius - share * grown;
  return Math.abs(off) < PROPORTION * Math.max(Math.abs(grown), PROPORTION * q.radius);
}
