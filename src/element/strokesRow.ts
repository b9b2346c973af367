/** The strokes of a form in hand again, by the numbers they have on the picture: each can go. */
import { html, nothing, type TemplateResult } from 'lit';
import type { Command } from '../document/command/index.ts';
import { type Document, readingOf } from '../document/document.ts';
import { type OfSection, type Section, strokesOfSections } from '../document/surfacePart.ts';
import { icon } from './icons.ts';
import type { Session } from './session.ts';
import { EDIT_WORDS } from './words.ts';

export interface Removal {
  /** the stroke's, on the picture */
  readonly number: number;
  readonly what: 'side' | OfSection['as'];
  readonly command: Command;
}

/** The last construction curve stays; what was drawn over a section goes from the last one on. */
export function removals({ draft }: Document): readonly Removal[] {
  const { strokes = [], sections = [] } = draft ?? {};
  const sides = strokes.map(
    (_, index): Removal => ({
      number: index + 1,
      what: 'side',
      command: { type: 'setStroke', index, stroke: null },
    }),
  );
  const ofSections = strokesOfSections(sections).flatMap((of, i): readonly Removal[] => {
    const command = removalOf(of, sections[of.section]!);
    return command ? [{ number: strokes.length + i + 1, what: of.as, command }] : [];
  });
  return [...(strokes.length > 1 ? sides : []), ...ofSections];
}

/** A section without its front, or without all it has, is none. */
function removalOf({ section: index, as, drawn }: OfSection, section: Section): Command | null {
  const { front, back, redraws } = section;
  const whole: Command = { type: 'removeSection', index };
  if (as === 'redraw' && drawn !== redraws.at(-1)) return null;
  const isAll = [front, back, ...redraws].filter((one) => one !== null).length === 1;
  return as === 'front' || isAll ? whole : { ...whole, only: as };
}

export const hasStrokesRow = (document: Document): boolean =>
  document.draft?.recreates !== undefined && readingOf(document) !== 'solid' && removals(document).length > 0;

export function strokesRow(session: Session): TemplateResult | typeof nothing {
  const { document } = session;
  if (!hasStrokesRow(document)) return nothing;
  return html`<div class="joins strokes" role="group" aria-label=${EDIT_WORDS.strokes}>
    ${removals(document).map(({ number, what, command }) => {
      const words = EDIT_WORDS.removeStroke(number, what);
      return html`<button class="b" aria-label=${words} title=${words}
        @click=${() => session.run(command)}>${number}${icon('x', 20)}</button>`;
    })}
  </div>`;
}
