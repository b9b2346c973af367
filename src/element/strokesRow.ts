/** The strokes of a form in hand again, by the numbers they have on the picture: each can go. What then lies over nothing is said. */
import { html, nothing, type TemplateResult } from 'lit';
import type { Command } from '../document/command/index.ts';
import { type Brush, type Document, type Draft, formOfDraft, readingOf } from '../document/document.ts';
import { idleRedrawsOf } from '../document/sheets.ts';
import {
  type OfSection,
  type Section,
  type SectionStroke,
  strokesOfSections,
} from '../document/surfacePart.ts';
import type { SurfaceKind } from '../surface/index.ts';
import { icon } from './icons.ts';
import type { Session } from './session.ts';
import { lightStroke } from './strokeLight.ts';
import { EDIT_WORDS, SURFACE_WORDS } from './words.ts';

export interface Removal {
  /** the stroke's, on the picture */
  readonly number: number;
  readonly what: 'side' | OfSection['as'];
  /** of its section, along the sides; null: a side */
  readonly u: number | null;
  readonly command: Command;
}

/** The last construction curve stays. */
export function removals({ draft }: Document): readonly Removal[] {
  const { strokes = [], sections = [] } = draft ?? {};
  const sides = strokes.map(
    (_, index): Removal => ({
      number: index + 1,
      what: 'side',
      u: null,
      command: { type: 'setStroke', index, stroke: null },
    }),
  );
  const ofSections = strokesOfSections(sections).map((of, i): Removal => {
    const section = sections[of.section]!;
    return { number: strokes.length + i + 1, what: of.as, u: section.u, command: removalOf(of, section) };
  });
  return [...(strokes.length > 1 ? sides : []), ...ofSections];
}

/** A section without its front, or without all it has, is none. */
function removalOf({ section: index, as, drawn }: OfSection, section: Section): Command {
  const { front, back, redraws } = section;
  const whole = { type: 'removeSection', index } as const;
  const isAll = [front, back, ...redraws].filter((one) => one !== null).length === 1;
  if (as === 'front' || isAll) return whole;
  if (as === 'back') return { ...whole, only: as };
  return { ...whole, only: as, redraw: redraws.findIndex(({ stroke }) => stroke === drawn.stroke) };
}

/** Numbers of what was drawn over parts of sections that went since: nothing comes of it until they are there again. */
export function idleNumbers(document: Document): readonly number[] {
  const { draft, brush } = document;
  const kind = readingOf(document);
  if (!draft || !kind || kind === 'solid') return [];
  const old = known.get(draft);
  if (old?.brush === brush && old.kind === kind) return old.numbers;
  const numbers = idleIn(draft, brush, kind);
  known.set(draft, { brush, kind, numbers });
  return numbers;
}

/** Controls are drawn far more often than strokes change; twenty redrawings take a frame. */
const known = new WeakMap<
  Draft,
  { readonly brush: Brush; readonly kind: SurfaceKind; readonly numbers: readonly number[] }
>();

function idleIn(draft: Draft, brush: Brush, kind: SurfaceKind): readonly number[] {
  const form = formOfDraft(draft);
  const idle: readonly SectionStroke[] = idleRedrawsOf(kind, form, brush);
  return strokesOfSections(form.sections).flatMap(({ drawn }, i) =>
    idle.includes(drawn) ? [form.strokes.length + i + 1] : [],
  );
}

export const hasStrokesRow = (document: Document): boolean =>
  document.draft?.recreates !== undefined && readingOf(document) !== 'solid' && removals(document).length > 0;

export function strokesRow(session: Session): TemplateResult | typeof nothing {
  const { document } = session;
  if (!hasStrokesRow(document)) return nothing;
  const idle = idleNumbers(document);
  return html`<div class="joins strokes" role="group" aria-label=${EDIT_WORDS.strokes}>
    ${removals(document).map(({ number, what, u, command }) => {
      const place = u === null ? '' : ` ${SURFACE_WORDS.at(Math.round(100 * u))}`;
      const words = EDIT_WORDS.removeStroke(number, what) + place;
      const title = idle.includes(number) ? EDIT_WORDS.overNothing([number]) : words;
      const light = () => lightStroke(session, number);
      const out = () => lightStroke(session, null);
      return html`<button class="b" aria-label=${words} title=${title}
        @pointerenter=${light} @pointerleave=${out} @focus=${light} @blur=${out}
        @click=${() => removeStroke(session, command)}>${number}${icon('x', 20)}</button>`;
    })}
  </div>`;
}

/** One undo step. */
export function removeStroke(session: Session, command: Command): void {
  const before = idleNumbers(session.document).length;
  session.run(command);
  const idle = idleNumbers(session.document);
  if (idle.length <= before) return;
  session.said = EDIT_WORDS.overNothing(idle);
  session.update();
}
