/**
 * The list of the parts. Only the rows in sight are there, and they are drawn anew only when parts, selection or
 * scrolling ask for it: a thousand parts cost as much as ten.
 *
 * A grid rather than a list box: its rows hold a button that hides, and a list box's options must not. The grid has the
 * focus and names its active row, because a row that scrolls out of sight would take the focus with it.
 */
import { html, render, type TemplateResult } from 'lit';
import { ref } from 'lit/directives/ref.js';
import { repeat } from 'lit/directives/repeat.js';
import type { Part } from '../document/document.ts';
import type { FieldNode } from '../field/node.ts';
import { flawsOf, type Problem } from './flaws.ts';
import { icon } from './icons.ts';
import { madeOf } from './partCard.ts';
import { removeSelection } from './partDeeds.ts';
import type { Session } from './session.ts';
import { PART_WORDS, SURFACE } from './words.ts';

/** rem: as the style sheet has it */
const ROW = 3;
/** rows beyond either edge, and in sight before the list has a size */
const SPARE = 4;
const FIRST = 12;

/** What is drawn in a list, and the row its keys act on. */
interface Shown {
  parts: readonly Part[];
  selection: readonly string[];
  first: number;
  last: number;
  /** id */
  active: string | null;
  /** what is told of bodies, which are made when the list is long drawn */
  flaws: string;
}

const shown = new WeakMap<Element, Shown>();

export function partList(session: Session): TemplateResult {
  const paint = (list: Element | undefined) => {
    if (list) draw(list as HTMLElement, session);
  };
  return html`<div class="part-list" role="grid" tabindex="0" aria-label=${PART_WORDS.list} aria-multiselectable="true"
    aria-rowcount=${session.document.parts.length} ${ref(paint)}
    @scroll=${(event: Event) => paint(event.currentTarget as Element)}
    @click=${(event: MouseEvent) => click(event, session)} @keydown=${(event: KeyboardEvent) => press(event, session)}></div>`;
}

function draw(list: HTMLElement, session: Session): void {
  const { selection, document } = session;
  const { parts } = document;
  const before = shown.get(list);
  const active = selection.length === 1 && selection !== before?.selection ? selection[0]! : before?.active;
  const now: Shown = {
    parts,
    selection,
    active: active ?? parts[0]?.id ?? null,
    flaws: session.flaws.map(({ part, what }) => `${part} ${what}`).join(),
    ...rowsInSight(list, parts),
  };
  const same = (Object.keys(now) as (keyof Shown)[]).every((key) => now[key] === before?.[key]);
  if (same) return;
  shown.set(list, now);
  const selected = new Set(selection);
  const problem = (node: FieldNode) => session.bodies.problem(node);
  const rows = repeat(
    parts.slice(now.first, now.last),
    ({ id }) => id,
    (part, i) => row(part, now.first + i, selected.has(part.id), part.id === now.active, problem),
  );
  const [above, below] = [now.first, parts.length - now.last].map((count) => `${ROW * count}rem`);
  render(
    html`<div role="presentation" style="height:${above}"></div>${rows}<div role="presentation" style="height:${below}"></div>`,
    list,
  );
  point(list, now.active);
  if (before?.selection !== selection && selection.length === 1)
    later(list, session, () => reveal(list, session));
  else if (!before) later(list, session, () => {});
}

function point(list: HTMLElement, active: string | null): void {
  if (active) list.setAttribute('aria-activedescendant', `row-${active}`);
  else list.removeAttribute('aria-activedescendant');
}

/** When the list has a size. */
function later(list: HTMLElement, session: Session, first: () => void): void {
  requestAnimationFrame(() => {
    first();
    if (list.isConnected) draw(list, session);
  });
}

function rowsInSight(list: HTMLElement, parts: readonly Part[]): { first: number; last: number } {
  const height = rowHeight(list);
  const first = Math.max(0, Math.floor(list.scrollTop / height) - SPARE);
  const count = list.clientHeight > 0 ? Math.ceil(list.clientHeight / height) : FIRST;
  return { first, last: Math.min(parts.length, first + count + 2 * SPARE) };
}

const rowHeight = (list: HTMLElement): number => list.querySelector<HTMLElement>('.part')?.offsetHeight || 48;

function row(
  part: Part,
  index: number,
  selected: boolean,
  active: boolean,
  problem: Problem,
): TemplateResult {
  const { id, name, kind, hidden } = part;
  const facts = [SURFACE[kind].name, madeOf(part)];
  if (hidden) facts.push(PART_WORDS.hidden);
  for (const { what } of hidden ? [] : flawsOf(part, problem)) facts.push(PART_WORDS.flaw[what]);
  const eye = hidden ? PART_WORDS.show(name) : PART_WORDS.hide(name);
  return html`<div class="part ${hidden ? 'unseen' : ''} ${active ? 'active' : ''}" role="row" id="row-${id}" data-id=${id}
    aria-rowindex=${index + 1} aria-selected=${selected} aria-label="${name}, ${facts.join(', ')}">
    <div role="gridcell" class="what">${icon(kind)}<span><b>${name}</b><small>${facts.join(' · ')}</small></span></div>
    <div role="gridcell"><button class="b" tabindex="-1" aria-label=${eye}>${icon(hidden ? 'eyeOff' : 'eye')}</button></div>
  </div>`;
}

