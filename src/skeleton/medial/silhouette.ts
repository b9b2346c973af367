/**
 * From the outline of a region to its skeleton, and to skels whose surface follows it (Tai et al. 2004, §5).
 *
 * The outline is resampled evenly and finer than there (260 places instead of twenty to a hundred), so that the circumcentres lie on the
 * medial axis to within the spacing; what is too much of it is then pruned by what the circles miss of the outline.
 */
import type { Kernel, KernelParams } from '../../kernel/kernel.ts';
import type { Vec2 } from '../../math/vec.ts';
import { type MedialAxis, type MedialGraph, medialAxis } from './axis.ts';
import { FITTING, type FitOptions, type Fitted, fitWeights } from './fit.ts';
import { along, type Loop, roundOf, sizeOf, spaced } from './outline.ts';
import { joined, piecesOf } from './pieces.ts';
import { PRUNING, type PruneOptions, prune, prunings } from './prune.ts';
import { prunePaper } from './prunePaper.ts';
import { sampledLoops } from './sampled.ts';
import { SIMPLIFYING, type SimplifyOptions, simplify } from './simplify.ts';
import { widthOf } from './width.ts';

/** places along the outline: for the skeleton, and for the fit; while the pen moves */
const PLACES = 260;
const FITTED = 160;
const QUICK = 120;
/** places of a loop, at least, and of the outline, at most */
const FEWEST = 12;
const MOST_PLACES = 1200;
/** radii that places may be apart in the thinner half of the form */
const SPACING = 0.7;

/** Loops do not cross; empty where they hold nothing. */
export function skeletonOf(
  loops: readonly Loop[],
  options: PruneOptions & SimplifyOptions = { ...PRUNING, ...SIMPLIFYING },
): MedialGraph {
  const { axis, fine } = axisOf(held(loops), PLACES);
  const pruned = piecesOf(axis, fine).map(({ graph, loops }) => prune(graph, loops, options));
  return simplify(joined(pruned), options);
}

/** As Tai et al. 2004 have it, from places as theirs. */
const skeletonPaper = (loops: readonly Loop[]): MedialGraph =>
  prunePaper(medialAxis(sampledLoops(held(loops))));

/** Of the outline by evenly spaced places, more where it is thin; with its corners where they would cross. */
function axisOf(
  loops: readonly Loop[],
  count: number,
): { readonly axis: MedialAxis; readonly fine: readonly Loop[] } {
  const fine = spaced(loops, count, FEWEST);
  const axis = medialAxis(fine);
  if (!axis.triangulation.isDelaunay) {
    const cornered = loops.map((loop) => along([loop], roundOf(loops) / count));
    return { axis: medialAxis(cornered), fine: cornered };
  }
  const radii = axis.nodes.map(({ radius }) => radius).sort((a, b) => a - b);
  // radii of less than the spacing say nothing: circles of a bar as thin come out at any size
  const thin = radii[Math.floor(radii.length / 4)] ?? Infinity;
  const wanted = Math.min(roundOf(loops) / (SPACING * thin), MOST_PLACES);
  return count === PLACES && wanted > 1.3 * count ? axisOf(loops, wanted) : { axis, fine };
}

export interface Silhouette extends Fitted {
  readonly params: KernelParams;
}

/** `params` are used as they are; the skels lie in the plane z = 0. */
function fitted(
  skeleton: MedialGraph,
  loops: readonly Loop[],
  kernel: Kernel,
  params: KernelParams,
  threshold: number,
  options: FitOptions,
  count: number,
): Silhouette {
  const wanted = Math.min(PER_NODE * skeleton.nodes.length, 2 * FITTED);
  const places = spaced(loops, Math.max(count, wanted), FEWEST).flat();
  return { ...fitWeights(skeleton, places, kernel, params, threshold, options), params };
}

/** places a node of a skeleton */
const PER_NODE = 5;

