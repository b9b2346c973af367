/** Which trees the device culls itself (shaders/bricks); the others are culled by field/bricks.ts and uploaded. */
import type { FieldNode } from '../../field/node.ts';
import { kernels } from '../../kernel/index.ts';
import type { Kernel } from '../../kernel/kernel.ts';
import type { Ingredients } from '../ingredients.ts';
import { type Program, programOf, TAKE } from '../program.ts';
import { SUM, TERM } from '../structs.ts';

/** What threads of shaders/bricks/cull.wgsl have room for. */
export interface Sizes {
  /** of a tree; a bit each tells whether it counts */
  readonly sums: number;
  /** of all of them: half a word each */
  readonly terms: number;
}

/** The room of a thread is its device's dearest: pipelines are made for the first that is large enough. */
const SIZES: readonly Sizes[] = [
  { sums: 1, terms: 128 },
  { sums: 4, terms: 512 },
  { sums: 32, terms: 2048 },
];
export const LARGEST = SIZES.at(-1)!;

/** Null where no size is large enough. */
export function sizesFor(program: Program): Sizes | null {
  const sums = termsOf(program);
  const all = sums.reduce((sum, terms) => sum + terms, 0);
  return SIZES.find((size) => sums.length <= size.sums && all <= size.terms) ?? null;
}

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
  const isHard = ingredients.primitives.has('polygon') && kernels.some(isSingular(ingredients));
  return !isHard && sizesFor(program) !== null;
}
