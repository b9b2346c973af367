/** What can be set of the selected parts: name, colour, radius. What is set of several is set of all. */
import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { CLAY, solidOf } from '../document/build.ts';
import { itemsOf, nameOf } from '../document/command/changeParts.ts';
import { LONGEST_NAME } from '../document/command/renamePart.ts';
import { isSolid, isSurface, type Part, RADIUS_RANGE, type SurfacePart } from '../document/document.ts';
import { chosenColour, chosenParts, coloursOf } from './chosenParts.ts';
import { spheres } from './colours.ts';
import { radiusToSlider, sliderToRadius } from './controls.ts';
import { partFinish } from './finishCard.ts';
import { flawsOf } from './flaws.ts';
import { groupCard } from './groupCard.ts';
import { icon } from './icons.ts';
import { madeOf } from './partRows.ts';
import { drawRadius, isDrawingRadius } from './radiusDrawing.ts';
import type { Session } from './session.ts';
import { surfaceCard } from './surfaceCard.ts';
import { PART_WORDS, SIZE_WORDS, SURFACE } from './words.ts';

export function partCard(session: Session): TemplateResult {
  const parts = chosenParts(session);
  const chosen = itemsOf(session.shown()).filter(({ id }) => session.selection.includes(id));
  const only = chosen.length === 1 ? parts[0] : undefined;
  if (chosen.length === 0) return html`<section><p class="quiet-words">${PART_WORDS.choose}</p></section>`;
  return html`<section class="card-of-part">
    ${chosen.length === 1 ? nameField(session, chosen[0]!) : html`<h3>${PART_WORDS.several(chosen.length)}</h3>`}
    ${partColours(session)} ${partFinish(session, true)} ${radius(session, parts)}
    ${parts.length === chosen.length && parts.every(isSurface) ? surfaceCard(session, parts) : nothing}
    ${parts.every(isSolid) ? groupCard(session) : nothing}
    ${only && !isSurface(only) ? html`<p class="quiet-words">${facts(only)}</p>` : nothing}
    ${only ? flaws(session, only) : nothing}
  </section>`;
}

/** For the panel, and for the palette while parts are selected. */
export function partColours(session: Session): TemplateResult {
  const name = nameOf(session.document, session.selection);
  const set = (colour: string) =>
    session.run({ type: 'setPartBrush', ids: session.selection, change: { colour } });
  const [first] = coloursOf(session, chosenParts(session));
  return spheres(PART_WORDS.colourOf(name), chosenColour(session), first ?? CLAY, set);
}

/** Enter or leaving the field renames, Escape brings the old name back. */
function nameField(session: Session, { id, name }: Pick<Part, 'id' | 'name'>): TemplateResult {
  const rename = (event: Event) => {
    const field = event.target as HTMLInputElement;
    const wanted = field.value.trim();
    if (wanted && wanted !== name) session.run({ type: 'renamePart', id, name: wanted });
    else field.value = name;
  };
  const key = (event: KeyboardEvent) => {
    const field = event.target as HTMLInputElement;
    if (event.key !== 'Enter' && event.key !== 'Escape') return;
    event.stopPropagation();
    if (event.key === 'Escape') field.value = name;
    // The field lets go, and the keys stay in the panel.
    field.closest('.panel')?.querySelector<HTMLElement>('.part-list')?.focus({ preventScroll: true });
  };
  // Not `live`: an update in the middle of a word would take back what was typed.
  return html`<label class="name-field"><span>${PART_WORDS.name}</span>
    <input type="text" maxlength=${LONGEST_NAME} autocomplete="off" spellcheck="false" enterkeyhint="done"
      .value=${name} @change=${rename} @keydown=${key} /></label>`;
}

/** Tubes alone have one. */
function radius(session: Session, parts: readonly Part[]): TemplateResult | typeof nothing {
  const tubes = parts.filter((part): part is SurfacePart => part.kind === 'tube');
  if (tubes.length === 0 || tubes.length < parts.length || parts.length < session.selection.length)
    return nothing;
  const mm = tubes[0]!.brush.radius;
  const same = tubes.every(({ brush }) => brush.radius === mm);
  const position = radiusToSlider(mm);
  const moved = (done: boolean) => (event: Event) => {
    const value = sliderToRadius(Number((event.target as HTMLInputElement).value));
    session.tune({ type: 'setPartBrush', ids: session.selection, change: { radius: value } }, done);
  };
  const ids = session.selection;
  const draw = () =>
    drawRadius(session, (drawn) => ({ type: 'setPartBrush', ids, change: { radius: drawn } }));
  return html`<h3>${PART_WORDS.radius} <span class="value">${same ? `${mm} mm` : PART_WORDS.mixed}</span></h3>
    <div class="slide">
      <input type="range" min="0" max="100" step="1" aria-label="Radius of ${nameOf(session.document, session.selection)}"
        aria-valuetext="${mm} mm, from ${RADIUS_RANGE.min} to ${RADIUS_RANGE.max}" style="--fill: ${position}%"
        .value=${live(String(position))} @input=${moved(false)} @change=${moved(true)}
        @pointerdown=${() => session.holdSlider()} @blur=${() => session.holdSlider()} />
    </div>
    <button class="row" title=${SIZE_WORDS.hint} aria-pressed=${isDrawingRadius(session)} @click=${draw}>${SIZE_WORDS.draw}<span class="grow"></span>${icon('draw', 20)}</button>`;
}

const flaws = ({ bodies }: Session, part: Part): TemplateResult[] =>
  flawsOf(part, (node) => bodies.problem(node)).map(({ words }) => html`<p class="quiet-words">${words}</p>`);

function facts(part: Part): string {
  const triangles = (solidOf(part)?.mesh.indices.length ?? 0) / 3;
  return [SURFACE[part.kind].long, madeOf(part), PART_WORDS.triangles(triangles)].join(' · ');
}
