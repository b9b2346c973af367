/**
 * The list of the parts, and of what solids are made of, as a tree. Only the rows in sight are there, and they are drawn anew only when parts,
 * selection or scrolling ask for it: a thousand parts cost as much as ten.
 *
 * A grid rather than a list box: its rows hold a button that hides, and a list box's options must not. The grid has the
 * focus and names its active row, because a row that scrolls out of sight would take the focus with it.
 */
import { html, nothing, render, type TemplateResult } from 'lit';
import { ref } from 'lit/directives/ref.js';
import { repeat } from 'lit/directives/repeat.js';
import { isSolid } from '../document/document.ts';
import type { FieldNode } from '../field/node.ts';
import { flawsOf, type Problem } from './flaws.ts';
import { icon } from './icons.ts';
import { removeSelection } from './partDeeds.ts';
import { type DragHost, dragRow } from './partDrag.ts';
import { factsOf, isHidden, openedFor, type Row, rowsOf, toggled } from './partRows.ts';
import type { Session } from './session.ts';
import { PART_WORDS, SOLID_WORDS } from './words.ts';

/** rem: as the style sheet has it */
const ROW = 3;
/** rows beyond either edge, and in sight before the list has a size */
const SPARE = 4;
const FIRST = 12;

/** What is drawn in a list, and the row its keys act on. */
interface Shown {
  rows: readonly Row[];
  selection: readonly string[];
  first: number;
  last: number;
  /** id */
  active: string | null;
  /** what is told of bodies, which are made when the list is long drawn */
  flaws: string;
}

const shown = new WeakMap<Element, Shown>();

const opened = new WeakMap<Session, ReadonlySet<string>>();
const NONE: ReadonlySet<string> = new Set();

/** As the list shows them now. */
const rowsShown = (session: Session): readonly Row[] =>
  rowsOf(session.document.parts, opened.get(session) ?? NONE);

/** Opens a row, or closes it. */
function toggleOpen(session: Session, id: string): void {
  opened.set(session, toggled(session.document, id, opened.get(session) ?? NONE));
  session.update();
}

export function partList(session: Session): TemplateResult {
  const paint = (list: Element | undefined) => {
    if (list) draw(list as HTMLElement, session);
  };
  return html`<div class="part-list" role="treegrid" tabindex="0" aria-label=${PART_WORDS.list} aria-multiselectable="true"
    aria-rowcount=${rowsShown(session).length} ${ref(paint)}
    @scroll=${(event: Event) => paint(event.currentTarget as Element)}
    @pointerdown=${(event: PointerEvent) => dragRow(event, hostOf(session))}
    @click=${(event: MouseEvent) => click(event, session)} @keydown=${(event: KeyboardEvent) => press(event, session)}></div>`;
}

const hostOf = (session: Session): DragHost => ({
  session,
  rows: () => rowsShown(session),
  open: (id) => toggleOpen(session, id),
  activate: (list, id) => activate(list, session, id),
});

