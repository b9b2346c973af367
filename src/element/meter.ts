/** What the strokes are now, and what one more, or leaving the outline open, would make of them. */
import { html, nothing, type TemplateResult } from 'lit';
import { readingOf } from '../document/document.ts';
import { icon } from './icons.ts';
import type { Session } from './session.ts';
import { SILHOUETTE_WORDS } from './words.ts';

export function meter(session: Session): TemplateResult | typeof nothing {
  // while the pen closes an outline it already is what lifting would make it
  const { draft } = session.state.wet ? session.shown() : session.document;
  if (!draft) return nothing;
  if (draft.strokes[0]?.closed) return closedMeter(session);
  return session.document.draft ? numbered(session) : nothing;
}

/** Two steps: the outline is closed, or left open. */
function closedMeter(session: Session): TemplateResult {
  const shown = session.state.wet ? session.shown() : session.document;
  const isSolid = readingOf(shown) === 'solid';
  const to = (form: 'soft' | 'tube') => () => {
    if (session.document.draft?.strokes[0]?.closed && !session.state.wet)
      session.run({ type: 'setForm', form });
  };
  return html`<div class="meter card chrome" part="meter" role="group" aria-label=${SILHOUETTE_WORDS.meter}>
    <button aria-current=${isSolid ? 'step' : nothing} @click=${isSolid ? nothing : to('soft')}>${icon('solid')}${SILHOUETTE_WORDS.closed}</button>
    <button aria-current=${isSolid ? nothing : 'step'} @click=${isSolid ? to('tube') : nothing} title="A tube along the outline; no stroke is lost">
      ${icon('tube')}<span class="long">${SILHOUETTE_WORDS.open}</span><span class="short">${SILHOUETTE_WORDS.shortOpen}</span>
    </button>
  </div>`;
}

/** The number of open strokes decides. */
function numbered(session: Session): TemplateResult | typeof nothing {
  const { draft, tubesOnly } = session.document;
  const kind = readingOf(session.document);
  // a line, a curve or a point is no step on the way to a rotational surface
  if (!draft || kind === 'solid') return nothing;
  const two = draft.strokes.length > 1;
  const only = (on: boolean) => () => session.run({ type: 'setTubesOnly', on });
  const done = kind === 'rotational';
  return html`<div class="meter card chrome" part="meter" role="group" aria-label="The number of strokes decides the surface">
    <button class=${done ? 'done' : ''} aria-current=${done ? nothing : 'step'} @click=${only(true)}
      title=${done ? 'Back to two tubes; no stroke is lost' : 'Every stroke a tube'}>
      ${icon('tube')}${done ? html`<span class="tick">${icon('check')}</span>` : nothing}1 Tube${tubesOnly ? html`<span class="hidden">, every stroke</span>` : nothing}
    </button>
    <button aria-current=${done ? 'step' : nothing} @click=${only(false)}
      title=${two ? 'Between the two strokes' : 'Draw the other side to make it round'}>
      ${icon('rotational')}2 Rotational
    </button>
  </div>`;
}
