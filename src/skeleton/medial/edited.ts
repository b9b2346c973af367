/**
 * Skels of a skeleton whose circles a person moved: no outline says where the surface should be, so the envelope of the circles does, and that
 * of the cones between those that are linked. The circles stay where they were put; only weights are found.
 */
import type { Kernel, KernelParams } from '../../kernel/kernel.ts';
import { cos, sin, TAU } from '../../math/trig.ts';
import { length2, mix2, sub2 } from '../../math/tuple.ts';
import type { Vec2 } from '../../math/vec.ts';
import type { MedialGraph, MedialNode } from './axis.ts';
import { sound } from './branches.ts';
import { FITTING, fitWeights } from './fit.ts';
import type { Silhouette } from './silhouette.ts';

const EDITED = { ...FITTING, move: 0, moves: 0, rounds: 3 };

/** As `params` have it; `graph` is the one given. null where no circle is larger than nothing, or none is at a place that is a number. */
export function skeletonSkels(
  graph: MedialGraph,
  kernel: Kernel,
  params: KernelParams,
  threshold: number,
): Silhouette | null {
  const whole = pieced(contracted(sound(graph)));
  if (whole.nodes.length === 0) return null;
  const found = fitWeights(whole, envelopeOf(whole), kernel, params, threshold, EDITED);
  return { ...found, graph, params };
}

/** of a link */
const MOST_PIECES = 12;
/** of the larger radius: circles that are linked and nearer are one */
const TOGETHER = 0.1;
/** Without the shortest links: the larger circle of the two stays. */
function contracted(graph: MedialGraph): MedialGraph {
  const { nodes, links } = graph;
  const short = links.find(([a, b]) => {
    const [p, q] = [nodes[a]!, nodes[b]!];
    return length2(sub2(p.at, q.at)) < TOGETHER * Math.max(p.radius, q.radius);
  });
  if (!short) return graph;
  const [stays, goes] = nodes[short[0]]!.radius >= nodes[short[1]]!.radius ? short : [short[1], short[0]];
  const to = (node: number) => {
    const other = node === goes ? stays : node;
    return other > goes ? other - 1 : other;
  };
  return contracted(
    sound({
      nodes: nodes.filter((_, i) => i !== goes),
      links: links.map(([a, b]) => [to(a), to(b)] as const),
    }),
  );
}

/** Links in pieces no longer than their larger circle is wide, along which weights can follow the cone. */
function pieced({ nodes, links }: MedialGraph): MedialGraph {
  const all = [...nodes];
  const pieces = links.flatMap(([a, b]) => {
    const [p, q] = [nodes[a]!, nodes[b]!];
    const wide = 2 * Math.max(p.radius, q.radius);
    const count = Math.min(Math.ceil(length2(sub2(q.at, p.at)) / wide), MOST_PIECES);
    const between = Array.from({ length: count - 1 }, (_, i) => {
      const t = (i + 1) / count;
      return all.push({ at: mix2(p.at, q.at, t), radius: p.radius + t * (q.radius - p.radius) }) - 1;
    });
    const row = [a, ...between, b];
    return row.slice(1).map((node, i) => [row[i]!, node] as const);
  });
  return { nodes: all, links: pieces };
}

/** places round a circle; radii between those along a cone, and how many at most */
const ROUND = 24;
const APART = 0.3;
const MOST_ALONG = 40;
/** of its radius: what is less deep in a circle or a cone is on it */
const INSIDE = 1e-3;

/** Places of circles and cones that are in no other. */
export function envelopeOf({ nodes, links }: MedialGraph): readonly Vec2[] {
  const round = nodes.flatMap(({ at, radius }) =>
    TURN.map(([x, y]): Vec2 => [at[0] + radius * x, at[1] + radius * y]),
  );
  const sides = links.flatMap(([a, b]) => sidesOf(nodes[a]!, nodes[b]!));
  const cones = links.map(([a, b]) => [nodes[a]!, nodes[b]!] as const);
  const lone = nodes.map((node) => [node, node] as const);
  return [...round, ...sides].filter((p) =>
    [...lone, ...cones].every(([a, b]) => heightOver(p, a, b) > -INSIDE * Math.min(a.radius, b.radius)),
  );
}

const TURN: readonly Vec2[] = Array.from({ length: ROUND }, (_, i): Vec2 => {
  const turn = (i * TAU) / ROUND;
  return [cos(turn), sin(turn)];
});

/** Along the two lines that touch both circles; none where one circle holds the other. */
function sidesOf(p: MedialNode, q: MedialNode): readonly Vec2[] {
  const e = sub2(q.at, p.at);
  const length = length2(e);
  const sine = (p.radius - q.radius) / length;
  if (!(Math.abs(sine) < 1)) return [];
  const cosine = Math.sqrt(1 - sine * sine);
  const pieces = Math.min(Math.ceil(length / (APART * Math.min(p.radius, q.radius))), MOST_ALONG);
  return [1, -1].flatMap((side) => {
    const n: Vec2 = [
      (sine * e[0] - side * cosine * e[1]) / length,
      (sine * e[1] + side * cosine * e[0]) / length,
    ];
    return Array.from({ length: pieces + 1 }, (_, i): Vec2 => {
      const t = i / pieces;
      const radius = p.radius + t * (q.radius - p.radius);
      return [p.at[0] + t * e[0] + radius * n[0], p.at[1] + t * e[1] + radius * n[1]];
    });
  });
}

/** mm outside the cone between two circles; below 0 inside. */
function heightOver(p: Vec2, a: MedialNode, b: MedialNode): number {
  const e = sub2(b.at, a.at);
  const d = sub2(p, a.at);
  const length = length2(e);
  const along = length > 0 ? (d[0] * e[0] + d[1] * e[1]) / length : 0;
  const aside = length > 0 ? Math.abs(d[0] * e[1] - d[1] * e[0]) / length : 0;
  const grows = length > 0 ? (b.radius - a.radius) / length : 0;
  const cosine = Math.sqrt(Math.max(1 - grows * grows, 0));
  // the circle on the way that the place is deepest in
  const deepest = along + (cosine > 0 ? (grows * aside) / cosine : grows * Infinity);
  const t = length > 0 ? Math.min(Math.max(deepest / length, 0), 1) : 0;
  return length2([d[0] - t * e[0], d[1] - t * e[1]]) - (a.radius + t * (b.radius - a.radius));
}
