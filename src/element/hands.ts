/**
 * What hands do to the element: pointers on the stage, keys, the view ball. They go to the session; what is open and who
 * may draw is asked of the element.
 */
import { redrawOnce } from '../tool/redraw.ts';
import type { Pen } from '../tool/tool.ts';
import { type Actions, roundRadius } from './controls.ts';
import { press } from './keys.ts';
import type { PointerTarget } from './pointer.ts';
import type { Session } from './session.ts';
import { stepBack } from './stepBack.ts';
import { TOOLS } from './tools.ts';
import type { BallActions } from './viewBall.ts';
import { WORDS } from './words.ts';

export interface HandsHost extends Omit<Actions, 'open' | 'fingersDraw'> {
  open: Actions['open'];
  fingersDraw: boolean;
  readonly session: Session;
  readonly renderRoot: ParentNode;
  /** the ink as it is now, before the next frame */
  drawInk(): void;
}

export class Hands {
  /** where the pen is about to be, for the ink */
  predicted: readonly Pen[] = [];
  readonly #host: HandsHost;
  #penSeen = false;

  constructor(host: HandsHost) {
    this.#host = host;
  }

  /** What was being done is over. */
  rest(): void {
    this.predicted = [];
    stepBack(this.#host.renderRoot, null);
  }

  // ── pointers ────────────────────────────────────────────────────────────────────────────────────────

  target(): PointerTarget {
    const host = this.#host;
    const { session } = host;
    const { camera } = session;
    return {
      down: (pen) => this.#down(pen),
      move: (pens, predicted) => this.#move(pens, predicted),
      hover: (pen) => this.#hover(pen),
      erase: (pen) => this.#erase(pen),
      up: () => {
        this.rest();
        session.up();
      },
      cancel: () => {
        this.rest();
        session.cancel();
      },
      orbit: (dx, dy) => camera.orbit(dx, dy),
      pan: (dx, dy) => camera.pan(dx, dy),
      roll: (angle) => camera.roll(angle),
      zoom: (factor, x, y) => camera.zoom(factor, x, y),
      focus: () => this.#focus(),
      undo: () => host.readOnly || session.undo(),
      redo: () => host.readOnly || session.redo(),
      tap: (pen) => this.#tap(pen),
      looking: () => host.readOnly,
      penSeen: () => this.#seePen(),
      fingersDraw: () => host.fingersDraw,
    };
  }

  #down(pen: Pen): void {
    const { open, session } = this.#host;
    const stays = open === 'settings' || (open === 'parts' && session.tool === 'select');
    if (open && !stays) this.#host.open = null;
    session.down(pen);
    this.#host.drawInk();
  }

  /** The other end of the pen draws over what is under it; where that is nothing it takes the last stroke back. */
  #erase(pen: Pen): void {
    const { session } = this.#host;
    session.begin(redrawOnce(session.idle));
    this.#down(pen);
    if (!session.state.wet) session.undo();
  }

  #move(pens: readonly Pen[], predicted: readonly Pen[]): void {
    this.predicted = predicted;
    this.#host.session.move(pens);
    // At once, not with the frame: ink waits for nothing.
    this.#host.drawInk();
    stepBack(this.#host.renderRoot, pens.at(-1) ?? null);
  }

  #hover(pen: Pen | null): void {
    if (this.#host.readOnly) return;
    this.#host.session.hover(pen);
    if (this.#host.session.state.hover) this.#host.drawInk();
  }

  /** Where a finger or the pen only turns the view, a tap takes the part under it. */
  #tap(pen: Pen): void {
    const { session, readOnly } = this.#host;
    if (!readOnly && session.tool !== 'select') return;
    session.begin(TOOLS.select);
    session.down(pen);
    session.up();
    session.begin(session.idle);
  }

  #focus(): void {
    const { camera, selection, tool } = this.#host.session;
    if (tool === 'select' && selection.length > 0) camera.show(selection);
    else camera.showAll();
  }

  #seePen(): void {
    const host = this.#host;
    if (this.#penSeen || host.readOnly) return;
    this.#penSeen = true;
    const touch = navigator.maxTouchPoints > 0;
    host.fingersDraw = false;
    if (!touch) return;
    host.session.notice = {
      text: WORDS.penFound,
      actions: [{ label: WORDS.letFingersDraw, run: () => host.setFingersDraw(true) }],
    };
  }

  // ── the view ball, and keys ─────────────────────────────────────────────────────────────────────────

  ball(): BallActions {
    const { camera } = this.#host.session;
    return {
      orbit: (dx, dy) => camera.orbit(dx, dy),
      face: (axis) => camera.face(axis),
      reset: () => camera.reset(),
    };
  }

  key(event: KeyboardEvent): void {
    const host = this.#host;
    const origin = event.composedPath()[0] as HTMLElement;
    if (event.defaultPrevented || event.isComposing || isForeignField(origin, host.renderRoot)) return;
    if (origin.matches?.('input') && event.key !== 'Escape') {
      if (!(event.ctrlKey || event.metaKey) || !/^[so]$/i.test(event.key)) return;
      // What was typed is taken before it is saved.
      origin.blur();
    }
    // Enter and Space press the button that has the focus; letters are still hot keys there.
    if (origin.matches?.('button') && (event.key === 'Enter' || event.key === ' ')) return;
    // A panel that has the focus is what Escape is meant for.
    if (event.key === 'Escape' && origin.closest?.('.panel')) {
      host.dismiss();
      return;
    }
    const handled = press(event, host.session, {
      stepRadius: (direction) => this.#stepRadius(direction),
      toggleHelp: () => host.toggle('help'),
      close: () => host.dismiss(),
      readOnly: host.readOnly,
      save: (as) => void host.files.saving.save(as),
      openFile: () => void host.files.opening.choose(),
    });
    if (handled) event.preventDefault();
  }

  #stepRadius(direction: 1 | -1): void {
    const { session } = this.#host;
    const { radius } = session.document.brush;
    const step = radius + direction * (radius < 10 || (radius === 10 && direction < 0) ? 0.5 : 1);
    this.#host.setRadius(roundRadius(step), true);
  }
}

/** A field of the page, in a slot: what is typed there is not for the drawing. */
function isForeignField(origin: HTMLElement, own: ParentNode): boolean {
  if (own.contains(origin)) return false;
  return origin.isContentEditable || Boolean(origin.matches?.('input, textarea, select'));
}
