/** One of a few, side by side: of tools, and in cards. */
import { html, nothing, type TemplateResult } from 'lit';
import { roving } from './controls.ts';
import { type IconName, icon } from './icons.ts';

export interface SegmentChoice {
  readonly name: string;
  readonly hint: string;
  readonly on: boolean;
  readonly image?: IconName;
  run(): void;
}

/** Where none is on, as of parts that differ, the first one can be reached. */
export function segment(label: string, choices: readonly SegmentChoice[]): TemplateResult {
  const reached = Math.max(
    0,
    choices.findIndex(({ on }) => on),
  );
  const isPictured = choices.some(({ image }) => image);
  return html`<div class="segment ${isPictured ? 'pictured' : ''}" role="radiogroup" aria-label=${label} @keydown=${roving}>
    ${choices.map(
      ({ name, hint, on, image, run }, i) =>
        html`<button role="radio" aria-checked=${on} tabindex=${i === reached ? 0 : -1} title="${label}: ${hint}" @click=${() => on || run()}>${image ? icon(image, 20) : nothing}<span>${name}</span></button>`,
    )}
  </div>`;
}
