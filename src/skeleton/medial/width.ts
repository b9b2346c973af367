/**
 * How wide a kernel should be for a group of limbs: sharp enough for the thin ones, and wide enough that the thick ones hold their outline.
 *
 * Five forms were fitted well with s R ≥ 0.6 for the least radius R; with ends and nodes that move, thirty forms are off
 * by .28 % at s R = 2.4, .24 % at 3.2 and .24 % at 4.8.
 */
import type { Kernel, KernelParams } from '../../kernel/kernel.ts';
import { length2, sub2 } from '../../math/tuple.ts';
import { reach } from '../binding.ts';
import { widthFor } from '../weight.ts';
import type { MedialGraph } from './axis.ts';
import { sound } from './branches.ts';

/** widths are made for radii smaller than they are by this: s R = 3.2 */
const SHARPER = 4;
/** largest radii in a support; at 1.2 the thirty outlines are half as far off again */
const SUPPORT = 1.07;
/** what a kernel without a support is where the form is widest, at least: at 1e-6 of the Gaussian kernel thirty outlines are off by .78 %, so by .31 */
const FAINT = 1e-3;
/** of the length of a skeleton: what is thinner is a tip, and no limb */
const TIPS = 0.15;
/** pieces a link */
const PIECES = 8;

/** The width for all these skeletons in one sum; kernels that have none, and nothing, leave `params` as they are. */
export function widthOf(graphs: readonly MedialGraph[], kernel: Kernel, params: KernelParams): KernelParams {
  const skeletons = graphs.map(sound);
  const thin = skeletons.reduce((least, skeleton) => Math.min(least, thinnest(skeleton)), Infinity);
  const radii = skeletons.flatMap(({ nodes }) => nodes.map(({ radius }) => radius));
  const largest = radii.reduce((most, radius) => Math.max(most, radius), 0);
  if (kernel.homogeneity !== 0 || !(largest > 0)) return params;
  const wanted = widthFor(kernel, params, thin / SHARPER);
  const unit = kernel.unit(wanted, largest);
  const { n = 4 } = wanted;
  const needed =
    kernel.support < Infinity
      ? (SUPPORT * largest) / kernel.support
      : largest / reach((r2) => kernel.value(r2, n), FAINT, kernel.support);
  if (unit >= needed) return wanted;
  return widthFor(kernel, params, (thin / SHARPER) * (needed / unit));
}

/** mm: the radius that all but the tips of a skeleton have; Infinity where there is none. */
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
