/** The chip at the unfinished form: what it is, what else it may be, keep or drop. */
import { html, nothing, type TemplateResult } from 'lit';
import { type Document, readingOf } from '../document/document.ts';
import { BACKS, PLAIN } from '../document/surfacePart.ts';
import { BACK_ICONS, hasAcrossCard, setBack } from './acrossCard.ts';
import { type Actions, iconButton, roving } from './controls.ts';
import { draftProblem } from './draftProblem.ts';
import { fact, formWord, joinWord, previewWords, shortName, startedOn } from './draftWords.ts';
import { ball, type IconName, icon } from './icons.ts';
import type { ChipSize, Size } from './place.ts';
import type { Session } from './session.ts';
import { hasStrokesRow, strokesRow } from './strokesRow.ts';
import {
  FORMS,
  type FormWord,
  JOINS,
  type JoinWord,
  SECTION_WORDS,
  SILHOUETTE_WORDS,
  WORDS,
} from './words.ts';

const CLOSED: readonly FormWord[] = ['soft', 'plate', 'ring', 'carve', 'tube'];
const OPEN: readonly FormWord[] = ['tube', 'line', 'curve'];

const FORM_ICONS: Readonly<Record<FormWord, IconName>> = {
  soft: 'solid',
  plate: 'plate',
  ring: 'ring',
  carve: 'carve',
  tube: 'tube',
  line: 'line',
  curve: 'curve',
  point: 'point',
};

const JOIN_ICONS: Readonly<Record<JoinWord, IconName>> = { blend: 'blend', attach: 'attach', apart: 'box' };

/** What the strokes may become; none where there is no choice. */
export function formChoices(document: Document): readonly FormWord[] {
  const { strokes = [], form } = document.draft ?? {};
  if (strokes.length === 0 || form === 'point') return [];
  if (strokes[0]!.closed) {
    const hasHoles = strokes.length > 1;
    return CLOSED.filter((word) =>
      word === 'carve' ? startedOn(document) !== null : word !== 'ring' || !hasHoles,
    );
  }
  return strokes.length === 1 ? OPEN : [];
}

/** How it may go with the solid it starts on: not where it is none, or carves, which needs one. */
const joinChoices = (document: Document): readonly JoinWord[] =>
  readingOf(document) === 'solid' && !document.draft?.carves && startedOn(document)
    ? ['blend', 'attach', 'apart']
    : [];

/** px: about what it needs. Wide pages have room for words. */
export function chipSize(document: Document, { width }: Size, backs = false): ChipSize {
  const forms = backs ? BACKS.length : formChoices(document).length;
  const joins = joinChoices(document).length > 0 || hasStrokesRow(document);
  const words = backs || width >= WORDY;
  return {
    width: (forms > 0 ? 368 : 352) + forms * (words ? 90 : 46) + (document.draft?.recreates ? 48 : 0),
    narrow: forms > 0 || joins ? 304 : 190,
    height: joins ? 104 : 52,
    ...(document.draft?.recreates !== undefined && { beside: NUMBERED }),
    narrowHeight: 52 + (forms > 0 ? 52 : 0) + (joins ? 52 : 0),
  };
}

/** px, as in chipLayout.ts */
const WORDY = 1100;
/** px: the numbers of strokes lie between the form and the chip */
const NUMBERED = 60;

/** Keep or drop what is shown. */
export function chip(session: Session, actions: Actions): TemplateResult | typeof nothing {
  const { document } = session;
  const { draft, brush } = document;
  const kind = readingOf(document);
  if (!draft || !kind || session.state.wet || !actions.chipAt) return nothing;
  const { x, y, narrow } = actions.chipAt;
  const problem = draftProblem(document);
  // The chip goes, and the focus must not go with it.
  const done = (run: () => void) => () => {
    run();
    actions.dismiss();
  };
  return html`<div class="chip card chrome ${narrow ? 'narrow' : ''}" part="chip" role="group" aria-label=${previewWords(document)} style="--x:${x}px;left:${x}px;top:${y}px">
    <div class="main">
    ${iconButton(null, 'Colour', () => actions.toggle('palette'), {
      expanded: actions.open === 'palette',
      body: html`<span class="swatch">${ball('toon', brush.colour)}</span>`,
    })}
    <div class="what ${problem ? 'problem' : ''}">
      ${problem ? icon('warn', 20) : nothing}<div><b>${shortName(document)}</b><small>${problem ?? fact(document)}</small></div>
    </div>
    ${showsBacks(session, actions.open) ? backs(session) : forms(session)}
    <button class="b quiet text" aria-label="Drop" aria-keyshortcuts="Escape" @click=${done(() => session.drop())}>${icon('x', 20)}<span class="word">Drop</span></button>
    ${problem ? wayOn(session, done) : html`<button class="b primary text" aria-keyshortcuts="N Enter" @click=${done(() => session.keep())}>${icon('check', 20)}Keep</button>`}
    </div>
    ${joins(session)} ${strokesRow(session)}
  </div>`;
}

