/** Few places for many along a line, off by no more than a tolerance in place and radius (Douglas & Peucker 1973). */
import { dot2, length2, mix2, sub2 } from '../../math/tuple.ts';
import type { MedialNode } from '../../skeleton/medial/axis.ts';

/** Indices of those that stay, in order, ends among them; no more than `most`, with a tolerance as large as that takes. */
export function fewOf(nodes: readonly MedialNode[], tolerance: number, most = Infinity): readonly number[] {
  const last = nodes.length - 1;
  if (last < 1 || !(tolerance > 0)) return nodes.map((_, i) => i);
  const kept = [0, ...between(nodes, 0, last, tolerance), last];
  return kept.length <= Math.max(most, 2) ? kept : fewOf(nodes, 1.4 * tolerance, most);
}

/** Of a loop, whose last follows on its first; three at least where there are three. */
export function fewOfLoop(
  nodes: readonly MedialNode[],
  tolerance: number,
  most = Infinity,
): readonly number[] {
  if (nodes.length < 4) return nodes.map((_, i) => i);
  const far = farthest(nodes, nodes[0]!);
  const kept = [
    0,
    ...between(nodes, 0, far, tolerance),
    far,
    ...between([...nodes, nodes[0]!], far, nodes.length, tolerance),
  ];
  // hardly anything: any three will do
  if (kept.length < 3) return [0, Math.floor(nodes.length / 3), Math.floor((2 * nodes.length) / 3)];
  return kept.length <= Math.max(most, 3) ? kept : fewOfLoop(nodes, 1.4 * tolerance, most);
}

function farthest(nodes: readonly MedialNode[], from: MedialNode): number {
  const far = (i: number) => length2(sub2(nodes[i]!.at, from.at));
  return nodes.reduce((best, _, i) => (far(i) > far(best) ? i : best), 1);
}

function between(
  nodes: readonly MedialNode[],
  from: number,
  to: number,
  tolerance: number,
): readonly number[] {
  let worst = tolerance;
  let at = -1;
  for (let i = from + 1; i < to; i++) {
    const off = offOf(nodes[i]!, nodes[from]!, nodes[to]!);
    if (off > worst) [worst, at] = [off, i];
  }
  if (at < 0) return [];
  return [...between(nodes, from, at, tolerance), at, ...between(nodes, at, to, tolerance)];
}

/** mm from the piece between two circles, in place and radius. */
function offOf(node: MedialNode, a: MedialNode, b: MedialNode): number {
  const along = sub2(b.at, a.at);
  const t = Math.min(Math.max(dot2(sub2(node.at, a.at), along) / (dot2(along, along) || 1), 0), 1);
  const aside = length2(sub2(node.at, mix2(a.at, b.at, t)));
  return Math.max(aside, Math.abs(node.radius - (a.radius + t * (b.radius - a.radius))));
}
