/** One of a few, side by side, as the cards of tools have it. */
import { html, type TemplateResult } from 'lit';
import { roving } from './controls.ts';

export interface SegmentChoice {
  readonly name: string;
  readonly hint: string;
  readonly on: boolean;
  run(): void;
}

export const segment = (label: string, choices: readonly SegmentChoice[]): TemplateResult =>
  html`<div class="segment" role="radiogroup" aria-label=${label} @keydown=${roving}>
    ${choices.map(
      ({ name, hint, on, run }) =>
        html`<button role="radio" aria-checked=${on} tabindex=${on ? 0 : -1} title="${label}: ${hint}" @click=${() => on || run()}>${name}</button>`,
    )}
  </div>`;
