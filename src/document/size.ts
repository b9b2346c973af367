/** How much a document may hold: what the application lets one draw, it can save and read again. */
import type { Command } from './command/index.ts';
import type { Document } from './document.ts';
import { LIMITS } from './limits.ts';

/** In words, for messages about files. */
export const SIZE = `at most ${LIMITS.strokes} strokes and ${LIMITS.samplesInAll} samples in all`;

/** Commands after which a document can hold more than before. */
export const GROWING: readonly Command['type'][] = ['addStroke', 'duplicateParts', 'load'];

export function isTooLarge({ parts, draft }: Document): boolean {
  let strokes = 0;
  let samples = 0;
  for (const form of draft ? [...parts, draft] : parts) {
    strokes += form.strokes.length;
    for (const stroke of form.strokes) samples += stroke.samples.length;
  }
  return strokes > LIMITS.strokes || samples > LIMITS.samplesInAll;
}
