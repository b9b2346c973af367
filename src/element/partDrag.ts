/**
 * Rows of solids in the hand: dropped on a form or a component they blend with it, on a solid they are attached to it, between parts they are a
 * solid of their own. A mouse drags at once; a finger and a pen scroll, and drag after they rested.
 */
import { groupsChosen } from '../document/chosen.ts';
import { type Document, isSolid, type Joins } from '../document/document.ts';
import { placesFor } from './groupCard.ts';
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

/** As the card offers them. */
const changesAnything = (document: Document, ids: readonly string[], to: Joins | null): boolean =>
  placesFor(document, groupsChosen(document, ids)).some(
    (place) => place.to?.solid === to?.solid && place.to?.component === to?.component,
  );

/** What a drag needs of the list. */
export interface DragHost {
  readonly session: Session;
  rows(): readonly Row[];
  /** opens a row, or closes it */
  open(id: string): void;
  /** makes it the row that keys act on */
  activate(list: HTMLElement, id: string): void;
}

/** Begins when a pointer comes down on a row that can be dragged. */
export function dragRow(event: PointerEvent, host: DragHost): void {
  const target = event.target as Element;
  const id = target.closest<HTMLElement>('[role=row]')?.dataset.id;
  const row = host.rows().find((each) => each.id === id);
  if (event.button !== 0 || !event.isPrimary || !row || !isSolid(row.part) || target.closest('button'))
    return;
  new RowDrag(event, event.currentTarget as HTMLElement, row, host).listen();
}

class RowDrag {
  readonly #start: PointerEvent;
  readonly #list: HTMLElement;
  readonly #row: Row;
  readonly #host: DragHost;
  readonly #ids: readonly string[];
  readonly #over = new AbortController();
  #timer = 0;
  #drop: Drop | null = null;
  /** null: it has not begun */
  #tag: HTMLElement | null = null;
  /** over a closed row */
  #opening: { readonly id: string; readonly timer: number } | null = null;

  constructor(start: PointerEvent, list: HTMLElement, row: Row, host: DragHost) {
    [this.#start, this.#list, this.#row, this.#host] = [start, list, row, host];
    const { selection } = host.session;
    this.#ids = selection.includes(row.id) ? selection : [row.id];
    if (start.pointerType !== 'mouse') this.#timer = window.setTimeout(() => this.#begin(), REST);
  }

  listen(): void {
    const { signal } = this.#over;
    const own = (type: string, answer: (event: PointerEvent) => void) =>
      this.#list.addEventListener(
        type,
        (e) => (e as PointerEvent).pointerId === this.#start.pointerId && answer(e as PointerEvent),
        { signal },
      );
    own('pointermove', (e) => this.#move(e));
    own('pointerup', () => this.#end(this.#drop));
    for (const type of ['pointercancel', 'lostpointercapture']) own(type, () => this.#end(null));
    // a finger that drags does not scroll, nor does it ask for a menu
    this.#list.addEventListener('touchmove', (e) => this.#tag && e.preventDefault(), {
      signal,
      passive: false,
    });
    this.#list.addEventListener('contextmenu', (e) => e.preventDefault(), { signal });
    const elsewhere = { signal, capture: true };
    window.addEventListener('keydown', (e) => this.#key(e), elsewhere);
    window.addEventListener('pointerdown', () => this.#end(null), elsewhere);
    // let go where the list does not hear of it
    window.addEventListener('pointerup', () => this.#tag || this.#end(null), { signal });
  }

  #begin(): void {
    const { clientX, clientY, pointerId } = this.#start;
    this.#list.setPointerCapture(pointerId);
    this.#list.classList.add('dragging');
    this.#tag = tagIn(this.#list);
    this.#host.activate(this.#list, this.#row.id);
    this.#aim(clientX, clientY);
  }

  #move({ clientX, clientY }: PointerEvent): void {
    const start = this.#start;
    const isFar = Math.hypot(clientX - start.clientX, clientY - start.clientY) > SLOP;
    if (this.#tag) this.#aim(clientX, clientY);
    else if (isFar && start.pointerType === 'mouse') this.#begin();
    else if (isFar) this.#end(null);
  }

  #aim(x: number, y: number): void {
    if (!this.#tag) return;
    const list = this.#list;
    const { left, right, top, bottom } = list.getBoundingClientRect();
    if (y < top + SCROLL.edge) list.scrollTop -= SCROLL.by;
    if (y > bottom - SCROLL.edge) list.scrollTop += SCROLL.by;
    const height = list.querySelector<HTMLElement>('.part')?.offsetHeight || 48;
    const isOver = x > left - height && x < right + height && y > top - height && y < bottom + height;
    const rows = this.#host.rows();
    const at = Math.max(0, y - top + list.scrollTop) / height;
    this.#drop = isOver ? dropAt(this.#host.session.document, rows, this.#ids, at) : null;
    mark(list, this.#drop);
    show(this.#tag, x, y, this.#drop?.words ?? SOLID_WORDS.nowhere);
    this.#hover(isOver ? (rows[Math.floor(at)] ?? null) : null, () => this.#aim(x, y));
  }

  /** Over a closed row for a while: it opens. */
  #hover(row: Row | null, again: () => void): void {
    const id = row?.open === false ? row.id : null;
    if ((this.#opening?.id ?? null) === id) return;
    if (this.#opening) clearTimeout(this.#opening.timer);
    const open = () => {
      this.#host.open(id!);
      requestAnimationFrame(again);
    };
    this.#opening = id === null ? null : { id, timer: window.setTimeout(open, OPENS) };
  }

  #key(event: KeyboardEvent): void {
    if (!this.#tag || event.key !== 'Escape') return;
    event.preventDefault();
    event.stopPropagation();
    this.#end(null);
  }

  #end(drop: Drop | null): void {
    this.#over.abort();
    clearTimeout(this.#timer);
    if (this.#opening) clearTimeout(this.#opening.timer);
    if (!this.#tag) return;
    this.#tag.remove();
    this.#tag = null;
    mark(this.#list, null);
    this.#list.classList.remove('dragging');
    swallowClick(this.#list);
    if (drop) joinSelection(this.#host.session, this.#ids, drop.to);
  }
}

/** What ends a drag is no tap. */
function swallowClick(list: HTMLElement): void {
  list.addEventListener('click', swallow, { capture: true, once: true });
  setTimeout(() => list.removeEventListener('click', swallow, true));
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
