/** The strokes of a form in hand again, by the numbers they have on the picture: each can go. */
import { html, nothing, type TemplateResult } from 'lit';
import type { Command } from '../document/command/index.ts';
import { type Document, readingOf } from '../document/document.ts';
import { icon } from './icons.ts';
import type { Session } from './session.ts';
import { EDIT_WORDS } from './words.ts';

/** Construction curves, then sections; the last curve stays. */
export function removals({ draft }: Document): readonly Command[] {
  const { strokes = [], sections = [] } = draft ?? {};
  const curves =
    strokes.length > 1
      ? strokes.map((_, index): Command => ({ type: 'setStroke', index, stroke: null }))
      : [];
  return [...curves, ...sections.map((_, index): Command => ({ type: 'removeSection', index }))];
}

export const hasStrokesRow = (document: Document): boolean =>
  document.draft?.recreates !== undefined && readingOf(document) !== 'solid' && removals(document).length > 0;

export function strokesRow(session: Session): TemplateResult | typeof nothing {
  const { document } = session;
  if (!hasStrokesRow(document)) return nothing;
  const first = document.draft!.strokes.length > 1 ? 1 : 2;
  return html`<div class="joins strokes" role="group" aria-label=${EDIT_WORDS.strokes}>
    ${removals(document).map(
      (
        command,
        i,
      ) => html`<button class="b" aria-label=${EDIT_WORDS.removeStroke(first + i)} title=${EDIT_WORDS.removeStroke(first + i)}
        @click=${() => session.run(command)}>${first + i}${icon('x', 20)}</button>`,
    )}
  </div>`;
}
