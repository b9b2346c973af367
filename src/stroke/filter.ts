/**
 * From what the pen reported to the control points of a smooth stroke: the one pipeline all strokes pass.
 *
 * Theory: the thesis, chapter 4: a B-spline of few control points, found by reversing subdivision three times.
 * Departures: fair least squares by default (`leastSquares.ts` and `fair.ts` have the numbers); steps measured in length, not in samples;
 * hooks, closing and corners, which the thesis leaves out; short strokes are resampled finer instead of being reduced
 * to a handful of points (a half circle of 34 samples and three levels leaves 6 control points, and the sphere made of
 * it 2 % too large).
 */
import type { Vec2 } from '../math/vec.ts';
import type { Degree } from './bspline.ts';
import { clean } from './clean.ts';
import { CLOSED_TOLERANCE, isClosed, joinEnds } from './closed.ts';
import { findCorners } from './corners.ts';
import { fitFair } from './fair.ts';
import { fillGaps } from './gaps.ts';
import { removeHooks } from './hooks.ts';
import { between, type Ink, type Path, pathOf, toVec } from './path.ts';
import { pressureProfile } from './pressure.ts';
import { resample } from './resample.ts';
import { reverseLevels } from './reverse.ts';
import type { Sample } from './stroke.ts';
import { fineCount } from './subdivide.ts';

/** 'chaikin' and 'cubic' reverse subdivision as the thesis does; 'chaikin' makes degree 2, the others 3 */
export type FilterKind = 'least-squares' | 'chaikin' | 'cubic';

export interface FilterOptions {
  readonly filter: FilterKind;
  /** 0–6: each level halves the control points; 0 keeps the resampled polyline */
  readonly levels: number;
  /** 'auto' (default) closes strokes whose ends nearly meet */
  readonly closed?: boolean | 'auto';
  /** keep sharp corners (default true) */
  readonly corners?: boolean;
  /** mm; the smallest thing a hand means to draw: 1/200 of the height visible while drawing (default 1) */
  readonly grain?: number;
}

export const FILTER_DEFAULTS: FilterOptions = { filter: 'least-squares', levels: 3 };

export interface FilteredStroke {
  readonly degree: Degree;
  readonly closed: boolean;
  /** one closed piece without corners; all other pieces are clamped and meet at their ends */
  readonly periodic: boolean;
  /** control points in mm, at least FEWEST_CONTROLS each */
  readonly pieces: readonly (readonly Vec2[])[];
  /** 0–1, evenly along the stroke; closed strokes do not repeat the first */
  readonly pressure: readonly number[];
}

/** Fewer control points than this visibly deform a half circle. */
export const FEWEST_CONTROLS = 8;
/** Short strokes are resampled finer: with fewer steps the chords between them would show. */
const FEWEST_STEPS = 96;
/** … but the pieces of a hatch share: a sixth of that is enough for one of hundreds */
const FEWEST_STEPS_IN_ALL = 9600;
/** fine points per grain: at three levels a control point every 5.3 grains */
const STEPS_PER_GRAIN = 1.5;
/** 100 m of stroke at the default grain; longer ones get longer steps */
const MOST_FINE_POINTS = 1 << 17;
/** a level of smoothing may move the curve by this much: a quarter of a millimetre, one pixel, at three levels */
const FAIR_GRAINS = 0.08;
/** a tremble of one pixel to either side, at four pixels a grain */
export const REST_GRAINS = 0.4;

