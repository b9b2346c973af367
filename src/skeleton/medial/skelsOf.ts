/**
 * Skels of a graph of circles: a segment a link with its weight linear between the nodes', and points where a line alone would not do: at free
 * ends, joints, and where circles are larger than all their neighbours (the round head on a thin neck).
 */
import { distance2 } from '../../math/tuple.ts';
import type { Vec3 } from '../../math/vec.ts';
import type { PointSkel, SegmentSkel, Skel } from '../skels.ts';
import type { MedialGraph, MedialNode } from './axis.ts';
import { neighboursOf } from './branches.ts';

/** What of a skel is known before its weights: which unknowns it has. */
export interface Part {
  readonly skel: (weights: readonly number[]) => Skel;
  /** indices of unknowns: of a segment's ends, or of a point */
  readonly unknowns: readonly number[];
}

export interface Layout {
  readonly parts: readonly Part[];
  /** of each unknown, the circle that says its scale */
  readonly nodes: readonly MedialNode[];
  /** their indices */
  readonly nodeOf: readonly number[];
  /** of each unknown: a point's weight, not one along segments */
  readonly isPoint: readonly boolean[];
}

const place = ({ at }: MedialNode): Vec3 => [at[0], at[1], 0];

/** Unknowns are the weights at the nodes, shared by the segments that meet there, then those of points. */
export function layoutOf({ nodes, links }: MedialGraph): Layout {
  const near = neighboursOf({ nodes, links });
  const isLargest = (i: number) => near[i]!.every((other) => nodes[other]!.radius <= nodes[i]!.radius);
  const points = nodes.flatMap((_, i) => (near[i]!.length !== 2 || isLargest(i) ? [i] : []));
  const apart = links.filter(([a, b]) => distance2(nodes[a]!.at, nodes[b]!.at) > 0);
  const segments = apart.map(
    ([a, b]): Part => ({
      skel: (weights) => segmentOf(nodes[a]!, nodes[b]!, weights),
      unknowns: [a, b],
    }),
  );
  const lumps = points.map(
    (node, i): Part => ({
      skel: ([weight]) => pointOf(nodes[node]!, weight!),
      unknowns: [nodes.length + i],
    }),
  );
  return {
    parts: [...segments, ...lumps],
    nodes: [...nodes, ...points.map((node) => nodes[node]!)],
    nodeOf: [...nodes.keys(), ...points],
    isPoint: [...nodes.map(() => false), ...points.map(() => true)],
  };
}

/** Those that have a weight; `x` is relative to `scales`, of each unknown. */
export function skelsWith({ parts }: Layout, scales: readonly number[], x: readonly number[]): Skel[] {
  return parts
    .filter(({ unknowns }) => unknowns.some((i) => x[i] !== 0))
    .map(({ skel, unknowns }) => skel(unknowns.map((i) => scales[i]! * x[i]!)));
}

function segmentOf(a: MedialNode, b: MedialNode, [from, to]: readonly number[]): SegmentSkel {
  const [p, q] = [place(a), place(b)];
  const length = Math.sqrt((q[0] - p[0]) * (q[0] - p[0]) + (q[1] - p[1]) * (q[1] - p[1]));
  return { type: 'segment', a: p, b: q, weights: [from!, (to! - from!) / length] };
}

const pointOf = (node: MedialNode, weight: number): PointSkel => ({ type: 'point', at: place(node), weight });
