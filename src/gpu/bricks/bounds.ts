/**
 * What culling on the device has to know of leaves and terms beyond their records: made once of what the records hold, rounded as
 * that is, and put after them, where the stages of the mesh do not look.
 */
import { stretches } from '../../field/affine.ts';
import { bindField } from '../../field/bind.ts';
import { expanded } from '../../field/expand.ts';
import { Tally } from '../../field/near.ts';
import { MOST_MISSED } from '../../field/nearSum.ts';
import type { FieldNode, SkelsNode } from '../../field/node.ts';
import { polarLimits } from '../../field/polarProfile.ts';
import { superQuadricBend } from '../../field/superQuadric.ts';
import type { Warp } from '../../field/warp.ts';
import { kernelNamed, kernels } from '../../kernel/index.ts';
import type { Kernel } from '../../kernel/kernel.ts';
import { wholeLineOfPower, wholePlaneOfPower } from '../../kernel/wholePower.ts';
import type { RecordValue } from '../../math/record.ts';
import { bendsOf } from '../../skeleton/gaussSources.ts';
import { regionOf } from '../../skeleton/region.ts';
import type { PolygonSkel, Skel } from '../../skeleton/skels.ts';
import { weightRange } from '../../skeleton/weightRange.ts';
import { leavesOf } from '../polygonize/lists.ts';
import { type Program, type Step, TAKE } from '../program.ts';
import { BOUND, LEAF, PLACE, POINT, POLYGON, SEGMENT, SUM, TERM } from '../structs.ts';
import { sharesOf } from './shares.ts';

/** How kernels change: in proportion to themselves, or by slopes of their own. */
export const CHANGE = { POWER: 0, GAUSSIAN: 1, QUARTIC: 2 } as const;

export interface BoundedProgram {
  /** those of the program, then bounds of terms, then a leaf for each step */
  readonly records: ArrayBuffer;
  /** where the leaves begin, in rows of 16 bytes */
  readonly leaves: number;
}

type Bound = RecordValue<(typeof BOUND)['members']>;
type TermRecord = RecordValue<(typeof TERM)['members']>;

/** of numbers that bound: more than float32 rounds by */
const OVER = 1 + 1e-6;
/** of a segment's length, and of the radius where a singular point is 1: what is nearer is clamped (kernel/frame.wgsl) */
const LEAST = { segment: 2e-6, point: 2e-5 } as const;
const FAR = 1e30;
const ROW = 16;

/** `program`: of that very tree, which cullsOnDevice takes. */
export function boundedProgram(node: FieldNode, program: Program): BoundedProgram {
  const leafOf = leavesOf(program.steps);
  const bodies = bodiesOf(node);
  const slopes = slopesOf(node);
  const first = program.records.byteLength / ROW;
  const bounds: Bound[] = [];
  const leaves = program.steps.map((step, i) => {
    const own = first + (bounds.length * BOUND.stride) / ROW;
    const sum = step.take === TAKE.SUM ? SUM.read(viewOf(program, step.at), 0) : null;
    if (sum) {
      piecesOf(bodies[leafOf[i]!]!).forEach(({ skel, section }, number) => {
        const term = TERM.read(viewOf(program, sum.first + (number * TERM.stride) / ROW), 0);
        bounds.push({ ...boundOf(program, term, skel), section: sectionOf(section) });
      });
    }
    return {
      stretch: stretchOf(program, step),
      slope: slopes[leafOf[i]!] ?? 0,
      most: MOST_MISSED * (sum?.threshold ?? 0),
      bounds: own,
    };
  });
  const table = bounds.length > 0 ? BOUND.pack(bounds) : new ArrayBuffer(0);
  return {
    records: joined([program.records, table, LEAF.pack(leaves)]),
    leaves: first + table.byteLength / ROW,
  };
}

/** Of the tree's leaves: what may be missed of a sum's field for a millimetre that the surface is off. */
function slopesOf(node: FieldNode): readonly number[] {
  const shares = sharesOf(node);
  const slopes = shares.map(() => 0);
  const whole = bindField(node).near(new Tally());
  whole.eachLeaf(({ leaf, steep = 0 }) => {
    slopes[leaf] = steep * shares[leaf]!;
  });
  return slopes;
}

function stretchOf(program: Program, { place, take }: Step): number {
  if (place === 0 || take === TAKE.STACK) return 1;
  const { inverse: m } = PLACE.read(viewOf(program, place), 0);
  const row = (i: number) => [m[i]!, m[3 + i]!, m[6 + i]!, 0] as const;
  return stretches([...row(0), ...row(1), ...row(2)]).most * OVER;
}

/** The leaves of a tree in their order; null for shapes. */
function bodiesOf(node: FieldNode): readonly (SkelsNode | null)[] {
  switch (node.type) {
    case 'skels':
      return [node];
    case 'shape':
      return [null];
    case 'affine':
      return bodiesOf(node.node);
    case 'blend':
      return [node.a, node.b].flatMap(bodiesOf);
    case 'morph':
      return [node.from, node.to].flatMap(bodiesOf);
    default:
      return node.parts.flatMap(bodiesOf);
  }
}

/** What its terms are of, as they were written. */
const piecesOf = ({ skels, kernel, params, threshold }: SkelsNode) =>
  skels.flatMap(({ skel: own, warp }) =>
    expanded(own, kernelNamed(kernel)!, params, threshold).map((skel) => ({ skel, section: warp?.section })),
  );

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

function boundOf(program: Program, term: TermRecord, skel: Skel): Plain {
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

const viewOf = ({ records }: Program, row: number) => new DataView(records, ROW * row);

function joined(parts: readonly ArrayBuffer[]): ArrayBuffer {
  const all = new Uint8Array(parts.reduce((sum, { byteLength }) => sum + byteLength, 0));
  let end = 0;
  for (const part of parts) {
    all.set(new Uint8Array(part), end);
    end += part.byteLength;
  }
  return all.buffer;
}
