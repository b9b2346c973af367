/** The status line: what the last form is and how finely it is cut, and whether the picture is a mesh or exact, and of what. */
import { bodyMade } from '../document/bodies.ts';
import { RESOLUTION } from '../document/build.ts';
import { isImplicit, isSurface, readingOf } from '../document/document.ts';
import { nodeOf } from '../document/solidNode.ts';
import { sizeOf } from './detailRows.ts';
import { shortName } from './draftWords.ts';
import { raysWords } from './exactWords.ts';
import type { Session } from './session.ts';
import { SURFACE, WORDS } from './words.ts';

/** What is being made, or what is seen; '' where there is nothing to be seen. */
export function seenWords({ bodyWork, look, looks, scene, exact, frames }: Session): string {
  const { words } = bodyWork;
  if (words) return words;
  if (look.mode === 'exact' && looks.hasBodies && scene) return raysWords(exact);
  return frames.triangles > 0 ? WORDS.mesh(frames.triangles) : '';
}

/** Of the last form. */
export function detailWords({ document, frames }: Session): string {
  const last = document.parts.at(-1);
  const kind = readingOf(document) ?? last?.kind;
  if (!kind) return '';
  const body = last && isImplicit(last) ? bodyMade(nodeOf(last)) : null;
  const surface = last && !document.draft && isSurface(last) ? last : null;
  const grid = surface ? sizeOf(surface) : `${RESOLUTION.u} × ${RESOLUTION.v}`;
  const mesh = kind !== 'body' && kind !== 'solid' ? `${grid} mesh` : body ? `${body.cells} cells` : '';
  const time = frames.buildTime;
  const took = time > 0 ? `${Math.max(1, Math.round(time))} ms` : '';
  const name = document.draft ? shortName(document) : SURFACE[kind].name;
  return [name, mesh, took].filter(Boolean).join(' · ');
}
