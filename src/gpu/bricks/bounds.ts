/**
 * What culling on the device has to know of leaves and terms beyond their records: made once of what the records hold, rounded as
 * that is, and put after them, where the stages of the mesh do not look.
 */
import { stretches } from '../../field/affine.ts';
import { bindField } from '../../field/bind.ts';
import { Tally } from '../../field/near.ts';
import { MOST_MISSED } from '../../field/nearCut.ts';
import type { FieldNode, SkelsNode } from '../../field/node.ts';
import { piecesOf } from '../../field/pieces.ts';
import type { RecordValue } from '../../math/record.ts';
import { leavesOf } from '../polygonize/lists.ts';
import { type Program, type Step, TAKE } from '../program.ts';
import { BOUND, LEAF, PLACE, SUM, TERM } from '../structs.ts';
import { sharesOf } from './shares.ts';
import { type Bound, boundOf, CHANGE, OVER, ROW, viewOf } from './termBound.ts';

export interface BoundedProgram {
  /** those of the program, then bounds of terms, then a leaf for each step */
  readonly records: ArrayBuffer;
  /** where the leaves begin, in rows of 16 bytes */
  readonly leaves: number;
}

/** `program`: of that very tree, which cullsOnDevice takes. */
export function boundedProgram(node: FieldNode, program: Program): BoundedProgram {
  const leafOf = leavesOf(program.steps);
  const bodies = bodiesOf(node);
  const slopes = slopesOf(node);
  const first = program.records.byteLength / ROW;
  const bounds: Bound[] = [];
  const leaves = program.steps.map((step, i) => {
    const count = bounds.length;
    const own = first + (bounds.length * BOUND.stride) / ROW;
    const sum = step.take === TAKE.SUM ? SUM.read(viewOf(program, step.at), 0) : null;
    if (sum) bounds.push(...boundsOf(program, sum, bodies[leafOf[i]!]!));
    return {
      stretch: stretchOf(program, step),
      slope: slopes[leafOf[i]!] ?? 0,
      most: MOST_MISSED * (sum?.threshold ?? 0),
      bounds: own,
      ...evenPower(bounds.slice(count)),
    };
  });
  const table = bounds.length > 0 ? BOUND.pack(bounds) : new ArrayBuffer(0);
  return {
    records: joined([program.records, table, LEAF.pack(leaves)]),
    leaves: first + table.byteLength / ROW,
  };
}

/** Of the terms of a body, as they were written. */
function boundsOf(
  program: Program,
  { first, end }: Pick<RecordValue<(typeof SUM)['members']>, 'first' | 'end'>,
  body: SkelsNode,
): readonly Bound[] {
  const pieces = piecesOf(body);
  const rows = TERM.stride / ROW;
  if (pieces.length * rows !== end - first)
    throw new Error(`${pieces.length} bounds of ${(end - first) / rows} terms`);
  return pieces.map(({ skel, term: { warp } }, number) =>
    boundOf(program, TERM.read(viewOf(program, first + number * rows), 0), skel, warp?.section),
  );
}

/** Of terms that all change alike, and in proportion to themselves. */
function evenPower(bounds: readonly Bound[]) {
  const power = bounds[0]?.power ?? 0;
  const isEven = bounds.every(
    ({ change, sign, dimension, ...other }) =>
      change === CHANGE.POWER && sign !== 0 && dimension < 2 && other.power === power,
  );
  return { power: isEven ? power : 0, core: bounds[0]?.core ?? 0, unused: [0, 0] };
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

function joined(parts: readonly ArrayBuffer[]): ArrayBuffer {
  const all = new Uint8Array(parts.reduce((sum, { byteLength }) => sum + byteLength, 0));
  let end = 0;
  for (const part of parts) {
    all.set(new Uint8Array(part), end);
    end += part.byteLength;
  }
  return all.buffer;
}
