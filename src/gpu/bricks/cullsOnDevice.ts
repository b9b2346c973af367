/** Which trees the device culls itself (shaders/bricks); the others are culled by field/bricks.ts and uploaded. */
import type { FieldNode } from '../../field/node.ts';
import { kernels } from '../../kernel/index.ts';
import type { Kernel } from '../../kernel/kernel.ts';
import type { Ingredients } from '../ingredients.ts';
import { type Program, programOf, TAKE } from '../program.ts';
import { SUM, TERM } from '../structs.ts';

/** as in shaders/bricks/sumRange.wgsl: sums of a tree, of which a bit each tells whether it counts */
const MOST_SUMS = 32;
/** of all of them: threads keep half a word of each */
export const MOST_TERMS = 2048;

/** Beside a plate of theirs float32 leaves two digits. */
const isSingular =
  ({ kernels: used }: Ingredients) =>
  ({ name, homogeneity }: Kernel) =>
    homogeneity !== 0 && used.has(name);

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
    !(ingredients.primitives.has('polygon') && kernels.some(isSingular(ingredients))) &&
    sums.length <= MOST_SUMS &&
    sums.reduce((sum, terms) => sum + terms, 0) <= MOST_TERMS
  );
}
