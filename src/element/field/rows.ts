/** The controls of the panel: each shows one entry of the state's tables and sets it. */
import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { roving } from '../controls.ts';
import {
  CHOICES,
  type ChoiceKey,
  type ChoiceSpec,
  type FieldState,
  fromSlider,
  NUMBERS,
  type NumberKey,
  type NumberSpec,
  toSlider,
} from './fieldState.ts';
import { HELP } from './help.ts';

/** What the controls act on. */
export interface Desk {
  readonly state: FieldState;
  set(change: Partial<FieldState>): void;
}

/** steps of a slider under the arrow keys */
const STEPS = 200;

/** "0.04", "1 250", "−3" with its unit. */
function written({ unit }: NumberSpec, value: number): string {
  const text = Math.abs(value) >= 1e5 ? value.toExponential(1) : String(value);
  const number = text.replace('-', '−');
  return unit === '°' ? `${number}°` : unit ? `${number} ${unit}` : number;
}

/** The value is in the slider's own words; an output would be told anew at every step. */
export function slider(desk: Desk, key: NumberKey): TemplateResult {
  const of: NumberSpec = NUMBERS[key];
  const value = desk.state[key];
  const steps = of.step ? Math.round((of.max - of.min) / of.step) : STEPS;
  const place = Math.round(toSlider(of, value) * steps);
  const moved = (event: Event) =>
    desk.set({ [key]: fromSlider(of, Number((event.target as HTMLInputElement).value) / steps) });
  const reset = () => desk.set({ [key]: of.default });
  const pressed = (event: KeyboardEvent) => {
    if (event.key !== 'Delete' && event.key !== 'Backspace') return;
    event.preventDefault();
    reset();
  };
  return html`<div class="number">
    <label for=${key}>${of.label}</label><span class="value" aria-hidden="true">${written(of, value)}</span>
    <input id=${key} type="range" min="0" max=${steps} step="1" aria-valuetext=${written(of, value)}
      title="${HELP[key]}. Double-click or Delete: ${written(of, of.default)}" style="--fill:${(100 * place) / steps}%"
      .value=${live(String(place))} @input=${moved} @dblclick=${reset} @keydown=${pressed} />
  </div>`;
}

/** A few short words side by side. */
export function segment(desk: Desk, key: ChoiceKey, labelled = true): TemplateResult {
  const { label, options }: ChoiceSpec = CHOICES[key];
  return html`${labelled ? html`<h4>${label}</h4>` : nothing}
    <div class="segment" role="radiogroup" aria-label=${label} @keydown=${roving}>
      ${options.map(([id, name]) => radio(desk, key, id, html`${name}`))}
    </div>`;
}

/** Pictures with a word below, as many in a row as `columns`. */
export function tiles(
  desk: Desk,
  key: ChoiceKey,
  columns: number,
  picture: (id: string) => TemplateResult | typeof nothing,
  caption: (id: string, name: string) => string = (_, name) => name,
): TemplateResult {
  const { label, options }: ChoiceSpec = CHOICES[key];
  return html`<div class="tiles" style="--columns:${columns}" role="radiogroup" aria-label=${label} @keydown=${roving}>
    ${options.map(([id, name]) => radio(desk, key, id, html`${picture(id)}<span>${caption(id, name)}</span>`, name))}
  </div>`;
}

function radio(desk: Desk, key: ChoiceKey, id: string, body: TemplateResult, name?: string): TemplateResult {
  const chosen = desk.state[key] === id;
  return html`<button role="radio" aria-label=${name ?? nothing} title=${name ?? nothing} aria-checked=${chosen}
    tabindex=${chosen ? 0 : -1} @click=${() => desk.set({ [key]: id })}>${body}</button>`;
}

/** A list to pull down, for many words. */
export function select(
  label: string,
  id: string,
  value: string,
  options: readonly (readonly [id: string, name: string])[],
  set: (value: string) => void,
): TemplateResult {
  return html`<div class="pull">
    <label for=${id}>${label}</label>
    <select id=${id} @change=${(event: Event) => set((event.target as HTMLSelectElement).value)}>
      ${options.map(([option, name]) => html`<option value=${option} .selected=${option === value}>${name}</option>`)}
    </select>
  </div>`;
}
