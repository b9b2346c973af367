/**
 * Pieces become skels. By radius: of radii, which the body turns into weights, but where a weight is drawn or something has a
 * middle in which the radius is kept. By weight: one weight is shared out in the proportion of the radii.
 */
import type { AnySkel } from '../../field/expand.ts';
import type { Kernel, KernelParams } from '../../kernel/kernel.ts';
import { distance3, type Fidelity } from '../../skeleton/curve.ts';
import { lengthOf } from '../../skeleton/radii.ts';
import { areaOf } from '../../skeleton/region.ts';
import { lineWeight, plateWeight } from '../../skeleton/weight.ts';
import type { ArcPiece, LinePiece, Piece, PlatePiece, WeightCurvePiece } from './skeletons.ts';

export type Weigh = (piece: Piece) => AnySkel;

/** What the skels are for. */
export interface Body {
  readonly kernel: Kernel;
  readonly params: KernelParams;
  readonly threshold: number;
  /** Bézier ordinates of a weight along the piece, in parts of the first; null where its radii say how it changes */
  readonly parts: readonly number[] | null;
}

export function weighByRadius({ kernel, params, threshold, parts }: Body): Weigh {
  const line = (radius: number, length: number) => lineWeight(kernel, params, radius, threshold, length);
  const endless = (radius: number, length: number) => line(radius, kernel.wholeLine ? Infinity : length);
  return (piece) => {
    switch (piece.type) {
      case 'point':
        return { type: 'point', at: piece.at, radius: piece.radius };
      case 'plate':
        return plate(piece, plateWeight(kernel, params, piece.radius, threshold, areaIn(piece)));
      case 'segment':
        return segment(
          piece,
          piece.radii.map((radius) => line(radius, along(piece))),
        );
      case 'loop':
        return { ...loop(piece), radii: piece.radii };
      case 'curve':
        return { ...curve(piece), radii: piece.radii };
      case 'arc':
        return { ...arc(piece, threshold), radii: ends(piece.radii) };
      case 'spline':
        return {
          ...spline(piece, threshold),
          weights: piece.radii.map((radius) => endless(radius, along(piece))),
        };
      case 'profile':
        return profile(piece, times(endless(piece.radius, along(piece)), parts));
    }
  };
}

/** `weight` where the radius is `nominal`. */
export function weighByWeight(weight: number, nominal: number, { threshold, parts }: Body): Weigh {
  const share = (radius: number) => (weight * radius) / nominal;
  return (piece) => {
    switch (piece.type) {
      case 'point':
        return { type: 'point', at: piece.at, weight: share(piece.radius) };
      case 'plate':
        return plate(piece, share(piece.radius));
      case 'segment':
        return segment(piece, parts ? times(share(piece.radii[0]!), parts) : piece.radii.map(share));
      case 'loop':
        return { ...loop(piece), weights: piece.radii.map(share) };
      case 'curve':
        return { ...curve(piece), weights: piece.radii.map(share) };
      case 'arc':
        return { ...arc(piece, threshold), weights: ends(times(share(piece.radii[0]!), parts)) };
      case 'spline':
        return { ...spline(piece, threshold), weights: piece.radii.map(share) };
      case 'profile':
        return profile(piece, times(share(piece.radius), parts));
    }
  };
}

/** mm; of a spline that of its control points, somewhat too long */
const along = ({ points }: LinePiece | WeightCurvePiece): number => lengthOf(points, false);
const times = (weight: number, parts: Body['parts']): number[] => (parts ?? [1]).map((part) => part * weight);
const ends = ([start, end]: readonly number[]) => [start!, end ?? start!] as const;

/** Of T: a proven bound; the true error of arcs and splines is a seventh of it. A tenth of this takes three times as many chords. */
const FIELD_ERROR = 0.1;

/** From the smallest radius on, where the surface is. */
const fidelity = (radii: readonly number[], threshold: number): Fidelity => ({
  fieldError: FIELD_ERROR * threshold,
  distance: Math.min(...radii),
});

const loop = ({ points }: LinePiece) => ({ type: 'polyline', points, closed: true }) as const;
const curve = ({ points }: LinePiece) => ({ type: 'nurbs', points, density: 6 }) as const;
const spline = ({ points, radii }: LinePiece, threshold: number) =>
  ({ type: 'quadratic', points, ...fidelity(radii, threshold) }) as const;
const arc = ({ centre, start, angle, radii }: ArcPiece, threshold: number) =>
  ({ type: 'arc', centre, start, axis: [0, 0, 1], angle, ...fidelity(radii, threshold) }) as const;
const profile = ({ points }: WeightCurvePiece, ordinates: readonly number[]) =>
  ({ type: 'profile', points, curve: { type: 'bezier', ordinates } }) as const;
const plate = ({ loops }: PlatePiece, weight: number) =>
  ({ type: 'polygon', origin: [0, 0, 0], u: [1, 0, 0], v: [0, 1, 0], loops, weight }) as const;

function segment({ points }: LinePiece, ordinates: readonly number[]) {
  const [a, b] = [points[0]!, points[1]!];
  return { type: 'segment', a, b, weights: powersOf(ordinates, distance3(a, b)) } as const;
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

/** Holes may run either way round. */
function areaIn({ loops }: PlatePiece): number {
  const [outline, ...holes] = loops.map((loop) => Math.abs(areaOf(loop)));
  return holes.reduce((rest, hole) => rest - hole, outline!);
}
