/** How much a document may hold: what the application lets one draw, it can save and read again. */
import type { Command } from './command/index.ts';
import { type Document, formOfDraft, isBody, isSolid, strokesOf } from './document.ts';
import { LIMITS } from './limits.ts';
import { groupsOf } from './solid.ts';
import { strokesOfForm } from './surfacePart.ts';

/** In words, for messages about files. */
export const SIZE = `at most ${LIMITS.strokes} strokes and bodies and ${LIMITS.samplesInAll} samples and values of bodies and solids in all`;

/** Commands after which a document can hold more than before. */
export const GROWING: readonly Command['type'][] = [
  'addStroke',
  'addBody',
  'setBody',
  'paste',
  'setGroups',
  'editSkeleton',
  'duplicateParts',
  'addSection',
  'redrawSection',
  'setStroke',
  'bend',
  'setBend',
  'recreate',
  'load',
];

/** A value of a body takes no more of a file than a sample does. */
export function isTooLarge({ parts, draft }: Document): boolean {
  let forms = 0;
  let samples = 0;
  for (const strokes of [...parts.map(strokesOf), draft ? strokesOfForm(formOfDraft(draft)) : []]) {
    forms += strokes.length;
    for (const stroke of strokes) samples += stroke.samples.length;
  }
  for (const { skeleton, shape } of parts.filter(isSolid).flatMap(groupsOf))
    samples += valuesOf(shape) + (skeleton ? valuesOf(skeleton) : 0);
  for (const { node } of parts.filter(isBody)) {
    forms++;
    samples += valuesOf(node);
  }
  return forms > LIMITS.strokes || samples > LIMITS.samplesInAll;
}

const sizes = new WeakMap<object, number>();

/** Numbers, words and lists of a tree. */
function valuesOf(node: object): number {
  const known = sizes.get(node);
  if (known !== undefined) return known;
  let values = 0;
  const waiting: unknown[] = [node];
  while (waiting.length > 0) {
    const value = waiting.pop();
    values++;
    if (typeof value === 'object' && value !== null)
      for (const item of Object.values(value)) waiting.push(item);
  }
  sizes.set(node, values);
  return values;
}
