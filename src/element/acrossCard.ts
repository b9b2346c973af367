/** Beside the drawing while the Section tool is in hand: how sections come out, and what the back is. */
import { css, html, nothing, svg, type TemplateResult } from 'lit';
import { BACKS, type Back } from '../document/surfacePart.ts';
import { type Across, acrossOf } from '../tool/across.ts';
import { type Actions, iconButton } from './controls.ts';
import { backsToDraw } from './draftWords.ts';
import { type SegmentChoice, segment } from './editSegment.ts';
import { type IconName, icon } from './icons.ts';
import type { Session } from './session.ts';
import { SECTION_WORDS } from './words.ts';

/** px: on narrower pages it would lie on the drawing, and the chip has the choice alone */
const ROOM = 1100;

/** px from the right edge that it covers */
export const CARD_WIDTH = 336;

/** Whether the card is there; the chip has the choice of backs where it is not. */
export function hasAcrossCard(session: Session, open: Actions['open']): boolean {
  const { tool, acrossAway, size } = session;
  return tool === 'section' && !acrossAway && open === null && size.width >= ROOM;
}

export function acrossCard(session: Session, actions: Actions): TemplateResult | typeof nothing {
  if (!hasAcrossCard(session, actions.open)) return nothing;
  const found = acrossOf(session);
  const across = typeof found === 'string' ? null : found;
  const close = () => {
    session.acrossAway = true;
    session.update();
    actions.dismiss();
  };
  return html`<section class="across card chrome" part="panel" aria-label=${SECTION_WORDS.title}>
    <header>${icon('section')}<h2>${SECTION_WORDS.title}</h2>${iconButton('x', 'Close', close)}</header>
    <p>${words(found)}</p>
    ${across ? html`${looks(session)}<div class="foot"><h3>${SECTION_WORDS.back}</h3>${backs(session, across)}</div>` : nothing}
  </section>`;
}

function words(found: ReturnType<typeof acrossOf>): string {
  if (typeof found === 'string') return SECTION_WORDS.notAcross[found];
  const places = backsToDraw(found);
  return places === null ? SECTION_WORDS.text : SECTION_WORDS.backText(places);
}

const backs = (session: Session, { part, back: now }: Across): TemplateResult =>
  segment(
    SECTION_WORDS.back,
    backChoices(now, (back) => setBack(session, back, part)),
  );

export const backChoices = (now: Back | null, set: (back: Back) => void): SegmentChoice[] =>
  BACKS.map((back) => ({
    ...SECTION_WORDS.backs[back],
    image: BACK_ICONS[back],
    on: back === now,
    run: () => set(back),
  }));

export const BACK_ICONS: Readonly<Record<Back, IconName>> = {
  none: 'backNone',
  front: 'backFront',
  drawn: 'backDrawn',
};

export const setBack = (session: Session, back: Back, part?: string): void =>
  session.run({ type: 'setSurface', change: { back }, ...(part !== undefined && { ids: [part] }) });

/** One leaf by light from the upper left, in the bands of toon: the same outline three times. */
const LEAF = 'M27 1C20 9 8 19 7 40C6 58 20 62 26 76C27 79 29 79 30 76C33 64 47 56 48 36C49 20 36 10 27 1Z';

const SHADES = [
  svg`<path d="M27 1C20 9 8 19 7 40C7 44 8 47 9 50C16 46 25 36 27 1Z" fill="#fff" opacity=".22"/>
    <path d="M48 36C49 20 36 10 27 1C38 22 38 44 28 58C26 63 27 70 28 78C29 78 30 77 30 76C33 64 47 56 48 36Z" opacity=".3"/>
    <path d="M48 34C42 50 32 58 27 64C26 69 27 74 28 78C29 78 30 77 30 76C33 64 48 56 48 34Z" opacity=".28"/>`,
  nothing,
  svg`<path d="M27 1C20 9 8 19 7 40C7 50 11 55 15 60C15 42 18 22 27 1Z" opacity=".3"/>
    <path d="M27 1C20 9 9 18 7 36C13 24 18 14 27 1Z" opacity=".28"/>
    <path d="M48 36C47 40 40 42 34 48C30 53 29 62 30 74C33 64 46 57 48 36Z" fill="#fff" opacity=".22"/>`,
];

function looks(session: Session): TemplateResult {
  const { colour } = session.document.brush;
  return html`<ul>
    ${SECTION_WORDS.looks.map(
      ({ name, hint }, i) => html`<li>
        <svg viewBox="0 0 55 80" aria-hidden="true"><path d=${LEAF} fill=${colour}/>${SHADES[i]}<path d=${LEAF} class="outline"/></svg>
        <b>${name}</b><small>${hint}</small>
      </li>`,
    )}
  </ul>`;
}

export const acrossLayout = css`
  .across { position: absolute; right: var(--gap); top: 5.25rem; width: 20rem; padding: 0.5rem 0.5rem 0.625rem; box-shadow: var(--e2); z-index: 1; }
  .across header { display: flex; align-items: center; gap: 0.5rem; min-height: 2.75rem; padding-left: 0.5rem; }
  .across h2 { font: 600 1.0625rem/1.375rem var(--font); flex: 1; }
  .across p { padding: 0 0.5rem 0.375rem; color: var(--ink-2); }
  .across ul { list-style: none; padding: 0; display: grid; grid-template-columns: repeat(3, 1fr); }
  .across li { display: flex; flex-direction: column; align-items: center; padding: 0.375rem 0 0.625rem; }
  .across li svg { width: 3.75rem; height: 5.5rem; overflow: visible; }
  .across li .outline { fill: none; stroke: var(--ink); stroke-width: 2; stroke-linejoin: round; }
  .across li b { font: 600 0.875rem/1.25rem var(--font); padding-top: 0.375rem; }
  .across small { font: 0.75rem/1rem var(--font); color: var(--ink-2); }
  .across .foot { border-top: 1px solid var(--hairline); padding-top: 0.375rem; }
  .across h3 { font: 600 0.8125rem/1.125rem var(--font); color: var(--ink-2); padding: 0.375rem 0.5rem; }
  .across .tip { display: none; }
  .meter .next { color: var(--ink-2); font-weight: 400; }
  .meter.steps button { gap: 0.3125rem; }
  .meter.steps .icon:first-child { margin-right: 0.25rem; }
  .meter.steps ~ .status { max-width: calc(50cqw - 19rem); }
  @container (max-width: 1399px) {
    .meter.steps ~ .status .facts { display: none; }
  }
  @container (max-width: 1099px) {
    .meter.steps button { padding: 0 0.75rem; }
    .meter.steps ~ .status { max-width: calc(50cqw - 16rem); }
  }
  @container (max-width: 899px) {
    .meter.steps button:not([aria-current]) .long { display: none; }
    .meter.steps ~ .status { max-width: calc(50cqw - 12rem); }
  }
  @container (max-width: 699px) {
    .meter.steps { max-width: calc(100% - 1rem); }
    .meter.steps button[aria-current] .long { display: inline; }
    .meter.steps ~ .status { max-width: 60%; }
  }
  @container (max-height: 560px) {
    .across ul { display: none; }
  }
  :host([data-theme='contrast']) .across li .outline { stroke-width: 2.5; }
`;
