/**
 * Weights a segment by itself, as Tai et al. 2004 (21)–(24) infer them: each end from its own point beside it, then both scaled so that the
 * middle is right, and shared out at nodes where several meet. For comparison.
 *
 * (21) lacks 1/l; the cross terms that (23) neglects leave the ends at 0.26 to 0.83 of the threshold, so that `infer` solves for both ends
 * and the middle at once, by least squares with weights ≥ 0.
 */
import type { Kernel, KernelParams } from '../../kernel/kernel.ts';
import { boundedLeastSquares } from '../../math/boundedLeastSquares.ts';
import { bindSkel } from '../index.ts';
import type { PointSkel, SegmentSkel, Skel } from '../skels.ts';
import { pointWeight } from '../weight.ts';
import type { MedialGraph, MedialNode } from './axis.ts';

/** How the weights of one segment are found: `rows` are what its ends' weights give at places beside it, which should be `threshold`. */
type Solve = (rows: readonly (readonly [number, number])[], threshold: number) => readonly [number, number];

/** (23) and (24): the first and the last place decide, the middle one scales. */
const asPaper: Solve = (rows, threshold) => {
  const [w0, w1] = [threshold / rows[0]![0], threshold / rows.at(-1)![1]];
  const middle = rows[(rows.length - 1) / 2]!;
  const kappa = threshold / (w0 * middle[0] + w1 * middle[1]);
  return [kappa * w0, kappa * w1];
};

const together: Solve = (rows, threshold) => {
  const scaled = rows.map(([a, b]) => [a / threshold, b / threshold]);
  const start = asPaper(rows, threshold);
  const { x } = boundedLeastSquares(
    scaled,
    rows.map(() => 1),
    [0, 0],
    [Infinity, Infinity],
    start,
  );
  return [x[0]!, x[1]!];
};

/** As the paper has it. */
export const inferPaper = inferring(asPaper);
/** All places at once, without neglecting any. */
export const infer = inferring(together);

/** odd: the middle is one of them */
const PLACES = 9;

function inferring(solve: Solve) {
  return (
    { nodes, links }: MedialGraph,
    kernel: Kernel,
    params: KernelParams,
    threshold: number,
  ): readonly Skel[] => {
    const degrees = nodes.map(() => 0);
    for (const link of links) for (const node of link) degrees[node]!++;
    const segments = links.map(([i, j]): SegmentSkel => {
      const [p, q] = [nodes[i]!, nodes[j]!];
      const [w0, w1] = solve(rowsOf(p, q, kernel, params), threshold);
      return segmentOf(p, q, w0 / degrees[i]!, w1 / degrees[j]!);
    });
    const lone = nodes.flatMap(({ at, radius }, i): PointSkel[] =>
      degrees[i]! > 0
        ? []
        : [{ type: 'point', at: [at[0], at[1], 0], weight: pointWeight(kernel, params, radius, threshold) }],
    );
    return [...segments, ...lone];
  };
}

/** What a weight of one at either end gives at places beside the segment, as far from it as the radius there. */
function rowsOf(
  p: MedialNode,
  q: MedialNode,
  kernel: Kernel,
  params: KernelParams,
): (readonly [number, number])[] {
  const fields = [segmentOf(p, q, 1, 0), segmentOf(p, q, 0, 1)].map((skel) => bindSkel(skel, kernel, params));
  return Array.from({ length: PLACES }, (_, i) => {
    const t = i / (PLACES - 1);
    const at = [p.at[0] + t * (q.at[0] - p.at[0]), p.at[1] + t * (q.at[1] - p.at[1])] as const;
    const above = p.radius + t * (q.radius - p.radius);
    // all directions off the segment are alike
    return [fields[0]!.value(at[0], at[1], above), fields[1]!.value(at[0], at[1], above)] as const;
  });
}

function segmentOf(p: MedialNode, q: MedialNode, w0: number, w1: number): SegmentSkel {
  const [dx, dy] = [q.at[0] - p.at[0], q.at[1] - p.at[1]];
  const length = Math.sqrt(dx * dx + dy * dy);
  return { type: 'segment', a: [...p.at, 0], b: [...q.at, 0], weights: [w0, (w1 - w0) / length] };
}
