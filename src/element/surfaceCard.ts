/** What makes a surface more specific, in its card: sections, the back, how they go over into each other, and bends. */
import { html, nothing, type TemplateResult } from 'lit';
import type { SurfacePart } from '../document/document.ts';
import { outlinesOfPart } from '../document/sheets.ts';
import { BETWEENS, type Bend, kindOfStrokes } from '../document/surfacePart.ts';
import { backChoices } from './acrossCard.ts';
import { editBend } from './bending.ts';
import { iconButton } from './controls.ts';
import { detailRows } from './detailRows.ts';
import { segment } from './editSegment.ts';
import { icon } from './icons.ts';
import { outlinePicture } from './outlinePicture.ts';
import { toggle } from './panelFrame.ts';
import { recreatePart } from './recreating.ts';
import type { Session } from './session.ts';
import { isMeshShown, lightSection, litSection, showMesh } from './surfaceMarks.ts';
import { SECTION_WORDS, SURFACE_WORDS } from './words.ts';

/** Of the surfaces that are selected; lists of sections and bends only of one. */
export function surfaceCard(session: Session, parts: readonly SurfacePart[]): TemplateResult {
  const only = parts.length === 1 ? parts[0]! : null;
  const across = parts.filter(({ kind }) => kind === 'crossSection' || kind === 'bspline');
  const patches = parts.filter(({ kind }) => kind === 'bspline');
  return html`${only ? sections(session, only) : nothing}
    ${across.length === parts.length ? backs(session, across) : nothing}
    ${patches.length === parts.length ? betweens(session, patches) : nothing}
    ${only ? bends(session, only) : nothing}
    ${detailRows(session, parts, only ? controlMesh(session) : nothing)}`;
}

const controlMesh = (session: Session): TemplateResult =>
  toggle(SURFACE_WORDS.mesh, isMeshShown(session), (on) => showMesh(session, on), {
    title: SURFACE_WORDS.meshHint,
  });

/** Kept ones of a surface that one stepped back from count, too. */
function sections(session: Session, part: SurfacePart): TemplateResult | typeof nothing {
  const { sections: own, strokes, kind } = part;
  if (own.length === 0 && strokes.length < 2) return nothing;
  const outlines = outlinesOfPart(own.length > 0 ? kindOfStrokes(part) : kind, part, part.brush);
  const lit = litSection(session, part);
  const remove = (index: number) => {
    lightSection(session, part, null);
    session.run({ type: 'removeSection', part: part.id, index });
  };
  return html`<h3>${SURFACE_WORDS.sections} <span class="value">${own.length}</span></h3>
    <div class="tiles" role="group" aria-label=${SURFACE_WORDS.sectionsOf(part.name)}>
      ${own.map(({ u }, i) => {
        const at = SURFACE_WORDS.at(Math.round(100 * u));
        const outline = outlines.find((placed) => placed.u === u)?.outline;
        return html`<div class="tile">
          <button class="pick" aria-pressed=${lit === i} aria-label=${SURFACE_WORDS.light(at)} @click=${() => lightSection(session, part, i)}>
            ${outline ? outlinePicture(outline) : icon('section')}<span>${at}</span></button>
          ${iconButton('x', SURFACE_WORDS.removeSection(at), () => remove(i), { class: 'off' })}
        </div>`;
      })}
      ${strokes.length === 2 ? html`<button class="tile add" @click=${() => drawSection(session, part)}>${icon('plus')}<span>${SURFACE_WORDS.draw}</span></button>` : nothing}
    </div>`;
}

/** With its strokes in hand again, and seen as they were drawn. */
function drawSection(session: Session, { id }: SurfacePart): void {
  if (recreatePart(session, id)) session.setTool('section');
}

function backs(session: Session, parts: readonly SurfacePart[]): TemplateResult {
  const ids = parts.map(({ id }) => id);
  const choices = backChoices(same(parts.map(({ back }) => back)), (back) =>
    session.run({ type: 'setSurface', ids, change: { back } }),
  );
  return html`<h3>${SECTION_WORDS.back}</h3>${segment(SECTION_WORDS.back, choices)}`;
}

function betweens(session: Session, parts: readonly SurfacePart[]): TemplateResult {
  const now = same(parts.map(({ between }) => between));
  const ids = parts.map(({ id }) => id);
  const choices = BETWEENS.map((between) => ({
    ...SURFACE_WORDS.betweens[between],
    on: between === now,
    run: () => session.run({ type: 'setSurface', ids, change: { between } }),
  }));
  return html`<div class="in-row"><h3>${SURFACE_WORDS.shortBetween}</h3>${segment(SURFACE_WORDS.between, choices)}</div>`;
}

/** What all have; null where they differ. */
function same<T>(values: readonly T[]): T | null {
  const [first] = values;
  return first !== undefined && values.every((value) => value === first) ? first : null;
}

function bends(session: Session, part: SurfacePart): TemplateResult | typeof nothing {
  if (part.bends.length === 0) return nothing;
  return html`<ul class="bends" aria-label=${SURFACE_WORDS.bends}>${part.bends.map((bend, index) => bendRow(session, part, bend, index))}</ul>`;
}

function bendRow(session: Session, { id, name }: SurfacePart, bend: Bend, index: number): TemplateResult {
  const { keepsLength, isOff } = bend;
  const word = SURFACE_WORDS.bend(index + 1);
  const set = (change: Partial<Bend> | null) => session.run({ type: 'setBend', id, index, change });
  const eye = isOff ? SURFACE_WORDS.bendOn(word) : SURFACE_WORDS.bendOff(word);
  return html`<li class=${isOff ? 'unseen' : ''}>
    <b>${word}</b>
    <button class="b toggle length" aria-pressed=${keepsLength} title=${SURFACE_WORDS.lengthHint} aria-label="${SURFACE_WORDS.lengthKept}, ${word} of ${name}"
      @click=${() => set({ keepsLength: !keepsLength })}>${SURFACE_WORDS.lengthKept}</button>
    ${iconButton(isOff ? 'eyeOff' : 'eye', eye, () => set({ isOff: !isOff }))}
    ${iconButton('redraw', SURFACE_WORDS.redrawBend(word), () => editBend(session, id, index))}
    ${iconButton('x', SURFACE_WORDS.remove(word), () => set(null))}
  </li>`;
}