/** The smooth stroke, or null when the samples hold fewer than two places (a dot). RangeError for levels beyond 0–6. */
export function filterStroke(samples: readonly Sample[], options: FilterOptions): FilteredStroke | null {
  checkLevels(options.levels);
  const cleaned = clean(samples, REST_GRAINS * (options.grain ?? 1));
  if (cleaned === null) return null;
  // One budget of fine points for the whole stroke, however long it is and into however many pieces it falls.
  const length = pathOf(cleaned.samples, false).length;
  const { x, y } = cleaned.samples[0]!;
  if (!(length > ROUNDING * (Math.abs(x) + Math.abs(y) + (options.grain ?? 1)))) return null;
  const longest = length * STEPS_PER_GRAIN;
  const grain = Math.max(options.grain ?? 1, longest / MOST_FINE_POINTS);
  const drawn = pathOf(removeHooks(cleaned.samples, grain), false);
  const path = shouldClose(drawn, options.closed ?? 'auto') ? joinEnds(drawn) : drawn;
  const corners = (options.corners ?? true) ? findCorners(path, grain) : [];
  const periodic = path.closed && corners.length === 0;
  const parts = split(path, corners);
  const fewest = Math.max(FEWEST_STEPS / 6, Math.min(FEWEST_STEPS, FEWEST_STEPS_IN_ALL / parts.length));
  return {
    degree: degreeOf(options),
    closed: path.closed,
    periodic,
    pieces: parts.map((points) => fitPiece(points, periodic, options, { grain, fewest })),
    pressure: pressureProfile(path, corners[0] ?? 0),
  };
}

/** parts of its distance from the origin, and of the grain, that a stroke must be longer than: what is shorter is rounding */
const ROUNDING = 1e-12;

const degreeOf = ({ filter }: FilterOptions): Degree => (filter === 'chaikin' ? 2 : 3);

function shouldClose(path: Path, closed: boolean | 'auto'): boolean {
  // two points enclose nothing
  if (path.points.length < 3) return false;
  return closed === 'auto' ? isClosed(path, CLOSED_TOLERANCE) : closed;
}

/** The stretches between corners, in order; a closed path begins at its first corner. Neighbours share their ends exactly. */
function split(path: Path, corners: readonly number[]): readonly (readonly Ink[])[] {
  if (path.closed && corners.length === 0) return [path.points];
  const bounds = path.closed ? [...corners, corners[0]! + path.length] : [0, ...corners, path.length];
  const pieces = bounds.slice(1).map((to, i) => between(path, bounds[i]!, to));
  return pieces.map((piece, i) => {
    const next = pieces[i + 1] ?? (path.closed ? pieces[0] : undefined);
    return next === undefined ? piece : [...piece.slice(0, -1), next[0]!];
  });
}

function fitPiece(
  points: readonly Ink[],
  periodic: boolean,
  options: FilterOptions,
  { grain, fewest }: { readonly grain: number; readonly fewest: number },
): readonly Vec2[] {
  const degree = degreeOf(options);
  const drawn = pathOf(points, periodic);
  const step = Math.min(grain / STEPS_PER_GRAIN, drawn.length / fewest);
  const even = evenPath(pathOf(fillGaps(points, periodic, step), periodic), step);
  const count = controlCount(even.length, grain, options.levels);
  const fine = resample(even, fineCount(count, degree, periodic, options.levels)).map(toVec);
  if (options.levels === 0) return fine;
  if (options.filter === 'least-squares')
    return fitFair(fine, periodic, count, FAIR_GRAINS * options.levels * grain);
  return reverseLevels(fine, degree, periodic, options.levels);
}

/** Resampled once to steps alike, because tremble lengthens a path and unevenly so: by a tenth where the pen is slow. */
function evenPath(path: Path, step: number): Path {
  // of a piece between two corners in one place there is no step
  const count = Math.ceil(Math.min(path.length / step || 1, MOST_FINE_POINTS)) + 1;
  return pathOf(resample(path, count), path.closed);
}

/** Control points of a piece: by its length alone, never by the pen's rate. */
function controlCount(length: number, grain: number, levels: number): number {
  const fine = Math.min((length * STEPS_PER_GRAIN) / grain, MOST_FINE_POINTS);
  return Math.max(FEWEST_CONTROLS, Math.ceil(fine / (1 << levels)) + 2);
}

function checkLevels(levels: number): void {
  if (Number.isInteger(levels) && levels >= 0 && levels <= 6) return;
  throw new RangeError(`filter levels must be a whole number from 0 to 6, got ${levels}`);
}
