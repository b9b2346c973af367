/** What bounds on a term know of it, from its record and what was written in the tree. */
import { polarLimits } from '../../field/polarProfile.ts';
import { superQuadricBend } from '../../field/superQuadric.ts';
import type { Warp } from '../../field/warp.ts';
import { kernels } from '../../kernel/index.ts';
import type { Kernel } from '../../kernel/kernel.ts';
import { wholeLineOfPower, wholePlaneOfPower } from '../../kernel/wholePower.ts';
import type { RecordValue } from '../../math/record.ts';
import { bendsOf } from '../../skeleton/gaussSources.ts';
import { regionOf } from '../../skeleton/region.ts';
import type { PolygonSkel, Skel } from '../../skeleton/skels.ts';
import { weightRange } from '../../skeleton/weightRange.ts';
import type { Program } from '../program.ts';
import { type BOUND, POINT, POLYGON, SEGMENT, type TERM } from '../structs.ts';

/** How kernels change: in proportion to themselves, or by slopes of their own. */
export const CHANGE = { POWER: 0, GAUSSIAN: 1, QUARTIC: 2 } as const;

export type Bound = RecordValue<(typeof BOUND)['members']>;
type TermRecord = RecordValue<(typeof TERM)['members']>;

/** of numbers that bound: more than float32 rounds by */
export const OVER = 1 + 1e-6;
/** of a segment's length, and of the radius where a singular point is 1: what is nearer is clamped (kernel/frame.wgsl) */
const LEAST = { segment: 2e-6, point: 2e-5 } as const;
const FAR = 1e30;
/** bytes */
export const ROW = 16;

export const viewOf = ({ records }: Program, row: number) => new DataView(records, ROW * row);

/** Of a term of that skel, with the cross section that it has, if any. */
export const boundOf = (
  program: Program,
  term: TermRecord,
  skel: Skel,
  section: Warp['section'] | undefined,
): Bound => ({ ...plainBound(program, term, skel), section: sectionOf(section) });

function sectionOf(section: Warp['section'] | undefined): readonly number[] {
  switch (section?.type) {
    case 'superQuadric':
      return [Math.min(superQuadricBend(section.exponent) * OVER, FAR), 0, 0, 0];
    case 'extrusion':
      return [FAR, 0, 0, 0];
    case 'polar': {
      const { bend, steepest, smallest, largest } = polarLimits(section.radii);
      return [bend * OVER, steepest * OVER, smallest / OVER, largest * OVER];
    }
    default:
      return [0, 0, 0, 0];
  }
}

type Plain = Omit<Bound, 'section'>;

function plainBound(program: Program, term: TermRecord, skel: Skel): Plain {
  const kernel = kernels[term.kernel]!;
  switch (skel.type) {
    case 'point':
      return pointBound(program, term, kernel);
    case 'segment':
      return segmentBound(program, term, kernel);
    case 'polygon':
      return plateBound(program, term, kernel, skel);
  }
}

function pointBound(program: Program, { skel, factor }: TermRecord, kernel: Kernel): Plain {
  const { weight, exponent, scale } = POINT.read(viewOf(program, skel), 0);
  return {
    ...kernelBound(kernel, exponent, LEAST.point),
    most: Math.abs(factor * weight) * OVER,
    sign: Math.sign(factor * weight),
    size: 1,
    turns: 1,
    dimension: 0,
    whole: 0,
    per: scale * OVER,
    bends: [1, 0, 0, 0],
  };
}

function segmentBound(program: Program, { skel, factor }: TermRecord, kernel: Kernel): Plain {
  const { weights, length, exponent, scale } = SEGMENT.read(viewOf(program, skel), 0);
  const line = { weights: Float64Array.from(weights), length };
  const range = weightRange(line);
  const bound = kernelBound(kernel, exponent, LEAST.segment * length);
  return {
    ...bound,
    most: Math.abs(factor) * range.most * OVER,
    sign: range.sign * Math.sign(factor),
    size: length * OVER,
    turns: 1,
    dimension: 1,
    whole: bound.power > 1 ? wholeLineOfPower(1, bound.power) * OVER : 0,
    per: scale * OVER,
    bends: [...bendsOf(line, range.most || 1)].map((bend) => bend * OVER),
  };
}

function plateBound(
  program: Program,
  { skel, factor }: TermRecord,
  kernel: Kernel,
  plate: PolygonSkel,
): Plain {
  const { weight, exponent, scale } = POLYGON.read(viewOf(program, skel), 0);
  const { covered, turns, isOneWay } = regionOf(plate);
  const bound = kernelBound(kernel, exponent, LEAST.segment);
  return {
    ...bound,
    most: Math.abs(factor * weight) * OVER,
    sign: isOneWay ? Math.sign(factor * weight) : 0,
    size: covered * scale * scale * OVER,
    turns,
    dimension: 2,
    whole: bound.power > 2 ? wholePlaneOfPower(1, bound.power) * OVER : 0,
    per: scale * OVER,
    bends: [1, 0, 0, 0],
  };
}

function kernelBound({ name, change, support, homogeneity }: Kernel, exponent: number, least: number) {
  const isPower = change.type === 'relative';
  return {
    change: isPower ? CHANGE.POWER : name === 'gaussian' ? CHANGE.GAUSSIAN : CHANGE.QUARTIC,
    core: isPower ? change.core : 1,
    power: isPower ? change.power(exponent) : 4,
    support: Math.min(support, FAR),
    least: homogeneity === 0 ? 0 : least,
  };
}
