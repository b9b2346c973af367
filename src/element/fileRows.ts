/** Rows that the panels of files share. */
import { html, nothing, type TemplateResult } from 'lit';
import { type IconName, icon } from './icons.ts';

interface RowOptions {
  readonly small?: string;
  readonly key?: string;
  readonly off?: boolean;
}

/** An icon, what it does, and in small letters what that means. */
export function row(
  image: IconName,
  name: string,
  run: () => void,
  { small, key, off }: RowOptions = {},
): TemplateResult {
  return html`<button class="row" aria-disabled=${off ? 'true' : nothing} @click=${() => off || run()}>
    ${icon(image, 20)}
    <span class="grow">${name}${small ? html`<small>${small}</small>` : nothing}</span>
    ${key ? html`<kbd>${key}</kbd>` : nothing}
  </button>`;
}

/** A fact with its sign: so, or not so. */
export const fact = (so: boolean, text: string): TemplateResult =>
  html`<p class="fact ${so ? 'so' : ''}">${icon(so ? 'done' : 'undone', 20)}<span>${text}</span></p>`;

/** Today by the clock, else by the calendar. */
export function when(time: number): string {
  const date = new Date(time);
  const today = date.toDateString() === new Date().toDateString();
  return today
    ? date.toLocaleTimeString([], { hour: '2-digit', minute: '2-digit' })
    : date.toLocaleDateString([], { day: 'numeric', month: 'short' });
}
