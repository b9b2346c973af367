/** What the strokes are now, and what one more, or leaving the outline open, would make of them. */
import { html, nothing, type TemplateResult } from 'lit';
import { type Document, readingOf, staysTubes } from '../document/document.ts';
import { kindOfStrokes } from '../document/surfacePart.ts';
import type { SurfaceKind } from '../surface/index.ts';
import { icon } from './icons.ts';
import { LongPress } from './longPress.ts';
import type { Session } from './session.ts';
import { METER_WORDS, SILHOUETTE_WORDS } from './words.ts';

export function meter(session: Session): TemplateResult | typeof nothing {
  // while the pen closes an outline it already is what lifting would make it
  const { draft } = session.state.wet ? session.shown() : session.document;
  if (!draft) return gone(session);
  // closed sides of a part that is in hand again are no outline
  const isSurface = draft.recreates !== undefined || draft.sections !== undefined;
  if (draft.strokes[0]?.closed && !isSurface) {
    gone(session);
    return closedMeter(session);
  }
  return session.document.draft ? numbered(session) : gone(session);
}

/** With its buttons goes what was held. */
function gone(session: Session): typeof nothing {
  holds.get(session)?.stop();
  return nothing;
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
  if (!document.draft || kind === null || kind === 'solid') return gone(session);
  const now = STEPS.indexOf(kind);
  return html`<div class="meter steps card chrome" part="meter" role="group" aria-label=${METER_WORDS.label}>
    ${STEPS.map((step, i) => stepButton(session, step, i, now))}
  </div>`;
}

function stepButton(session: Session, step: SurfaceKind, i: number, now: number): TemplateResult {
  const state = stateOf(session.document, step);
  const pinned = state === 'pinned';
  const { name, number } = METER_WORDS.steps[step];
  const sign = { pinned: 'lock', done: 'check', current: null, next: null } as const;
  const hold = step === 'tube' ? holdOf(session) : null;
  const label = `${number} ${name}${pinned ? `, ${METER_WORDS.everyStroke}` : ''}`;
  const tap = (event: MouseEvent) => hold?.swallows(event) || takeStep(session, step);
  return html`<button class=${state} aria-label=${label} aria-current=${i === now ? 'step' : nothing} title=${METER_WORDS.hint(step, state)}
    @click=${tap} @pointerdown=${hold?.begin} @pointerup=${hold?.end} @pointerleave=${hold?.end} @contextmenu=${hold?.menu}>
    ${icon(step)}${sign[state] ? html`<span class="tick">${icon(sign[state])}</span>` : nothing}<span class="number">${number}</span><span class="long">${name}</span>
  </button>`;
}

/** How far a step is, of an unfinished surface. */
export function stateOf(document: Document, step: SurfaceKind): 'pinned' | 'done' | 'current' | 'next' {
  if (step === 'tube' && document.tubesOnly) return 'pinned';
  const kind = readingOf(document);
  if (kind === null || kind === 'solid') return 'next';
  if (step === kind) return 'current';
  const isPassed = STEPS.indexOf(kind) > STEPS.indexOf(step);
  return isPassed && !lacksSide(document, step) ? 'done' : 'next';
}

/** Sections across one stroke never were round between two. */
const lacksSide = ({ draft }: Document, step: SurfaceKind): boolean =>
  step === 'rotational' && (draft?.strokes.length ?? 0) < 2;

/** Back to what fewer strokes make, on to what there are strokes for, or the tool that draws what is missing: one undo step. */
export function takeStep(session: Session, step: SurfaceKind): void {
  const { document } = session;
  const { draft } = document;
  const kind = readingOf(document);
  if (!draft || kind === null || kind === 'solid') return;
  const to = STEPS.indexOf(step);
  const whole = kindOfStrokes({ strokes: draft.strokes, sections: draft.sections ?? [] });
  if (to > STEPS.indexOf(whole) || lacksSide(document, step)) {
    if (staysTubes(document)) session.run({ type: 'setTubesOnly', on: false });
    if (to > 1) session.setTool('section');
    else if (session.tool !== 'draw') session.setTool('draw');
  } else if (step === 'tube' && staysTubes(document)) session.run({ type: 'setTubesOnly', on: false });
  else if (step !== kind) session.run({ type: 'setForm', form: step === whole ? null : step });
}

/** By the element: of two in a page each is pressed by itself. */
const holds = new WeakMap<Session, LongPress>();

/** A press that lasts pins the step: every stroke a tube. So does the other button; keys find it in the settings. */
function holdOf(session: Session): LongPress {
  const known = holds.get(session);
  if (known) return known;
  const hold = new LongPress(() => session.run({ type: 'setTubesOnly', on: !session.document.tubesOnly }));
  holds.set(session, hold);
  return hold;
}
