/** Pieces become skels: their radii become weights of a kernel, or one weight is shared out in the proportion of the radii. */
import type { Kernel, KernelParams } from '../../kernel/kernel.ts';
import type { Vec2 } from '../../math/vec.ts';
import { distance3 } from '../../skeleton/curve.ts';
import type { NurbsSkel } from '../../skeleton/nurbs.ts';
import type { PolylineSkel } from '../../skeleton/polyline.ts';
import type { Skel } from '../../skeleton/skels.ts';
import { lineWeight, plateWeight, pointWeight } from '../../skeleton/weight.ts';
import type { Piece } from './skeletons.ts';

export interface Weigh {
  point(radius: number): number;
  /** `length` of the whole line, mm; `straight`: it is one segment */
  line(radius: number, length: number, straight: boolean): number;
  /** mm² */
  plate(radius: number, area: number): number;
  /** of a segment, in parts of its weight: Bézier ordinates along it; null: linear between its ends */
  readonly ordinates: readonly number[] | null;
}

/** Radii are kept in the middle of a segment, and along a curve as if it had no ends, where the kernel allows that. */
export function weighByRadius(kernel: Kernel, params: KernelParams, threshold: number): Weigh {
  return {
    point: (radius) => pointWeight(kernel, params, radius, threshold),
    line: (radius, length, straight) =>
      lineWeight(kernel, params, radius, threshold, straight || !kernel.wholeLine ? length : Infinity),
    plate: (radius, area) => plateWeight(kernel, params, radius, threshold, area),
    ordinates: null,
  };
}

/** `weight` where the radius is `nominal`. */
export function weighByWeight(weight: number, nominal: number, ordinates: Weigh['ordinates']): Weigh {
  const share = (radius: number) => (weight * radius) / nominal;
  return { point: share, line: share, plate: share, ordinates };
}

/** What pieces become. */
export type WeighedSkel = Skel | PolylineSkel | NurbsSkel;

export function skelOf(piece: Piece, weigh: Weigh): WeighedSkel {
  switch (piece.type) {
    case 'point':
      return { type: 'point', at: piece.at, weight: weigh.point(piece.radius) };
    case 'plate': {
      const { loops, radius } = piece;
      const weight = weigh.plate(radius, areaOf(loops));
      return { type: 'polygon', origin: [0, 0, 0], u: [1, 0, 0], v: [0, 1, 0], loops, weight };
    }
  }
  const { points, radii } = piece;
  const length = points.slice(1).reduce((sum, point, i) => sum + distance3(points[i]!, point), 0);
  const straight = points.length === 2;
  const weights = radii.map((radius) => weigh.line(radius, length, straight));
  if (piece.type === 'curve') return { type: 'nurbs', points, weights, density: 6 };
  if (!straight) return { type: 'polyline', points, weights, closed: piece.type === 'loop' };
  const along = weigh.ordinates?.map((part) => part * weights[0]!) ?? weights;
  return { type: 'segment', a: points[0]!, b: points[1]!, weights: powersOf(along, length) };
}

const BINOMIAL = [[1], [1, 1], [1, 2, 1], [1, 3, 3, 1]] as const;

/** Bézier ordinates over `length` → coefficients of powers of mm. */
function powersOf(ordinates: readonly number[], length: number): number[] {
  const n = ordinates.length - 1;
  let scale = 1;
  return ordinates.map((_, k) => {
    const difference = BINOMIAL[k]!.reduce(
      (sum, count, i) => sum + ((k - i) % 2 === 0 ? count : -count) * ordinates[i]!,
      0,
    );
    const coefficient = (BINOMIAL[n]![k]! * difference) / scale;
    scale *= length;
    return coefficient;
  });
}

function areaOf(loops: readonly (readonly Vec2[])[]): number {
  const areas = loops.map((loop) =>
    loop.reduce((sum, [x, y], i) => {
      const [px, py] = loop.at(i - 1)!;
      return sum + (px * y - py * x) / 2;
    }, 0),
  );
  // holes may run either way round
  return areas.reduce((sum, area, i) => (i === 0 ? Math.abs(area) : sum - Math.abs(area)), 0);
}
