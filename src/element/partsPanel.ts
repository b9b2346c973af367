/**
 * The list of the parts, and what can be set of those that are selected. The list is drawn anew only when parts or
 * selection change, not with every move of the camera, and rows out of sight are not laid out: a thousand parts
 * cost nothing while one looks around.
 *
 * A grid rather than a list box: its rows hold a button that hides, and a list box's options must not.
 */
import { html, type TemplateResult } from 'lit';
import { guard } from 'lit/directives/guard.js';
import { ref } from 'lit/directives/ref.js';
import { repeat } from 'lit/directives/repeat.js';
import type { Part } from '../document/document.ts';
import type { Actions } from './controls.ts';
import { icon } from './icons.ts';
import { frame } from './panelFrame.ts';
import { partCard } from './partCard.ts';
import type { Session } from './session.ts';
import { PART_WORDS, SURFACE } from './words.ts';

export function partsPanel(session: Session, actions: Actions): TemplateResult {
  const { parts } = session.document;
  const body =
    parts.length === 0
      ? html`<p class="quiet-words">${PART_WORDS.none}</p>`
      : html`${list(session)} ${partCard(session)}`;
  return frame('Parts', 'parts', actions, body);
}

function list(session: Session): TemplateResult {
  const { selection } = session;
  const { parts } = session.document;
  return html`<div class="part-list" role="grid" aria-label=${PART_WORDS.list} aria-multiselectable="true"
    @click=${(event: MouseEvent) => click(event, session)} @keydown=${(event: KeyboardEvent) => press(event, session)}>
    ${guard([parts, selection], () => rows(parts, new Set(selection)))}
  </div>`;
}

function rows(parts: readonly Part[], selected: ReadonlySet<string>): unknown {
  const reached = parts.find(({ id }) => selected.has(id)) ?? parts[0];
  return repeat(
    parts,
    ({ id }) => id,
    (part) => row(part, selected.has(part.id), part === reached, selected.size === 1),
  );
}

function row(part: Part, selected: boolean, reached: boolean, alone: boolean): TemplateResult {
  const { id, name, kind, strokes, hidden } = part;
  const facts = [SURFACE[kind].name, PART_WORDS.strokes(strokes.length)];
  if (hidden) facts.push(PART_WORDS.hidden);
  const image = hidden ? 'eyeOff' : 'eye';
  return html`<div class="part ${hidden ? 'unseen' : ''}" role="row" aria-selected=${selected} aria-label="${name}, ${facts.join(', ')}"
    tabindex=${reached ? 0 : -1} data-id=${id} ${selected && alone ? ref(reveal) : ref()}>
    <div role="gridcell" class="what">${icon(kind)}<span><b>${name}</b><small>${facts.join(' · ')}</small></span></div>
    <div role="gridcell"><button class="b" tabindex="-1" aria-label=${hidden ? PART_WORDS.show(name) : PART_WORDS.hide(name)}>${icon(image)}</button></div>
  </div>`;
}

/** Scrolls the list and nothing around it. */
function reveal(found: Element | undefined): void {
  requestAnimationFrame(() => {
    const list = found?.parentElement;
    if (!list) return;
    const [box, frame] = [found.getBoundingClientRect(), list.getBoundingClientRect()];
    if (box.top < frame.top) list.scrollTop += box.top - frame.top;
    else if (box.bottom > frame.bottom) list.scrollTop += box.bottom - frame.bottom;
  });
}

const rowOf = (event: Event): HTMLElement | null =>
  (event.target as Element).closest<HTMLElement>('[role=row]');

function click(event: MouseEvent, session: Session): void {
  const row = rowOf(event);
  const id = row?.dataset.id;
  if (!row || !id) return;
  if ((event.target as Element).closest('button')) toggleShown(session, id);
  else if (event.ctrlKey || event.metaKey) choose(session, toggled(session.selection, id));
  else if (event.shiftKey) choose(session, [...session.selection, ...between(session, id)]);
  else choose(session, [id]);
  row.focus({ preventScroll: true });
}

/** From what is selected to the part, as lists do. */
function between({ document, selection }: Session, id: string): string[] {
  const ids = document.parts.map((part) => part.id);
  const from = selection.length > 0 ? ids.indexOf(selection[0]!) : ids.indexOf(id);
  const to = ids.indexOf(id);
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

function press(event: KeyboardEvent, session: Session): void {
  const row = rowOf(event);
  const id = row?.dataset.id;
  if (!row || !id || !answer(event, row, id, session)) return;
  event.preventDefault();
  event.stopPropagation();
}

/** True when the list has an answer to the key. */
function answer(event: KeyboardEvent, row: HTMLElement, id: string, session: Session): boolean {
  const onButton = (event.target as Element).closest('button') !== null;
  const rows = [...(row.parentElement?.querySelectorAll<HTMLElement>('[role=row]') ?? [])];
  const at = rows.indexOf(row);
  const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: rows.length - 1 }[event.key];
  if (to !== undefined) return go(rows[to], event, session);
  switch (event.key) {
    case 'ArrowRight':
      row.querySelector<HTMLElement>('button')?.focus();
      return true;
    case 'ArrowLeft':
      row.focus();
      return true;
    case 'Enter':
    case ' ':
      if (onButton) return false;
      choose(session, event.key === ' ' ? toggled(session.selection, id) : [id]);
      return true;
    case 'F2':
      row.closest('.panel')?.querySelector<HTMLInputElement>('input[type=text]')?.select();
      return true;
    case 'Delete':
    case 'Backspace':
      remove(rows, at, session);
      return true;
    default:
      return false;
  }
}

/** Arrows select as they go; with Shift they add, with Ctrl they only go. */
function go(row: HTMLElement | undefined, event: KeyboardEvent, session: Session): true {
  const id = row?.dataset.id;
  if (!row || !id) return true;
  row.focus();
  if (event.shiftKey) choose(session, [...session.selection, id]);
  else if (!event.ctrlKey && !event.metaKey) choose(session, [id]);
  return true;
}

/** The row that takes the place of those that go has the focus next. */
function remove(rows: readonly HTMLElement[], at: number, session: Session): void {
  const gone = new Set(session.selection);
  const stays = (row: HTMLElement) => !gone.has(row.dataset.id ?? '');
  const next = rows.slice(at).find(stays) ?? rows.slice(0, at).reverse().find(stays);
  if (gone.size === 0) return;
  session.run({ type: 'removeParts', ids: session.selection });
  const stage = (rows[at]?.getRootNode() as ParentNode | undefined)?.querySelector<HTMLElement>('.stage');
  (next ?? stage)?.focus({ preventScroll: true });
}
