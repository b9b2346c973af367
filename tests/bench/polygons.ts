/**
 * Two outlines with as many vertices as those of Zhu et al. 2011, fig. 8, whose coordinates are not given: a star of 69, and an
 * animal of 223 seen from the side. Plain data, mm; both simple and concave, counter-clockwise.
 */
import { kernels } from '../../src/kernel/index.ts';
import type { Vec2 } from '../../src/math/vec.ts';
import type { PolygonSkel } from '../../src/skeleton/skels.ts';
import { bound, type Grid, gridOf } from './timing.ts';

const plate = (loop: readonly Vec2[]): PolygonSkel => ({
  type: 'polygon',
  origin: [0, 0, 0],
  u: [1, 0, 0],
  v: [0, 1, 0],
  loops: [loop],
  weight: 1,
});

/** Five arms, their tips bent to one side. */
const star = (count: number): readonly Vec2[] =>
  Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    const radius = 2.9 + 1.6 * Math.cos(5 * angle);
    const bent = angle + 0.04 * radius;
    return [radius * Math.cos(bent), radius * Math.sin(bent)];
  });

/** muzzle, throat, fore and hind legs, rump, tail, back, neck, ears */
const ANIMAL: readonly Vec2[] = [
  [5.2, 2.1],
  [4.1, 1.7],
  [3.3, 0.9],
  [2.9, -0.6],
  [2.8, -3.2],
  [2, -3.2],
  [1.8, -1],
  [0.2, -0.7],
  [-1.6, -0.8],
  [-2.1, -3.3],
  [-3, -3.2],
  [-3, -1.2],
  [-3.3, 0.4],
  [-4.4, -0.4],
  [-5, -1.9],
  [-5.3, -0.5],
  [-4.3, 1.2],
  [-2.6, 1.6],
  [0.3, 1.3],
  [2, 1.7],
  [2.9, 3.2],
  [2.9, 4.4],
  [3.5, 3.6],
  [4.6, 2.9],
];

/** Closed Catmull–Rom spline through the points, clockwise as they are, as many vertices evenly in its parameter. */
const smooth = (through: readonly Vec2[], count: number): readonly Vec2[] =>
  Array.from({ length: count }, (_, i) => {
    const at = (through.length * i) / count;
    const first = Math.floor(at);
    const t = at - first;
    const along = (axis: 0 | 1) => {
      const [a, b, c, d] = [-1, 0, 1, 2].map((k) => through.at((first + k) % through.length)![axis]);
      return b! + 0.5 * t * (c! - a! + t * (2 * a! - 5 * b! + 4 * c! - d! + t * (3 * (b! - c!) + d! - a!)));
    };
    return [along(0), along(1)];
  });

export const POLYGONS = {
  star: plate(star(69)),
  animal: plate([...smooth(ANIMAL, 223)].reverse()),
} as const;

/** table 2, seconds on a CPU of 2009 for 128³ points: DIT, CIT, CI */
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