/** `params` that the kernel has no width in stay; a width is made for the limbs that are there. */
export function silhouetteSkels(
  skeleton: MedialGraph,
  loops: readonly Loop[],
  kernel: Kernel,
  params: KernelParams,
  threshold: number,
  options: FitOptions = FITTING,
): Silhouette {
  return fitted(skeleton, loops, kernel, widthOf([skeleton], kernel, params), threshold, options, FITTED);
}

export interface SilhouetteOptions {
  /** the kernel's: made for the form, or as `params` have it, as where several groups share one sum (`widthOf`) */
  readonly width?: 'fitted' | 'given';
  /** while the pen moves: one skeleton, whose nodes stay: thirty forms are off by 0.74 % in the mean (0.23), in a quarter of the time */
  readonly quick?: boolean;
  /** by our rules, or by those of Tai et al. 2004 */
  readonly skeleton?: 'ours' | 'paper';
}

/** coarsest first, until the surface follows the outline: what trembles less than it is off never comes back */
const DETAIL: readonly { readonly branch: number; readonly few: SimplifyOptions }[] = [
  { branch: PRUNING.branch, few: SIMPLIFYING },
  { branch: 0.07, few: { ...SIMPLIFYING, deviation: 0.05, longest: 2 } },
  { branch: 0.04, few: { ...SIMPLIFYING, deviation: 0.03, longest: 1.5 } },
];
/** of the longer side of the outline, where it is off most but for corners */
const ENOUGH = 0.01;
/** of the same: what has no larger circle is a line */
const HELD = 2e-4;
/** nodes: a finer skeleton does not have more, which would take long for little */
const MANY = 60;
/** share by which a finer skeleton has to be nearer */
const BETTER = 0.1;

/**
 * The coarsest skeleton whose surface follows the outline, or else the one that does so best; null where the loops hold nothing. Loops should
 * not cross (math/untangle.ts).
 */
export function silhouetteOf(
  loops: readonly Loop[],
  kernel: Kernel,
  params: KernelParams,
  threshold: number,
  { width = 'fitted', quick = false, skeleton = 'ours' }: SilhouetteOptions = {},
): Silhouette | null {
  const whole = held(loops);
  const size = sizeOf(whole);
  let best: Silhouette | null = null;
  const skeletons = skeleton === 'paper' ? [() => skeletonPaper(whole)] : skeletonsOf(whole, quick);
  for (const make of skeletons) {
    const graph = make();
    if (best && graph.nodes.length > MANY) break;
    if (!graph.nodes.some(({ radius }) => radius > HELD * size)) return null;
    const own = width === 'given' ? params : widthOf([graph], kernel, params);
    const options = quick ? { ...FITTING, moves: 0 } : FITTING;
    const found = fitted(graph, whole, kernel, own, threshold, options, quick ? QUICK : FITTED);
    if (!best || found.nearly < (1 - BETTER) * best.nearly) best = found;
    if (found.nearly <= ENOUGH * size) break;
  }
  return best;
}

function skeletonsOf(loops: readonly Loop[], quick: boolean): readonly (() => MedialGraph)[] {
  const levels = quick ? DETAIL.slice(1, 2) : DETAIL;
  const { axis, fine } = axisOf(loops, quick ? QUICK : PLACES);
  if (!axis.nodes.some(({ radius }) => radius > HELD * sizeOf(loops))) return [];
  const branches = levels.map(({ branch }) => branch);
  const pieces = piecesOf(axis, fine).map(({ graph, loops }) => prunings(graph, loops, branches));
  return levels.map(
    ({ few }, level) =>
      () =>
        simplify(joined(pieces.map((makes) => makes[level]!())), few),
  );
}

/** Loops of at least three different places that are numbers. */
function held(loops: readonly Loop[]): readonly Loop[] {
  const isPlace = ([x, y]: Vec2) => Math.abs(x) <= FARTHEST && Math.abs(y) <= FARTHEST;
  return loops
    .map((loop) => loop.filter(isPlace))
    .map((loop) => loop.filter((p, i) => p[0] !== loop.at(i - 1)![0] || p[1] !== loop.at(i - 1)![1]))
    .filter((loop) => loop.length > 2);
}

/** mm from the origin: fields do not reach further */
const FARTHEST = 1e12;
