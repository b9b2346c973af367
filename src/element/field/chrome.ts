/** What floats around the picture of the field page: top bar, dock with its notice, status line. */
import { html, nothing, type TemplateResult } from 'lit';
import { guard } from 'lit/directives/guard.js';
import { iconButton, roving } from '../controls.ts';
import { ball, icon, wordmark } from '../icons.ts';
import { WORDS } from '../words.ts';
import type { FieldBody } from './fieldBody.ts';
import { CHOICES } from './fieldState.ts';
import { FIELD_WORDS } from './fieldWords.ts';
import { controls } from './panel.ts';
import type { Desk } from './rows.ts';

export interface Page extends Desk {
  readonly body: FieldBody;
  readonly dataset: DOMStringMap;
  readonly folded: boolean;
  /** a passing word of the status line */
  readonly said: string;
  /** what they do, in words */
  readonly rays: string;
  fold(): void;
  showAll(): void;
  close(): void;
  /** in words; null: there is none, or it was closed */
  readonly problem: string | null;
  reset(): void;
  copy(): Promise<void>;
}

/** colour of the styles' lit balls */
const BALL = '#dd7f36';

export function topBar(page: Page): TemplateResult {
  return html`<div class="top">
    <div class="tray card title">${wordmark}<b>${FIELD_WORDS.title}</b></div>
    <div class="tray card right">
      <div class="radios" role="radiogroup" aria-label="Style" @keydown=${roving}>
        ${CHOICES.style.options.map((option) => styleRadio(page, option))}
      </div>
      <span class="separator"></span>
      ${iconButton('focus', 'Show everything', () => page.showAll(), { key: 'Home' })}
    </div>
  </div>`;
}

function styleRadio(page: Page, [id, name]: (typeof CHOICES.style.options)[number]): TemplateResult {
  const chosen = page.state.style === id;
  return html`<button class="style" role="radio" aria-label=${name} title=${name} aria-checked=${chosen} tabindex=${chosen ? 0 : -1}
    @click=${() => page.set({ style: id })}>${ball(id, BALL)}<span>${name}</span></button>`;
}

/** Beside the picture; on narrow pages a sheet that folds. */
export function dock(page: Page): TemplateResult {
  const { folded, body, state } = page;
  const { canUseGpu } = body;
  const name = folded ? 'Show the controls' : 'Hide the controls';
  return html`<aside class="dock card ${folded ? 'folded' : ''}" aria-label="Controls">
    <header>
      <h2>Body</h2>
      ${iconButton('home', 'Reset everything', () => page.reset())}
      ${iconButton('duplicate', 'Copy the tree as JSON', () => void page.copy())}
      ${iconButton('down', name, () => page.fold(), { class: 'fold', expanded: !folded })}
    </header>
    <div class="scroll">${guard([state, canUseGpu], () => controls(page, canUseGpu))}</div>
    ${notice(page)}
  </aside>`;
}

/** Line 1: the last event. Line 2: the picture and what is in it. Line 3: where it was evaluated, and what that took. Line 4: what its cells may have missed. */
export function statusLine({ body, dataset, said, rays }: Page): TemplateResult {
  const { progress, problem } = body;
  // numbers of a body that is not the wanted one would be taken for its own
  const made = problem ? null : body.made;
  const { backend } = dataset;
  return html`<div class="status">
    ${bar(progress)}
    <span role="status" aria-live="polite"><b>${said || settled(body)}</b></span>
    <span><i class="dot ${backend === 'WebGPU' ? '' : 'slow'}"></i>${pictureOf(backend)}${made ? ` · ${FIELD_WORDS.facts(made)}` : nothing}</span>
    ${made ? html`<span class="work">${FIELD_WORDS.work(made)}${rays ? ` · ${rays}` : ''}</span>` : nothing}
    ${made?.thin && !made.draft ? html`<span class="work thin">${FIELD_WORDS.thin(made.thin)}</span>` : nothing}
  </div>`;
}

function pictureOf(backend: string | undefined): string {
  if (backend === 'none') return WORDS.noPicture;
  return backend === 'WebGL2' ? FIELD_WORDS.webgl2 : (backend ?? FIELD_WORDS.loading);
}

function bar(progress: number | null): TemplateResult {
  const percent = Math.round(100 * (progress ?? 0));
  return html`<div class="bar ${progress === null ? '' : 'on'}" role="progressbar" aria-label=${FIELD_WORDS.making}
    aria-valuenow=${percent}><i style="width:${percent}%"></i></div>`;
}

function settled({ made, problem, isPreparing }: FieldBody): string {
  if (problem) return made ? FIELD_WORDS.kept : FIELD_WORDS.none;
  if (isPreparing) return FIELD_WORDS.preparing;
  return made && !made.draft ? FIELD_WORDS.body(made) : FIELD_WORDS.making;
}

/** At the foot of the controls, where it covers nothing of the body. */
function notice(page: Page): TemplateResult | typeof nothing {
  if (!page.problem) return nothing;
  return html`<div class="notice" role="alert">
    ${icon('warn')}<span>${page.problem}</span>${iconButton('x', 'Close', () => page.close())}
  </div>`;
}
