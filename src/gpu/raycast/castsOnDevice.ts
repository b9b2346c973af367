/** Which trees rays on the device know bounds for; the others are the CPU's (field/raycast.ts). */
import type { FieldNode } from '../../field/node.ts';
import { shapes } from '../../shape/index.ts';
import { isCulledOnDevice } from '../bricks/cullsOnDevice.ts';
import { ROW, viewOf } from '../bricks/termBound.ts';
import { type Ingredients, namesOf, numberOf } from '../ingredients.ts';
import { type Program, programOf, TAKE } from '../program.ts';
import { SUM, TERM, WARP } from '../structs.ts';

/** of super-quadrics: below it their maps have creases */
const SMOOTH = 2;
const CREASED = numberOf('sections', 'superQuadric');

/** FieldError for what has no field. */
export const castsOnDevice = (node: FieldNode): boolean => isCastOnDevice(programOf(node));

/** Not maps of cross sections that have creases, nor blends of what tells of its sign ahead but not of its slope. */
export const isCastOnDevice = (program: Program): boolean =>
  isCulledOnDevice(program) && tellsSlopes(program.ingredients) && hasSmoothSections(program);

function tellsSlopes(ingredients: Ingredients): boolean {
  const isMixed = ingredients.operations.has('blendUnion') || ingredients.operations.has('morph');
  return !isMixed || namesOf(ingredients, 'shapes').every((name) => shapes[name].exact);
}

function hasSmoothSections(program: Program): boolean {
  const { sections } = program.ingredients;
  if (sections.has('extrusion')) return false;
  return !sections.has('superQuadric') || warpsOf(program).every(isSmooth);
}

const isSmooth = ({ section, exponent }: ReturnType<typeof warpsOf>[number]): boolean =>
  section !== CREASED || exponent >= SMOOTH;

const warpsOf = (program: Program) =>
  program.steps
    .filter(({ take }) => take === TAKE.SUM)
    .map(({ at }) => SUM.read(viewOf(program, at), 0))
    .flatMap(({ first, end }) =>
      Array.from({ length: (ROW * (end - first)) / TERM.stride }, (_, i) =>
        TERM.read(viewOf(program, first + (i * TERM.stride) / ROW), 0),
      ),
    )
    .filter(({ warp }) => warp !== 0)
    .map(({ warp }) => WARP.read(viewOf(program, warp), 0));
