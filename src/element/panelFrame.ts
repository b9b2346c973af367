/** What all panels have in common: a titled card with a way out, and switches. */
import { html, type TemplateResult } from 'lit';
import { type Actions, iconButton } from './controls.ts';

export function frame(title: string, extra: string, actions: Actions, body: TemplateResult): TemplateResult {
  const close = () => actions.dismiss();
  return html`<div class="panel card chrome ${extra}" part="panel" role="dialog" tabindex="-1" aria-label=${title}>
    <header><h2>${title}</h2>${iconButton('x', 'Close', close)}</header>
    ${body}
  </div>`;
}

export const toggle = (name: string, on: boolean, set: (on: boolean) => void) =>
  html`<button class="row" role="switch" aria-checked=${on} @click=${() => set(!on)}>${name}<span class="switch"></span></button>`;