/** From strokes that make nothing: what they do make, or away with them. */
function wayOn(session: Session, done: (run: () => void) => () => void): TemplateResult {
  const kind = readingOf(session.document);
  if (kind === 'rotational') {
    const tubes = done(() => session.run({ type: 'setForm', form: 'tube' }));
    return html`<button class="b primary text" @click=${tubes}>${icon('tube', 20)}${WORDS.twoTubes}</button>`;
  }
  return html`<button class="b primary text" @click=${done(() => session.undo())}>${icon('undo', 20)}${WORDS.undoStroke}</button>`;
}

interface Choice {
  readonly name: string;
  readonly hint: string;
  readonly image: IconName;
  readonly chosen: boolean;
  run(): void;
}

/** Arrow keys go from one to the next, as in a native group of radios. */
function radios(label: string, name: string, choices: readonly Choice[]): TemplateResult {
  const any = choices.some(({ chosen }) => chosen);
  return html`<div class=${name} role="radiogroup" aria-label=${label} @keydown=${roving}>
    ${choices.map(
      ({ name, hint, image, chosen, run }, i) => html`<button
        class="b ${chosen ? 'on' : ''}" role="radio" aria-label=${name} aria-checked=${chosen} title="${name}: ${hint}"
        tabindex=${chosen || (!any && i === 0) ? 0 : -1} @click=${() => chosen || run()}
      >${icon(image)}<span class="word">${name}</span></button>`,
    )}
  </div>`;
}

function forms(session: Session): TemplateResult | typeof nothing {
  const { document } = session;
  const now = formWord(document);
  const choices = formChoices(document).map((word) => ({
    ...FORMS[word],
    image: FORM_ICONS[word],
    chosen: word === now,
    run: () => choose(session, word),
  }));
  return choices.length > 0 ? radios(SILHOUETTE_WORDS.forms, 'forms', choices) : nothing;
}

/** Where the card of the Section tool is not. */
export function showsBacks(session: Session, open: Actions['open']): boolean {
  const kind = readingOf(session.document);
  return (kind === 'crossSection' || kind === 'bspline') && !hasAcrossCard(session, open);
}

function backs(session: Session): TemplateResult {
  const now = session.document.draft?.back ?? PLAIN.back;
  const choices = BACKS.map((back) => ({
    ...SECTION_WORDS.backs[back],
    image: BACK_ICONS[back],
    chosen: back === now,
    run: () => setBack(session, back),
  }));
  return radios(SECTION_WORDS.back, 'forms backs', choices);
}

function choose(session: Session, word: FormWord): void {
  const { draft } = session.document;
  const carves = word === 'carve';
  // what carves is nothing without what it takes away from
  const on = carves && !draft?.joins?.component ? startedOn(session.document)?.joins : undefined;
  session.run({ type: 'setForm', form: carves ? 'soft' : word, carves, ...(on && { joins: on }) });
}

function joins(session: Session): TemplateResult | typeof nothing {
  const { document } = session;
  const start = startedOn(document);
  const now = joinWord(document);
  if (!start) return nothing;
  const to = { blend: start.joins, attach: { ...start.joins, component: null }, apart: null };
  const choices = joinChoices(document).map((word) => ({
    name: JOINS[word].name,
    hint: JOINS[word].hint(start.solid.name),
    image: JOIN_ICONS[word],
    chosen: word === now,
    run: () => session.run({ type: 'setForm', joins: to[word] }),
  }));
  return choices.length > 0 ? radios(SILHOUETTE_WORDS.joins(start.solid.name), 'joins', choices) : nothing;
}
