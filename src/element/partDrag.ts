/**
 * Rows of solids in the hand: dropped on a form or a component they blend with it, on a solid they are attached to it, between parts they are a
 * solid of their own. A mouse drags at once; a finger and a pen scroll, and drag after they rested.
 */
import { groupsChosen, groupsIn } from '../document/chosen.ts';
import { apply } from '../document/command/index.ts';
import { type Document, isSolid, type Joins } from '../document/document.ts';
import { joinSelection } from './partDeeds.ts';
import type { Row } from './partRows.ts';
import type { Session } from './session.ts';
import { SOLID_WORDS } from './words.ts';

/** px a mouse moves, and a finger may while it rests; ms it rests; ms over a closed row that then opens */
const SLOP = 6;
const REST = 400;
const OPENS = 600;
/** of a row's height: the edge that is the place between two */
const EDGE = 0.25;
/** px of the list's edge where it scrolls, and by how much each time the hand moves there */
const SCROLL = { edge: 28, by: 12 } as const;

export interface Drop {
  /** of the row, or of the one it lies beside */
  readonly id: string | null;
  readonly side: 'on' | 'before' | 'after';
  readonly to: Joins | null;
  readonly words: string;
}

/** What a drop of these ids does at a place of the list, in rows from its top; null: nothing. */
export function dropAt(
  document: Document,
  rows: readonly Row[],
  ids: readonly string[],
  y: number,
): Drop | null {
  const index = Math.floor(y);
  const row = rows[index];
  const found = row ? dropOn(row, y - index) : own(rows.at(-1)?.id ?? null, 'after');
  return changesAnything(document, ids, found.to) ? found : null;
}

function dropOn({ id, name, part, component, level, open }: Row, at: number): Drop {
  if (component) {
    const to = { solid: part.id, component: component.id };
    return { id, side: 'on', to, words: SOLID_WORDS.dropOn.blend(name) };
  }
  if (level === 1 && isSolid(part) && at > EDGE && (at < 1 - EDGE || open))
    return { id, side: 'on', to: { solid: id, component: null }, words: SOLID_WORDS.dropOn.attach(name) };
  return own(id, at < 0.5 ? 'before' : 'after');
}

const own = (id: string | null, side: Drop['side']): Drop => ({
  id,
  side,
  to: null,
  words: SOLID_WORDS.dropOn.own,
});

function changesAnything(document: Document, ids: readonly string[], to: Joins | null): boolean {
  const taken = groupsChosen(document, ids);
  const [first] = taken;
  if (!first) return false;
  const isAll = taken.every(({ component }) => component === first.component);
  if (!to) return !(isAll && groupsIn(first.solid).length === taken.length);
  const groups = taken.map(({ group }) => group.id);
  return apply(document, { type: 'moveGroups', ids: groups, to }) !== document;
}

interface Drag {
  readonly ids: readonly string[];
  drop: Drop | null;
  /** over a closed row */
  opening: { readonly id: string; readonly timer: number } | null;
  readonly tag: HTMLElement;
}

