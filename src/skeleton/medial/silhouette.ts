/**
 * From the outline of a region to its skeleton, and to skels whose surface follows it (Tai et al. 2004, §5).
 *
 * The outline is resampled evenly and much finer than there (400 places instead of twenty to a hundred), so that the circumcentres lie on
 * the medial axis to within the spacing; what is too much of it is then pruned by what the circles miss of the outline.
 */
import type { Kernel, KernelParams } from '../../kernel/kernel.ts';
import { length2, sub2 } from '../../math/tuple.ts';
import { widthFor } from '../weight.ts';
import { type MedialGraph, medialAxis } from './axis.ts';
import { FITTING, type FitOptions, type Fitted, fitWeights } from './fit.ts';
import { along, type Loop } from './outline.ts';
import { PRUNING, type PruneOptions, prune } from './prune.ts';
import { SIMPLIFYING, type SimplifyOptions, simplify } from './simplify.ts';

export type SkeletonOptions = PruneOptions & SimplifyOptions;

export const SKELETON: SkeletonOptions = { ...PRUNING, ...SIMPLIFYING };

/** places along the outline: for the skeleton, and for the fit */
const PLACES = 400;
const FITTED = 240;

/** Loops do not cross; empty where they hold nothing. */
export function skeletonOf(loops: readonly Loop[], options: SkeletonOptions = SKELETON): MedialGraph {
  const step = roundOf(loops) / PLACES;
  if (!(step > 0)) return { nodes: [], links: [] };
  const fine = loops.map((loop) => along([loop], step));
  return simplify(prune(medialAxis(fine), fine, options), options);
}

export interface Silhouette extends Fitted {
  readonly params: KernelParams;
}

/** `params` that the kernel has no width in stay; a width is made for the limbs that are there. */
export function silhouetteSkels(
  skeleton: MedialGraph,
  loops: readonly Loop[],
  kernel: Kernel,
  params: KernelParams,
  threshold: number,
  options: FitOptions = FITTING,
  width: 'fitted' | 'given' = 'fitted',
): Silhouette {
  const largest = skeleton.nodes.reduce((most, { radius }) => Math.max(most, radius), 0);
  // a kernel with a support has to reach the outline from where the form is widest
  const least = kernel.support < Infinity ? REACHING * largest : 0;
  const fitted =
    width === 'given' ? params : widthFor(kernel, params, Math.max(thinnest(skeleton) / SHARPER, least));
  const places = along(loops, roundOf(loops) / FITTED);
  return { ...fitWeights(skeleton, places, kernel, fitted, threshold, options), params: fitted };
}

/** shares by which branches are pruned, until the surface follows the outline: what trembles less than it is off never comes back */
const DETAIL = [PRUNING.branch, 0.12, 0.07, 0.04] as const;
/** of the longer side of the outline */
const ENOUGH = 0.012;

export interface SilhouetteOptions {
  readonly width?: 'fitted' | 'given';
  readonly quick?: boolean;
}

export function widthOf(
  of: readonly Loop[] | MedialGraph,
  kernel: Kernel,
  params: KernelParams,
): KernelParams | null {
  const skeleton = 'nodes' in of ? of : skeletonOf(of);
  if (skeleton.nodes.length === 0) return null;
  const largest = skeleton.nodes.reduce((most, { radius }) => Math.max(most, radius), 0);
  const least = kernel.support < Infinity ? REACHING * largest : 0;
  return widthFor(kernel, params, Math.max(thinnest(skeleton) / SHARPER, least));
}

export function leastWidth(kernel: Kernel, all: readonly KernelParams[]): KernelParams {
  const unit = (params: KernelParams) => kernel.unit(params, 1);
  const sorted = [...all].sort((a, b) => unit(a) - unit(b));
  return (kernel.support < Infinity ? sorted.at(-1) : sorted[0])!;
}

/** The coarsest skeleton whose surface follows the outline, or else the one that does so best. Loops do not cross. */
export function silhouetteOf(
  loops: readonly Loop[],
  kernel: Kernel,
  params: KernelParams,
  threshold: number,
  { width = 'fitted', quick = false }: SilhouetteOptions = {},
): Silhouette | null {
  let best: Silhouette | null = null;
  for (const branch of DETAIL) {
    const skeleton = skeletonOf(loops, { ...SKELETON, branch });
    if (skeleton.nodes.length === 0) return null;
    const found = silhouetteSkels(skeleton, loops, kernel, params, threshold, FITTING, width);
    if (quick) return found;
    if (!best || found.most < 0.9 * best.most) best = found;
    if (found.most <= ENOUGH * sizeOf(loops)) break;
  }
  return best;
}

function sizeOf(loops: readonly Loop[]): number {
  const flat = loops.flat();
  const span = (axis: 0 | 1) =>
    flat.reduce((most, p) => Math.max(most, p[axis]), -Infinity) -
    flat.reduce((least, p) => Math.min(least, p[axis]), Infinity);
  return Math.max(span(0), span(1));
}

/** widths are made for radii smaller than they are by this: s R = 1.2; at .8 the thirty outlines of the tests are a fifth further off */
const SHARPER = 4;
/** of the largest radius: a quartic kernel for it is 1.34 of that wide */
const REACHING = 0.9;
/** of the length of a skeleton: what is thinner is a tip, and no limb */
const TIPS = 0.15;
/** pieces a link */
const PIECES = 8;

/** mm: the radius that all but the tips of a skeleton have. */
export function thinnest({ nodes, links }: MedialGraph): number {
  const pieces = links.flatMap(([a, b]) => {
    const [p, q] = [nodes[a]!, nodes[b]!];
    const length = length2(sub2(q.at, p.at)) / PIECES;
    return Array.from({ length: PIECES }, (_, i) => {
      const t = (i + 0.5) / PIECES;
      return { length, radius: p.radius + t * (q.radius - p.radius) };
    });
  });
  const sorted = pieces.sort((a, b) => a.radius - b.radius);
  const tips = TIPS * sorted.reduce((sum, { length }) => sum + length, 0);
  let passed = 0;
  for (const { length, radius } of sorted) {
    passed += length;
    if (passed > tips) return radius;
  }
  return nodes.reduce((least, { radius }) => Math.min(least, radius), Infinity);
}

const roundOf = (loops: readonly Loop[]): number =>
  loops.flatMap((loop) => loop.map((p, i) => length2(sub2(p, loop.at(i - 1)!)))).reduce((a, b) => a + b, 0);
