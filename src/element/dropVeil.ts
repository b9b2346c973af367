/** Over everything while files hang there: what letting go would do. */
import { html, type TemplateResult } from 'lit';
import { FILE_WORDS } from './words.ts';

export const dropVeil = (): TemplateResult =>
  html`<div class="veil"><div><b>${FILE_WORDS.drop}</b><span>${FILE_WORDS.dropHint}</span></div></div>`;
