/** Which trees the device culls itself (shaders/bricks); the others are culled by field/bricks.ts and uploaded. */
import type { FieldNode } from '../../field/node.ts';
import { type Program, programOf, TAKE } from '../program.ts';
import { SUM, TERM } from '../structs.ts';

/** as in shaders/bricks/sumRange.wgsl: sums of a tree, of which a bit each tells whether it counts */
const MOST_SUMS = 32;
/** of all of them: threads keep half a word of each */
export const MOST_TERMS = 2048;

/** shapes whose values say nothing of how far the surface is */
const NO_DISTANCES = ['ellipsoid', 'quadric'] as const;

/** FieldError for what has no field. */
export const cullsOnDevice = (node: FieldNode): boolean => isCulledOnDevice(programOf(node));

/** Terms of each sum. */
const termsOf = ({ steps, records }: Program): readonly number[] =>
  steps
    .filter(({ take }) => take === TAKE.SUM)
    .map(({ at }) => SUM.read(new DataView(records, 16 * at), 0))
    .map(({ first, end }) => (16 * (end - first)) / TERM.stride);

/** Rows of the entries of a cube that asks all terms. */
export const rowsOf = (program: Program): number =>
  termsOf(program).reduce((sum, terms) => sum + 5 + Math.ceil(terms / 4), 0);

export function isCulledOnDevice(program: Program): boolean {
  const { ingredients } = program;
  const sums = termsOf(program);
  return (
    ingredients.sections.size === 0 &&
    !ingredients.primitives.has('polygon') &&
    !NO_DISTANCES.some((name) => ingredients.shapes.has(name)) &&
    sums.length <= MOST_SUMS &&
    sums.reduce((sum, terms) => sum + terms, 0) <= MOST_TERMS
  );
}
