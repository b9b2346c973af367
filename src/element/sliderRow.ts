/** A slider with a name and its value: what a drag does is only shown until it ends, and is one undo step then. */
import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type { Command } from '../document/command/index.ts';
import type { Session } from './session.ts';
import { PART_WORDS } from './words.ts';

export interface SliderOptions {
  readonly name: string;
  /** of what, for those who do not see it */
  readonly of: string;
  /** null: several */
  readonly value: number | null;
  /** what is shown of a value */
  readonly text: (value: number) => string;
  readonly scale: Scale;
  readonly hint?: string;
  /** name, slider and value in one row: for short names */
  readonly inRow?: boolean;
  readonly command: (value: number) => Command;
}

/** From a value to a place from 0 to 100, and back. */
export interface Scale {
  readonly place: (value: number) => number;
  readonly value: (place: number) => number;
}

const round = (value: number, digits: number) => Number(value.toPrecision(digits));

export const even = (min: number, max: number, step: number): Scale => ({
  place: (value) => (100 * (value - min)) / (max - min),
  value: (place) => Number((step * Math.round((min + ((max - min) * place) / 100) / step)).toFixed(6)),
});

/** Equal ratios are equally far; 1 is met exactly where it lies in the middle. */
export const ratios = (min: number, max: number): Scale => ({
  place: (value) => (100 * Math.log(value / min)) / Math.log(max / min),
  value: (place) => round(min * (max / min) ** (place / 100), 2),
});

export const percent = (factor: number): string => `${Math.round(100 * factor)} %`;

export function sliderRow(session: Session, options: SliderOptions): TemplateResult {
  const { name, of, value, text, scale, hint, inRow = false, command } = options;
  const place = value === null ? 50 : Math.min(100, Math.max(0, scale.place(value)));
  const words = value === null ? PART_WORDS.mixed : text(value);
  const moved = (done: boolean) => (event: Event) =>
    session.tune(command(scale.value(Number((event.target as HTMLInputElement).value))), done);
  const end = html`<span class="value">${words}</span>`;
  return html`<div class=${inRow ? 'in-row' : ''}><h3 title=${hint ?? ''}>${name} ${inRow ? nothing : end}</h3>
    <div class="slide">
      <input type="range" min="0" max="100" step="any" aria-label="${name} of ${of}" aria-valuetext=${words} style="--fill: ${place}%"
        .value=${live(String(place))} @input=${moved(false)} @change=${moved(true)} @keydown=${(event: KeyboardEvent) => step(event)}
        @pointerdown=${() => session.holdSlider()} @blur=${() => session.holdSlider()} />
    </div>${inRow ? end : nothing}</div>`;
}

/** Arrow keys of a slider without steps would be too fine to see. */
function step(event: KeyboardEvent): void {
  const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[
    event.key
  ];
  if (by === undefined) return;
  event.preventDefault();
  event.stopPropagation();
  const slider = event.target as HTMLInputElement;
  slider.value = String(Number(slider.value) + 2 * by);
  slider.dispatchEvent(new Event('change'));
}
