/** Which trees rays on the device know bounds for; the others are the CPU's (field/raycast.ts). */
import type { FieldNode } from '../../field/node.ts';
import { shapes } from '../../shape/index.ts';
import { isCulledOnDevice } from '../bricks/cullsOnDevice.ts';
import { namesOf } from '../ingredients.ts';
import { type Program, programOf } from '../program.ts';

/** FieldError for what has no field. */
export const castsOnDevice = (node: FieldNode): boolean => isCastOnDevice(programOf(node));

/** Maps of cross sections, and shapes whose values are no distances, say nothing of what is ahead. */
export const isCastOnDevice = (program: Program): boolean =>
  isCulledOnDevice(program) &&
  program.ingredients.sections.size === 0 &&
  namesOf(program.ingredients, 'shapes').every((name) => shapes[name].exact);
