/** Line 1: the last event, spoken politely. Line 2: mesh or exact, with what there is of it; where there is room the last form; and the back end, everywhere when it is not the usual one. */
import { html, nothing, type TemplateResult } from 'lit';
import type { Session } from './session.ts';
import { detailWords } from './statusWords.ts';
import { WORDS } from './words.ts';

export function status(session: Session): TemplateResult {
  const backend = session.scene?.backend;
  const slow = backend === 'WebGL2' ? 'WebGL2, slower' : backend;
  const { seen } = session;
  const detail = detailWords(session);
  const draws = slow ?? (session.noPicture ? WORDS.noPicture : WORDS.loading);
  return html`<div class="status chrome" part="status">
    ${session.hint ? html`<span aria-hidden="true"><b>${session.hint}</b></span>` : nothing}
    <span role="status" aria-live="polite" class=${session.hint ? 'hidden' : ''}><b>${session.said}</b></span>
    <span class="hidden hint-said" aria-live="polite">${session.hintAtRest}</span>
    <span><i class="dot ${backend === 'WebGPU' ? '' : 'slow'}"></i><span class="seen">${unbroken(seen)}</span><span class="aside ${backend === 'WebGPU' ? 'usual' : ''}"><span class="gap">${seen && ' · '}</span><span class="facts">${unbroken(detail)}${detail && ' · '}</span>${draws}</span></span>
  </div>`;
}

/** Lines end between facts, not within one. */
const unbroken = (facts: string) =>
  facts.split(' · ').map((fact, i) => html`${i > 0 ? ' · ' : ''}<span class="fact">${fact}</span>`);
