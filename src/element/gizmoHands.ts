/**
 * Hands on the handles: a drag of one pointer, or arrow keys that stay down. Both are the same gesture of the tool, so
 * both are shown while they last, one undo step when they end, and gone without a trace when they are cancelled.
 */
import { middleOfParts, seenParts } from '../document/extent.ts';
import type { Vec3 } from '../math/vec.ts';
import { grip, type Handle, penBeside } from '../tool/move.ts';
import type { Pen, State } from '../tool/tool.ts';
import type { Session } from './session.ts';

/** mm a press of an arrow key moves, and with Shift */
const STEP = { plain: 1, shift: 10 } as const;

export const dragHandle = (event: PointerEvent, session: Session, handle: Handle): void =>
  dragState(event, session, grip(handle, session.idle));

/** A drag of one pointer from what it came down on, as a gesture that begins with `state`. */
export function dragState(event: PointerEvent, session: Session, state: State, after = () => {}): void {
  if (event.button !== 0) return;
  const button = event.currentTarget as Element;
  const { pointerId } = event;
  const frame = button.closest('.app')!;
  const ended = new AbortController();
  const { signal } = ended;
  const over = (finish: () => void) => {
    ended.abort();
    finish();
    after();
  };
  const own = (type: string, answer: (event: PointerEvent) => void) =>
    button.addEventListener(
      type,
      (e) => (e as PointerEvent).pointerId === pointerId && answer(e as PointerEvent),
      { signal },
    );
  event.stopPropagation();
  button.setPointerCapture(pointerId);
  session.begin(state);
  session.down(penOf(event, frame));
  own('pointermove', (e) => session.move([penOf(e, frame)]));
  own('pointerup', (e) =>
    over(() => {
      session.move([penOf(e, frame)]);
      session.up();
    }),
  );
  for (const type of ['pointercancel', 'lostpointercapture']) own(type, () => over(() => session.cancel()));
  const other = (e: Event) => {
    // A second finger cancels, and begins nothing of its own.
    if ((e as PointerEvent).pointerId === pointerId) return;
    e.stopPropagation();
    e.preventDefault();
    over(() => session.cancel());
  };
  frame.addEventListener('pointerdown', other, { signal, capture: true });
}

export function penOf(event: PointerEvent, frame: Element): Pen {
  const box = frame.getBoundingClientRect();
  const { pointerType, pressure, tiltX, tiltY, timeStamp: time } = event;
  const pointer = pointerType === 'pen' || pointerType === 'touch' ? pointerType : 'mouse';
  return {
    x: event.clientX - box.left,
    y: event.clientY - box.top,
    pressure,
    tiltX,
    tiltY,
    time,
    pointer,
    adds: event.shiftKey,
  };
}

interface Held {
  readonly handle: Handle;
  readonly middle: Vec3;
  /** mm so far */
  right: number;
  up: number;
}

const held = new WeakMap<Session, Held>();

const ARROWS: Readonly<Record<string, readonly [right: number, up: number]>> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** As long as the key is down it is one move. */
export function keyHandle(event: KeyboardEvent, session: Session, handle: Handle): void {
  const arrow = ARROWS[event.key];
  if (!arrow) return;
  event.preventDefault();
  event.stopPropagation();
  const hold = holding(session, handle);
  if (!hold) return;
  const step = event.shiftKey ? STEP.shift : STEP.plain;
  hold.right += step * arrow[0];
  hold.up += step * arrow[1];
  const at = penBeside(session, handle, hold.middle, hold.right, hold.up);
  if (at) session.move([penAt(at, event)]);
}

function holding(session: Session, handle: Handle): Held | null {
  const known = held.get(session);
  if (known?.handle === handle && session.state.carried) return known;
  const middle = middleOfParts(seenParts(session.document, session.selection));
  const at = middle && penBeside(session, handle, middle, 0, 0);
  if (!middle || !at) return null;
  session.begin(grip(handle, session.idle));
  session.down(penAt(at, { timeStamp: 0 }));
  const hold = { handle, middle, right: 0, up: 0 };
  held.set(session, hold);
  return hold;
}

const penAt = (
  [x, y]: readonly [number, number],
  { timeStamp: time }: { readonly timeStamp: number },
): Pen => ({
  x,
  y,
  pressure: 0.5,
  tiltX: 0,
  tiltY: 0,
  time,
  pointer: 'mouse',
});

const focused = new WeakSet<Session>();

/** One of the handles has the focus. */
export const hasFocus = (session: Session): boolean => focused.has(session);

export function takeFocus(session: Session): void {
  focused.add(session);
}

/** The key is up, or the handle has lost the focus. */
export function letGo(session: Session, event?: KeyboardEvent): void {
  if (event && !(event.key in ARROWS)) return;
  if (!event) focused.delete(session);
  if (!held.delete(session) || !session.state.carried) return;
  session.up();
}
