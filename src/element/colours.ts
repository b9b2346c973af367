/** The colours to choose from, as lit spheres, and one of one's own. */
import { html, type TemplateResult } from 'lit';
import { roving } from './controls.ts';
import { ball } from './icons.ts';
import { PART_WORDS } from './words.ts';

/** An illustrator's box: warm to cold, then earth, flesh and greys. */
const COLOURS: readonly (readonly [name: string, colour: string])[] = [
  ['Pear', '#d9cb4a'],
  ['Orange', '#e2893a'],
  ['Red', '#c8402f'],
  ['Rose', '#e08c98'],
  ['Violet', '#8a64ac'],
  ['Blue', '#4a7ab8'],
  ['Teal', '#3f9690'],
  ['Leaf', '#5f9e46'],
  ['Fir', '#3b6b3f'],
  ['Bark', '#7d5238'],
  ['Wood', '#b98a5a'],
  ['Sand', '#dcc397'],
  ['Skin', '#e8bd9e'],
  ['Sky', '#9cc4de'],
  ['Cream', '#f3ead6'],
  ['Stone', '#a5a29a'],
  ['Slate', '#5a6270'],
  ['Coal', '#3a3a3e'],
];

/** The heading names the chosen one of the box. `chosen` is null where several colours are in use; `first` is what the own colour starts from. */
export function spheres(
  label: string,
  chosen: string | null,
  first: string,
  set: (colour: string) => void,
): TemplateResult {
  const known = COLOURS.find(([, value]) => value === chosen);
  const own = (event: Event) => set((event.target as HTMLInputElement).value);
  const word = known?.[0] ?? (chosen === null ? PART_WORDS.mixed : '');
  return html`<div class="head"><h3>${PART_WORDS.colour} <span class="value">${word}</span></h3>
      <label class="own">Own <input type="color" .value=${first} aria-label="Own colour" @change=${own} /></label></div>
    <div class="spheres" role="radiogroup" aria-label=${label} @keydown=${roving}>
      ${COLOURS.map(
        ([name, value], i) =>
          html`<button role="radio" aria-label=${name} title=${name} aria-checked=${value === chosen} tabindex=${value === chosen || (!known && i === 0) ? 0 : -1}
            @click=${() => set(value)}>${ball('toon', value)}</button>`,
      )}
    </div>`;
}