/** Scrolls the list, and nothing around it, to where the active row is in sight. */
function reveal(list: HTMLElement, session: Session): void {
  const active = shown.get(list)?.active;
  const at = session.document.parts.findIndex(({ id }) => id === active);
  const height = rowHeight(list);
  if (at < 0) return;
  if (at * height < list.scrollTop) list.scrollTop = at * height;
  const lowest = (at + 1) * height - list.clientHeight;
  if (lowest > list.scrollTop) list.scrollTop = lowest;
}

// ── hands and keys ────────────────────────────────────────────────────────────────────────────────────

function click(event: MouseEvent, session: Session): void {
  const list = event.currentTarget as HTMLElement;
  const target = event.target as Element;
  const id = target.closest<HTMLElement>('[role=row]')?.dataset.id;
  if (!id) return;
  list.focus({ preventScroll: true });
  activate(list, session, id);
  if (target.closest('button')) toggleShown(session, id);
  else if (event.ctrlKey || event.metaKey) choose(session, toggled(session.selection, id));
  else if (event.shiftKey) choose(session, [...session.selection, ...between(session, id)]);
  else choose(session, [id]);
}

/** From what is selected to the part, as lists do. */
function between({ document, selection }: Session, id: string): string[] {
  const ids = document.parts.map((part) => part.id);
  const to = ids.indexOf(id);
  const from = selection.length > 0 ? ids.indexOf(selection[0]!) : to;
  return ids.slice(Math.min(from, to), Math.max(from, to) + 1);
}

const toggled = (ids: readonly string[], id: string): string[] =>
  ids.includes(id) ? ids.filter((other) => other !== id) : [...ids, id];

function toggleShown(session: Session, id: string): void {
  const part = session.document.parts.find((other) => other.id === id);
  if (part) session.run({ type: 'showParts', ids: [id], visible: part.hidden });
}

/** What is selected is taken in hand. */
function choose(session: Session, ids: readonly string[]): void {
  if (session.tool !== 'select') session.setTool('select');
  session.select(ids);
  session.saySelection();
}

function activate(list: HTMLElement, session: Session, id: string | null): void {
  const now = shown.get(list);
  // Forgets what was drawn, so that it is drawn again with another active row.
  if (now && now.active !== id) shown.set(list, { ...now, active: id, last: -1 });
  reveal(list, session);
  draw(list, session);
}

function press(event: KeyboardEvent, session: Session): void {
  const list = event.currentTarget as HTMLElement;
  if (!answer(event, list, session)) return;
  event.preventDefault();
  event.stopPropagation();
}

/** True when the list has an answer to the key. */
function answer(event: KeyboardEvent, list: HTMLElement, session: Session): boolean {
  const { parts } = session.document;
  const at = parts.findIndex(({ id }) => id === shown.get(list)?.active);
  const id = parts[at]?.id;
  const page = Math.max(1, Math.floor(list.clientHeight / rowHeight(list)) - 1);
  const to = {
    ArrowDown: at + 1,
    ArrowUp: at - 1,
    PageDown: at + page,
    PageUp: at - page,
    Home: 0,
    End: parts.length - 1,
  }[event.key];
  if (to !== undefined) return go(Math.min(parts.length - 1, Math.max(0, to)), event, list, session);
  if (event.key === 'F2') {
    list.closest('.panel')?.querySelector<HTMLInputElement>('input[type=text]')?.select();
    return true;
  }
  if (event.key === 'Delete' || event.key === 'Backspace') return remove(at, list, session);
  if (!id || (event.key !== 'Enter' && event.key !== ' ')) return false;
  choose(session, event.key === ' ' ? toggled(session.selection, id) : [id]);
  return true;
}

/** Arrows select as they go; with Shift they add, with Ctrl they only go. */
function go(to: number, event: KeyboardEvent, list: HTMLElement, session: Session): true {
  const id = session.document.parts[to]?.id;
  if (!id) return true;
  activate(list, session, id);
  if (event.shiftKey) choose(session, [...session.selection, id]);
  else if (!event.ctrlKey && !event.metaKey) choose(session, [id]);
  return true;
}

/** The row that takes the place of those that go is the active one next; after the last one the drawing has the focus. */
function remove(at: number, list: HTMLElement, session: Session): boolean {
  const { parts } = session.document;
  const gone = new Set(session.selection);
  const stays = ({ id }: Part) => !gone.has(id);
  const next = parts.slice(at).find(stays) ?? parts.slice(0, at).reverse().find(stays);
  if (!removeSelection(session)) return false;
  if (next) activate(list, session, next.id);
  else
    (list.getRootNode() as ParentNode).querySelector<HTMLElement>('.stage')?.focus({ preventScroll: true });
  return true;
}
