/** Zhu et al. 2011, table 2: its numbers, and the points at which polygons of ours are evaluated. */
import { kernels } from '../../src/kernel/index.ts';
import type { PolygonSkel } from '../../src/skeleton/skels.ts';
import { bound, type Grid, gridOf, rounded } from './timing.ts';

/** Seconds on a CPU of 2009 for 128³ points: DIT, CIT, CI */
export const PAPER = {
  'quartic star': [5.902, 13.67, 2.772],
  'quartic animal': [22.292, 50.769, 7.779],
  'cauchy star': [96.932, 268.491, 84.015],
  'cauchy animal': [327.216, 895.512, 286.96],
} as const;

/** the same on a graphics card of 2008 */
export const PAPER_GPU = {
  'quartic star': [0.064, 0.115, 0.037],
  'quartic animal': [0.186, 0.341, 0.11],
  'cauchy star': [0.132, 0.241, 0.09],
  'cauchy animal': [0.431, 0.795, 0.291],
} as const;

/** mm beyond the polygon's box */
const MARGIN = 1.2;

/** Points in and around a polygon. */
export function around(skel: PolygonSkel): Grid {
  const { min, max } = bound(skel, kernels[0]!).box;
  return gridOf(
    {
      min: [min[0] - MARGIN, min[1] - MARGIN, min[2] - MARGIN],
      max: [max[0] + MARGIN, max[1] + MARGIN, max[2] + MARGIN],
    },
    [24, 24, 12],
  );
}

/** A row of the table: `least` in milliseconds for all points of the grid. */
export function rowOf(
  title: string,
  skel: PolygonSkel,
  { count }: Grid,
  least: Readonly<Record<'ci' | 'cit' | 'dit', number>>,
  [dit, cit, ci]: readonly [number, number, number],
  error: number,
) {
  const micro = 1000 / count;
  return {
    polygon: `${title}, ${skel.loops[0]!.length}`,
    'CI, µs a point': rounded(least.ci * micro, 2),
    CIT: rounded(least.cit * micro, 2),
    DIT: rounded(least.dit * micro, 2),
    'CIT / CI': rounded(least.cit / least.ci, 2),
    'paper’s': rounded(cit / ci, 2),
    'DIT / CI': rounded(least.dit / least.ci, 2),
    'paper’s ': rounded(dit / ci, 2),
    'error of DIT': error.toExponential(0),
  };
}