export function dragRow(
  event: PointerEvent,
  session: Session,
  rowsShown: (session: Session) => readonly Row[],
  open: (session: Session, id: string) => void,
  activate: (id: string) => void,
): void {
  const list = event.currentTarget as HTMLElement;
  const target = event.target as Element;
  const id = target.closest<HTMLElement>('[role=row]')?.dataset.id;
  const row = rowsShown(session).find((each) => each.id === id);
  if (event.button !== 0 || !event.isPrimary || !row || !isSolid(row.part) || target.closest('button'))
    return;
  const { pointerId, clientX, clientY } = event;
  const over = new AbortController();
  const { signal } = over;
  const isMouse = event.pointerType === 'mouse';
  const ids = session.selection.includes(row.id) ? session.selection : [row.id];
  let drag: Drag | null = null;
  const timer = isMouse ? 0 : window.setTimeout(() => begin(), REST);

  const begin = () => {
    list.setPointerCapture(pointerId);
    list.classList.add('dragging');
    activate(row.id);
    drag = { ids, drop: null, opening: null, tag: tagIn(list) };
    aim(clientX, clientY);
  };
  const aim = (x: number, y: number) => {
    if (!drag) return;
    const box = list.getBoundingClientRect();
    if (y < box.top + SCROLL.edge) list.scrollTop -= SCROLL.by;
    if (y > box.bottom - SCROLL.edge) list.scrollTop += SCROLL.by;
    const height = list.querySelector<HTMLElement>('.part')?.offsetHeight || 48;
    const isOver =
      x > box.left - height && x < box.right + height && y > box.top - height && y < box.bottom + height;
    const rows = rowsShown(session);
    const at = Math.max(0, y - box.top + list.scrollTop) / height;
    drag.drop = isOver ? dropAt(session.document, rows, drag.ids, at) : null;
    mark(list, drag.drop);
    show(drag.tag, x, y, drag.drop?.words ?? SOLID_WORDS.nowhere);
    hover(drag, isOver ? (rows[Math.floor(at)] ?? null) : null, (closed) => {
      open(session, closed);
      requestAnimationFrame(() => aim(x, y));
    });
  };
  const end = (drop: Drop | null) => {
    over.abort();
    clearTimeout(timer);
    if (!drag) return;
    if (drag.opening) clearTimeout(drag.opening.timer);
    drag.tag.remove();
    mark(list, null);
    list.classList.remove('dragging');
    drag = null;
    // what ends a drag is no tap
    list.addEventListener('click', swallow, { capture: true, once: true });
    setTimeout(() => list.removeEventListener('click', swallow, true));
    if (drop) joinSelection(session, ids, drop.to);
  };
  const own = (type: string, answer: (event: PointerEvent) => void) =>
    list.addEventListener(
      type,
      (e) => (e as PointerEvent).pointerId === pointerId && answer(e as PointerEvent),
      { signal },
    );
  own('pointermove', (e) => {
    const isFar = Math.hypot(e.clientX - clientX, e.clientY - clientY) > SLOP;
    if (drag) aim(e.clientX, e.clientY);
    else if (isFar && isMouse) begin();
    else if (isFar) end(null);
  });
  own('pointerup', () => end(drag?.drop ?? null));
  for (const type of ['pointercancel', 'lostpointercapture']) own(type, () => end(null));
  list.addEventListener('touchmove', (e) => drag && e.preventDefault(), { signal, passive: false });
  list.addEventListener('contextmenu', (e) => e.preventDefault(), { signal });
  const quit = (e: KeyboardEvent) => {
    if (!drag || e.key !== 'Escape') return;
    e.preventDefault();
    e.stopPropagation();
    end(null);
  };
  window.addEventListener('keydown', quit, { signal, capture: true });
  const other = (e: PointerEvent) => e.pointerId !== pointerId && end(null);
  window.addEventListener('pointerdown', other, { signal, capture: true });
  // let go where the list does not hear of it
  window.addEventListener('pointerup', (e) => e.pointerId === pointerId && !drag && end(null), { signal });
}

function swallow(event: Event): void {
  event.preventDefault();
  event.stopPropagation();
}

function tagIn(list: HTMLElement): HTMLElement {
  const tag = document.createElement('span');
  tag.className = 'drag-tag';
  tag.setAttribute('aria-hidden', 'true');
  list.closest('.app')!.append(tag);
  return tag;
}

function show(tag: HTMLElement, x: number, y: number, words: string): void {
  const frame = tag.parentElement!.getBoundingClientRect();
  tag.textContent = words;
  tag.style.right = `${frame.right - x + 12}px`;
  tag.style.top = `${y - frame.top - 40}px`;
}

/** Rows are drawn by templates, which know nothing of this attribute. */
function mark(list: HTMLElement, drop: Drop | null): void {
  for (const marked of list.querySelectorAll('[data-drop]')) marked.removeAttribute('data-drop');
  const at = drop?.id && list.querySelector(`[data-id="${CSS.escape(drop.id)}"]`);
  if (at && drop) at.setAttribute('data-drop', drop.side);
}

function hover(drag: Drag, row: Row | null, open: (id: string) => void): void {
  const id = row?.open === false ? row.id : null;
  if (drag.opening?.id === id) return;
  if (drag.opening) clearTimeout(drag.opening.timer);
  drag.opening = id === null ? null : { id, timer: window.setTimeout(() => open(id), OPENS) };
}