function draw(list: HTMLElement, session: Session): void {
  const { selection } = session;
  const before = shown.get(list);
  const isFresh = selection !== before?.selection;
  // what is selected in the picture is found in the list
  if (isFresh) opened.set(session, openedFor(session.document, selection, opened.get(session) ?? NONE));
  const rows = rowsShown(session);
  const active = selection.length === 1 && isFresh ? selection[0]! : before?.active;
  const now: Shown = {
    rows,
    selection,
    active: active ?? rows[0]?.id ?? null,
    flaws: session.bodyWork.flaws.map(({ part, what }) => `${part} ${what}`).join(),
    ...rowsInSight(list, rows),
  };
  const same = (Object.keys(now) as (keyof Shown)[]).every((key) => now[key] === before?.[key]);
  if (same) return;
  shown.set(list, now);
  const selected = new Set(selection);
  const problem = (node: FieldNode) => session.bodies.problem(node);
  const isTree = rows.some(({ open }) => open !== null);
  list.setAttribute('aria-rowcount', String(rows.length));
  const drawn = repeat(
    rows.slice(now.first, now.last),
    ({ id }) => id,
    (each, i) => row(each, now.first + i, { selected, active: each.id === now.active, problem, isTree }),
  );
  const [above, below] = [now.first, rows.length - now.last].map((count) => `${ROW * count}rem`);
  render(
    html`<div role="presentation" style="height:${above}"></div>${drawn}<div role="presentation" style="height:${below}"></div>`,
    list,
  );
  point(list, now.active);
  if (isFresh && selection.length === 1) later(list, session, () => reveal(list, session));
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

function rowsInSight(list: HTMLElement, rows: readonly Row[]): { first: number; last: number } {
  const height = rowHeight(list);
  const first = Math.max(0, Math.floor(list.scrollTop / height) - SPARE);
  const count = list.clientHeight > 0 ? Math.ceil(list.clientHeight / height) : FIRST;
  return { first, last: Math.min(rows.length, first + count + 2 * SPARE) };
}

const rowHeight = (list: HTMLElement): number => list.querySelector<HTMLElement>('.part')?.offsetHeight || 48;

interface RowLook {
  readonly selected: ReadonlySet<string>;
  readonly active: boolean;
  readonly problem: Problem;
  /** some rows can be opened */
  readonly isTree: boolean;
}

function row(each: Row, index: number, { selected, active, problem, isTree }: RowLook): TemplateResult {
  const { id, name, hidden, part, level, open } = each;
  const facts = factsOf(each);
  if (hidden) facts.push(PART_WORDS.hidden);
  if (level === 1)
    for (const { what } of hidden ? [] : flawsOf(part, problem)) facts.push(PART_WORDS.flaw[what]);
  const eye = hidden ? PART_WORDS.show(name) : PART_WORDS.hide(name);
  const unseen = hidden || part.hidden;
  return html`<div class="part ${unseen ? 'unseen' : ''} ${active ? 'active' : ''} ${isSolid(part) ? 'movable' : ''}" role="row" id="row-${id}" data-id=${id}
    style="--level:${level - 1}" aria-level=${level} aria-posinset=${each.at} aria-setsize=${each.of} aria-expanded=${open ?? nothing}
    aria-rowindex=${index + 1} aria-selected=${selected.has(id)} aria-label="${name}, ${facts.join(', ')}">
    <div role="gridcell" class="what ${isTree ? 'indented' : ''}">${open === null ? nothing : twist(name, open)}${icon(each.icon)}<span><b>${name}</b><small>${facts.join(' · ')}</small></span></div>
    <div role="gridcell"><button class="b eye" tabindex="-1" aria-label=${eye}>${icon(hidden ? 'eyeOff' : 'eye')}</button></div>
  </div>`;
}

const twist = (name: string, open: boolean): TemplateResult =>
  html`<button class="twist" tabindex="-1" aria-label=${open ? SOLID_WORDS.closed(name) : SOLID_WORDS.open(name)}>${icon(open ? 'down' : 'next', 20)}</button>`;

/** Scrolls the list, and nothing around it, to where the active row is in sight. */
function reveal(list: HTMLElement, session: Session): void {
  const active = shown.get(list)?.active;
  const at = rowsShown(session).findIndex(({ id }) => id === active);
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
  if (target.closest('.twist')) toggleOpen(session, id);
  else if (target.closest('button')) toggleShown(session, id);
  else if (event.ctrlKey || event.metaKey) choose(session, changed(session.selection, id));
  else if (event.shiftKey) choose(session, [...session.selection, ...between(session, id)]);
  else choose(session, [id]);
}

/** From what is selected to the part, as lists do. */
function between(session: Session, id: string): string[] {
  const { selection } = session;
  const rows = rowsShown(session);
  const ids = rows.map((each) => each.id);
  const to = ids.indexOf(id);
  const from = selection.length > 0 ? Math.max(0, ids.indexOf(selection[0]!)) : to;
  // of one level: who takes a solid takes what is in it
  return rows
    .slice(Math.min(from, to), Math.max(from, to) + 1)
    .filter(({ level }) => level === rows[to]?.level)
    .map((each) => each.id);
}

const changed = (ids: readonly string[], id: string): string[] =>
  ids.includes(id) ? ids.filter((other) => other !== id) : [...ids, id];

function toggleShown(session: Session, id: string): void {
  session.run({ type: 'showParts', ids: [id], visible: isHidden(session.document, [id]) });
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
  const rows = rowsShown(session);
  const at = rows.findIndex(({ id }) => id === shown.get(list)?.active);
  const id = rows[at]?.id;
  const page = Math.max(1, Math.floor(list.clientHeight / rowHeight(list)) - 1);
  const to =
    {
      ArrowDown: at + 1,
      ArrowUp: at - 1,
      PageDown: at + page,
      PageUp: at - page,
      Home: 0,
      End: rows.length - 1,
    }[event.key] ?? unfolded(event.key, rows, at, session);
  if (to !== undefined) return go(Math.min(rows.length - 1, Math.max(0, to)), event, list, session);
  if (event.key === 'F2') {
    list.closest('.panel')?.querySelector<HTMLInputElement>('input[type=text]')?.select();
    return true;
  }
  if (event.key === 'Delete' || event.key === 'Backspace') return remove(at, list, session);
  if (!id || (event.key !== 'Enter' && event.key !== ' ')) return false;
  choose(session, event.key === ' ' ? changed(session.selection, id) : [id]);
  return true;
}

/** Right opens, and then goes in; Left closes, or goes out. Undefined for other keys: the row that is next. */
function unfolded(key: string, rows: readonly Row[], at: number, session: Session): number | undefined {
  const now = rows[at];
  if (!now || (key !== 'ArrowRight' && key !== 'ArrowLeft')) return undefined;
  const opens = key === 'ArrowRight';
  if (now.open !== null && now.open !== opens) {
    toggleOpen(session, now.id);
    return at;
  }
  if (opens) return now.open ? at + 1 : at;
  const out = rows.findIndex(({ id }) => id === now.parent);
  return out < 0 ? at : out;
}

/** Arrows select as they go; with Shift they add, with Ctrl they only go. */
function go(to: number, event: KeyboardEvent, list: HTMLElement, session: Session): true {
  const id = rowsShown(session)[to]?.id;
  if (!id) return true;
  activate(list, session, id);
  if (event.shiftKey) choose(session, [...session.selection, id]);
  else if (!event.ctrlKey && !event.metaKey) choose(session, [id]);
  return true;
}

/** The row that takes the place of those that go is the active one next; after the last one the drawing has the focus. */
function remove(at: number, list: HTMLElement, session: Session): boolean {
  const rows = rowsShown(session);
  const gone = new Set(session.selection);
  const stays = ({ id, parent, part }: Row) => !gone.has(id) && !gone.has(parent ?? '') && !gone.has(part.id);
  const next = rows.slice(at).find(stays) ?? rows.slice(0, at).reverse().find(stays);
  if (!removeSelection(session)) return false;
  if (next) activate(list, session, next.id);
  else
    (list.getRootNode() as ParentNode).querySelector<HTMLElement>('.stage')?.focus({ preventScroll: true });
  return true;
}
