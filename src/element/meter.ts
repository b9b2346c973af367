/** What the strokes are now, and what one more, or leaving the outline open, would make of them. */
import { html, nothing, type TemplateResult } from 'lit';
import { readingOf } from '../document/document.ts';
import { kindOfStrokes } from '../document/surfacePart.ts';
import type { SurfaceKind } from '../surface/index.ts';
import { icon } from './icons.ts';
import type { Session } from './session.ts';
import { METER_WORDS, SILHOUETTE_WORDS } from './words.ts';

export function meter(session: Session): TemplateResult | typeof nothing {
  // while the pen closes an outline it already is what lifting would make it
  const { draft } = session.state.wet ? session.shown() : session.document;
  if (!draft) return nothing;
  // closed sides of a part that is in hand again are no outline
  const isSurface = draft.recreates !== undefined || draft.sections !== undefined;
  if (draft.strokes[0]?.closed && !isSurface) return closedMeter(session);
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

/** What strokes make, the fewest first. */
const STEPS: readonly SurfaceKind[] = ['tube', 'rotational', 'crossSection', 'bspline'];

/** The number of strokes decides; what needs fewer was passed on the way, and is there to go back to. */
function numbered(session: Session): TemplateResult | typeof nothing {
  const { document } = session;
  const kind = readingOf(document);
  // a line, a curve or a point is no step on the way to a surface
  if (!document.draft || kind === null || kind === 'solid') return nothing;
  const now = STEPS.indexOf(kind);
  return html`<div class="meter steps card chrome" part="meter" role="group" aria-label=${METER_WORDS.label}>
    ${STEPS.map((step, i) => stepButton(session, step, i, now))}
  </div>`;
}

function stepButton(session: Session, step: SurfaceKind, i: number, now: number): TemplateResult {
  const { tubesOnly } = session.document;
  const pinned = step === 'tube' && tubesOnly;
  const state = pinned ? 'pinned' : i < now ? 'done' : i === now ? 'current' : 'next';
  const { name, number } = METER_WORDS.steps[step];
  const sign = { pinned: 'lock', done: 'check', current: null, next: null } as const;
  const hold = step === 'tube' ? held(session) : null;
  const label = `${number} ${name}${pinned ? `, ${METER_WORDS.everyStroke}` : ''}`;
  return html`<button class=${state} aria-label=${label} aria-current=${i === now ? 'step' : nothing} title=${METER_WORDS.hint(step, state)}
    @click=${() => hold?.wasLong() || take(session, step, now)}
    @pointerdown=${hold?.begin} @pointerup=${hold?.end} @pointerleave=${hold?.end} @contextmenu=${hold?.pin}>
    ${icon(step)}${sign[state] ? html`<span class="tick">${icon(sign[state])}</span>` : nothing}<span class="number">${number}</span><span class="long">${name}</span>
  </button>`;
}

/** Back to what fewer strokes make, on to what there are strokes for, or the tool that draws what is missing. */
function take(session: Session, step: SurfaceKind, now: number): void {
  const { document } = session;
  const draft = document.draft!;
  const to = STEPS.indexOf(step);
  const whole = kindOfStrokes({ strokes: draft.strokes, sections: draft.sections ?? [] });
  if (document.tubesOnly) session.run({ type: 'setTubesOnly', on: false });
  if (to <= STEPS.indexOf(whole)) {
    if (to !== now) session.run({ type: 'setForm', form: step === whole ? null : step });
  } else if (to > 1) session.setTool('section');
}

/** ms: a press this long pins */
const LONG = 500;
let timer: ReturnType<typeof setTimeout> | undefined;
let long = false;

/** A press that lasts pins the step: every stroke a tube. So does the other button; keys find it in the settings. */
function held(session: Session) {
  const pin = () => {
    long = true;
    session.run({ type: 'setTubesOnly', on: !session.document.tubesOnly });
  };
  return {
    begin: () => {
      clearTimeout(timer);
      long = false;
      timer = setTimeout(pin, LONG);
    },
    end: () => clearTimeout(timer),
    pin: (event: Event) => {
      event.preventDefault();
      clearTimeout(timer);
      if (!long) pin();
    },
    /** The click that ends a long press is none. */
    wasLong: () => long,
  };
}
