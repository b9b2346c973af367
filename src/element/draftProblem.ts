/** Why no part can be made of the unfinished form, in a word or two; null when one can. */
import { draftIsWhole, draftSolids } from '../document/build.ts';
import { type Document, readingOf } from '../document/document.ts';
import { SILHOUETTE_WORDS, WORDS } from './words.ts';

export function draftProblem(document: Document): string | null {
  if (draftIsWhole(document)) return null;
  if (readingOf(document) === 'solid') return SILHOUETTE_WORDS.nothing;
  try {
    const empty = draftSolids(document).some(({ mesh }) => mesh.indices.length === 0);
    return empty && readingOf(document) === 'rotational' ? WORDS.encloses : WORDS.tooShortForTube;
  } catch {
    return WORDS.notBuilt;
  }
}
