/**
 * From the outline of a region to its skeleton, and to skels whose surface follows it (Tai et al. 2004, §5).
 *
 * The outline is resampled evenly and much finer than there (400 places instead of twenty to a hundred), so that the circumcentres lie on
 * the medial axis to within the spacing; what is too much of it is then pruned by what the circles miss of the outline.
 */
import type { Kernel, KernelParams } from '../../kernel/kernel.ts';
import { length2, sub2 } from '../../math/tuple.ts';
import { widthFor } from '../weight.ts';
import { type MedialAxis, type MedialGraph, medialAxis } from './axis.ts';
import { FITTING, type FitOptions, type Fitted, fitWeights } from './fit.ts';
import { along, type Loop, roundOf, sizeOf, spaced } from './outline.ts';
import { PRUNING, type PruneOptions, prune, prunings } from './prune.ts';
import { SIMPLIFYING, type SimplifyOptions, simplify } from './simplify.ts';

export type SkeletonOptions = PruneOptions & SimplifyOptions;

export const SKELETON: SkeletonOptions = { ...PRUNING, ...SIMPLIFYING };

/** places along the outline: for the skeleton, and for the fit */
const PLACES = 400;
const FITTED = 200;

/** Loops do not cross; empty where they hold nothing. */
export function skeletonOf(loops: readonly Loop[], options: SkeletonOptions = SKELETON): MedialGraph {
  const { axis, fine } = axisOf(loops);
  return simplify(prune(axis, fine, options), options);
}

/** Of the outline by evenly spaced places; with its corners where they would cross. */
function axisOf(loops: readonly Loop[], count = PLACES): { axis: MedialAxis; fine: readonly Loop[] } {
  const fine = spaced(loops, count);
  const axis = medialAxis(fine);
  if (axis.triangulation.isDelaunay) return { axis, fine };
  const cornered = loops.map((loop) => along([loop], roundOf(loops) / count));
  return { axis: medialAxis(cornered), fine: cornered };
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
): Silhouette {
  const largest = skeleton.nodes.reduce((most, { radius }) => Math.max(most, radius), 0);
  // a kernel with a support has to reach the outline from where the form is widest
  const least = kernel.support < Infinity ? REACHING * largest : 0;
  const fitted = widthFor(kernel, params, Math.max(thinnest(skeleton) / SHARPER, least));
  const places = spaced(loops, FITTED).flat();
  return { ...fitWeights(skeleton, places, kernel, fitted, threshold, options), params: fitted };
}

/** shares by which branches are pruned, until the surface follows the outline: what trembles less than it is off never comes back */
const DETAIL = (globalThis as any).DETAIL ?? ([PRUNING.branch, 0.12, 0.07, 0.04] as const);
/** of the longer side of the outline */
const ENOUGH = (globalThis as any).ENOUGH ?? 0.012;

/** The coarsest skeleton whose surface follows the outline, or else the one that does so best. Loops do not cross. */
export function silhouetteOf(
  loops: readonly Loop[],
  kernel: Kernel,
  params: KernelParams,
  threshold: number,
): Silhouette | null {
  let best: Silhouette | null = null;
  const { axis, fine } = axisOf(loops);
  let before = 0;
  for (const pruned of prunings(axis, fine, DETAIL)) {
    const whole = pruned();
    if (whole.nodes.length === before) continue;
    before = whole.nodes.length;
    const skeleton = simplify(whole);
    if (skeleton.nodes.length === 0) return null;
    const found = silhouetteSkels(skeleton, loops, kernel, params, threshold);
    if (!best || found.most < 0.9 * best.most) best = found;
    if (found.most <= ENOUGH * sizeOf(loops)) break;
  }
  return best;
}

/** widths are made for radii smaller than they are by this: s R = 1.2; at .8 the thirty outlines of the tests are a fifth further off */
const SHARPER = (globalThis as any).SHARPER ?? 4;
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
