/**
 * Where neither WebGPU nor WebGL2 works: what is missing, why, and what can still be done. The drawing itself needs no
 * graphics device: strokes are shown as ink, and files are opened, saved and exported as ever.
 */
import { css, html, nothing, type TemplateResult } from 'lit';
import { type Actions, iconButton } from './controls.ts';
import { icon } from './icons.ts';
import type { Session } from './session.ts';
import { NO_PICTURE } from './words.ts';

export interface NoPicture {
  /** in the words of whoever refused */
  readonly reason: string;
  /** the page tells the person itself, or the person has read it */
  readonly told: boolean;
  retry(): void;
}

export function noPicture(
  session: Session,
  actions: Actions,
  readOnly: boolean,
): TemplateResult | typeof nothing {
  const { noPicture: shown } = session;
  if (!shown || shown.told) return nothing;
  const text = (words: string, run: () => void) =>
    html`<button class="b quiet text" @click=${run}>${words}</button>`;
  const close = () => {
    session.noPicture = { ...shown, told: true };
    actions.dismiss();
    session.update();
  };
  return html`<section class="no-picture card chrome" aria-labelledby="no-picture">
    <header>${icon('warn')}<h2 id="no-picture">${NO_PICTURE.title}</h2>${iconButton('x', 'Close', close)}</header>
    <div role="alert"><p>${NO_PICTURE.missing}</p><p>${NO_PICTURE.still}</p></div>
    <p class="why">${NO_PICTURE.why(shown.reason)}</p>
    <div class="row">
      ${readOnly ? nothing : text(NO_PICTURE.open, () => actions.toggle('file'))}
      ${readOnly ? nothing : text(NO_PICTURE.export, () => actions.toggle('export'))}
      ${text(NO_PICTURE.retry, () => shown.retry())}
    </div>
  </section>`;
}

export const noPictureStyle = css`
  .no-picture { position: absolute; left: 50%; top: 5.25rem; transform: translateX(-50%); width: 26rem; max-width: calc(100% - 2rem); max-height: calc(100% - 6.25rem); overflow: auto; padding: 0.5rem 0.5rem 1rem 1rem; box-shadow: var(--e2); z-index: 1; }
  .no-picture header { display: flex; align-items: center; gap: 0.5rem; min-height: 2.75rem; }
  .no-picture header > .icon { color: var(--warn); }
  .no-picture h2 { font: 600 1.0625rem/1.375rem var(--font); flex: 1; }
  .no-picture p { padding-right: 0.5rem; margin-bottom: 0.5rem; }
  .no-picture .why { color: var(--ink-2); font-size: 0.8125rem; line-height: 1.125rem; overflow-wrap: anywhere; user-select: text; -webkit-user-select: text; }
  .no-picture .row { display: flex; flex-wrap: wrap; gap: 0.5rem; margin-top: 0.75rem; }
`;
