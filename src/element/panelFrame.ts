/** What all panels have in common: a titled card with a way out, and switches. */
import { html, nothing, type TemplateResult } from 'lit';
import { type Actions, iconButton } from './controls.ts';

export function frame(title: string, extra: string, actions: Actions, body: TemplateResult): TemplateResult {
  const close = () => actions.dismiss();
  return html`<div class="panel card chrome ${extra}" part="panel" role="dialog" tabindex="-1" aria-label=${title}>
    <header><h2>${title}</h2>${iconButton('x', 'Close', close)}</header>
    ${body}
  </div>`;
}

interface ToggleOptions {
  /** why it cannot be set now */
  readonly off?: string | null;
  readonly title?: string;
}

export const toggle = (
  name: string,
  on: boolean,
  set: (on: boolean) => void,
  { off = null, title }: ToggleOptions = {},
) =>
  html`<button class="row" role="switch" aria-checked=${on && off === null} aria-disabled=${off === null ? nothing : 'true'}
    title=${off ?? title ?? nothing} @click=${() => set(!on)}>${name}<span class="switch"></span></button>`;
