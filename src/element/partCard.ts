/** What can be set of the selected parts: name, colour, radius. What is set of several is set of all. */
import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { countsOfPart } from '../document/bodyCounts.ts';
import { CLAY, solidOf } from '../document/build.ts';
import { LONGEST_NAME } from '../document/command/renamePart.ts';
import { colourOf, isImplicit, type Part, RADIUS_RANGE, type SurfacePart } from '../document/document.ts';
import { colourName, spheres } from './colours.ts';
import { radiusToSlider, sliderToRadius } from './controls.ts';
import { flawsOf } from './flaws.ts';
import type { Session } from './session.ts';
import { PART_WORDS, SURFACE } from './words.ts';

/** As shown: with what a control that is being dragged does. */
export function chosenParts(session: Session): Part[] {
  if (session.selection.length === 0) return [];
  return session.shown().parts.filter(({ id }) => session.selection.includes(id));
}

export const partsName = (parts: readonly Part[]): string =>
  parts.length === 1 ? parts[0]!.name : PART_WORDS.several(parts.length);

export function partCard(session: Session): TemplateResult {
  const parts = chosenParts(session);
  const only = parts.length === 1 ? parts[0]! : null;
  if (parts.length === 0) return html`<section><p class="quiet-words">${PART_WORDS.choose}</p></section>`;
  return html`<section class="card-of-part">
    ${only ? nameField(session, only) : html`<h3>${partsName(parts)}</h3>`}
    <h3>${PART_WORDS.colour} <span class="value">${colourWords(parts)}</span></h3>
    ${partColours(session)} ${radius(session, parts)}
    ${only ? html`<p class="quiet-words">${facts(only)}</p>` : nothing}
    ${only ? flaws(session, only) : nothing}
  </section>`;
}

const sameColour = (parts: readonly Part[]): string | null => {
  const colour = parts[0] ? colourOf(parts[0]) : null;
  return parts.every((part) => colourOf(part) === colour) ? colour : null;
};

function colourWords(parts: readonly Part[]): string {
  const colour = sameColour(parts);
  return colour === null ? PART_WORDS.mixed : colourName(colour);
}

/** For the panel, and for the palette while parts are selected. */
export function partColours(session: Session): TemplateResult {
  const parts = chosenParts(session);
  const set = (colour: string) =>
    session.run({ type: 'setPartBrush', ids: session.selection, change: { colour } });
  const first = (parts[0] && colourOf(parts[0])) ?? CLAY;
  return spheres(PART_WORDS.colourOf(partsName(parts)), sameColour(parts), first, set);
}

/** Enter or leaving the field renames, Escape brings the old name back. */
function nameField(session: Session, { id, name }: Part): TemplateResult {
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
  if (tubes.length < parts.length) return nothing;
  const mm = tubes[0]!.brush.radius;
  const same = tubes.every(({ brush }) => brush.radius === mm);
  const position = radiusToSlider(mm);
  const moved = (done: boolean) => (event: Event) => {
    const value = sliderToRadius(Number((event.target as HTMLInputElement).value));
    session.tune({ type: 'setPartBrush', ids: session.selection, change: { radius: value } }, done);
  };
  return html`<h3>${PART_WORDS.radius} <span class="value">${same ? `${mm} mm` : PART_WORDS.mixed}</span></h3>
    <div class="slide">
      <input type="range" min="0" max="100" step="1" aria-label="Radius of ${partsName(parts)}"
        aria-valuetext="${mm} mm, from ${RADIUS_RANGE.min} to ${RADIUS_RANGE.max}" style="--fill: ${position}%"
        .value=${live(String(position))} @input=${moved(false)} @change=${moved(true)}
        @pointerdown=${() => session.holdSlider()} @blur=${() => session.holdSlider()} />
    </div>`;
}

/** "2 strokes", "12 skels" */
export function madeOf(part: Part): string {
  return isImplicit(part)
    ? PART_WORDS.skels(countsOfPart(part).skels)
    : PART_WORDS.strokes(part.strokes.length);
}

/** What is not seen of it. */
const flaws = ({ bodies }: Session, part: Part): TemplateResult[] =>
  flawsOf(part, (node) => bodies.problem(node)).map(({ words }) => html`<p class="quiet-words">${words}</p>`);

function facts(part: Part): string {
  const triangles = (solidOf(part)?.mesh.indices.length ?? 0) / 3;
  return [SURFACE[part.kind].long, madeOf(part), PART_WORDS.triangles(triangles)].join(' · ');
}
