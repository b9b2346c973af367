/**
 * Pen, fingers and mouse become strokes and camera moves. A pen draws; once one was seen fingers navigate; two
 * fingers always pan, pinch and twist; taps with two and three undo and redo. Whatever interrupts a stroke (second
 * finger, palm, lost pointer) cancels it: it is never committed by accident. Where people may only look, whatever
 * would draw turns the view, and a tap selects.
 */
import type { Pen } from '../tool/tool.ts';

export interface PointerTarget {
  down(pen: Pen): void;
  move(pens: readonly Pen[], predicted: readonly Pen[]): void;
  /** over the picture, not on it; null: it left */
  hover(pen: Pen | null): void;
  up(): void;
  /** as `down`, with the other end of the pen */
  erase(pen: Pen): void;
  cancel(): void;
  /** camera moves, CSS pixels and radians */
  orbit(dx: number, dy: number): void;
  pan(dx: number, dy: number): void;
  roll(angle: number): void;
  zoom(factor: number, x: number, y: number): void;
  focus(): void;
  undo(): void;
  redo(): void;
  /** a tap of what turns the view */
  tap(pen: Pen): void;
  penSeen(): void;
  fingersDraw(): boolean;
  /** nothing may be drawn */
  looking(): boolean;
}

const TAP = { milliseconds: 250, pixels: 10 } as const;
const PREDICTION_PIXELS = 40;

interface Finger {
  x: number;
  y: number;
}

type Mode = 'none' | 'draw' | 'turn' | 'pan' | 'roll' | 'two' | 'three' | 'ignore';

export class PointerRouter {
  #mode: Mode = 'none';
  #drawing: PointerEvent | null = null;
  /** the pen or mouse that is down, whatever it does */
  #owner: number | null = null;
  #last: Finger = { x: 0, y: 0 };
  readonly #fingers = new Map<number, Finger>();
  #tap = { start: 0, most: 0, moved: 0, previous: -Infinity };
  readonly #canvas: HTMLElement;
  readonly #target: PointerTarget;
  readonly #stop = new AbortController();

  constructor(canvas: HTMLElement, target: PointerTarget) {
    this.#canvas = canvas;
    this.#target = target;
    const on = <T extends Event>(type: string, handler: (event: T) => void) =>
      canvas.addEventListener(type, handler as (event: Event) => void, {
        signal: this.#stop.signal,
        passive: false,
      });
    on<PointerEvent>('pointerdown', (event) => this.#down(event));
    on<PointerEvent>('pointermove', (event) => this.#move(event));
    on<PointerEvent>('pointerup', (event) => this.#up(event));
    on<PointerEvent>('pointerleave', (event) => this.#leave(event));
    on<PointerEvent>('pointercancel', (event) => this.#lost(event));
    on<PointerEvent>('lostpointercapture', (event) => this.#lost(event));
    on<WheelEvent>('wheel', (event) => this.#wheel(event));
    for (const type of ['contextmenu', 'touchstart', 'gesturestart'])
      on<Event>(type, (event) => event.preventDefault());
  }

  dispose(): void {
    this.#stop.abort();
  }

  #at(event: MouseEvent): Finger {
    const box = this.#canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  #pen(event: PointerEvent): Pen {
    const pointer =
      event.pointerType === 'pen' || event.pointerType === 'touch' ? event.pointerType : 'mouse';
    return {
      ...this.#at(event),
      // Fingers and mice report 0, 0.5 or 1 whatever the hand does.
      pressure: pointer === 'pen' ? event.pressure : 0.5,
      tiltX: event.tiltX,
      tiltY: event.tiltY,
      time: event.timeStamp,
      pointer,
      adds: event.shiftKey || event.ctrlKey || event.metaKey,
    };
  }

  #down(event: PointerEvent): void {
    event.preventDefault();
    this.#canvas.focus({ preventScroll: true });
    if (event.pointerType === 'touch') this.#fingerDown(event);
    else if (this.#owner === null) this.#penDown(event);
  }

  #penDown(event: PointerEvent): void {
    if (event.pointerType === 'pen') {
      // A palm that lay down just before the pen had begun a stroke of its own.
      if (this.#fingers.size > 0) this.#endFingers();
    }
    this.#canvas.setPointerCapture(event.pointerId);
    this.#owner = event.pointerId;
    this.#last = this.#at(event);
    this.#mode = buttonMode(event);
    // the other end of the pen
    if (event.pointerType === 'pen' && event.button === 5 && !this.#target.looking()) {
      this.#mode = 'draw';
      this.#drawing = event;
      this.#target.erase(this.#pen(event));
    } else if (this.#mode === 'draw' && this.#target.looking()) this.#look(event);
    else if (this.#mode === 'draw') this.#begin(event);
    if (event.pointerType === 'pen') this.#target.penSeen();
  }

  #look(event: PointerEvent): void {
    this.#mode = 'turn';
    this.#tap = { ...this.#tap, start: event.timeStamp, most: 1, moved: 0 };
  }

  #begin(event: PointerEvent): void {
    this.#mode = 'draw';
    this.#drawing = event;
    this.#target.down(this.#pen(event));
  }

  #move(event: PointerEvent): void {
    if (event.pointerType === 'touch') {
      this.#fingerMove(event);
      return;
    }
    if (this.#owner === null && this.#fingers.size === 0 && event.buttons === 0) {
      this.#target.hover(this.#pen(event));
      return;
    }
    const before = this.#last;
    this.#last = this.#at(event);
    this.#tap.moved += Math.hypot(this.#last.x - before.x, this.#last.y - before.y);
    this.#drag(before, this.#last, event);
  }

  /** Fingers do not hover: their leaving is the end of a gesture. */
  #leave(event: PointerEvent): void {
    if (event.pointerType !== 'touch' && this.#owner === null) this.#target.hover(null);
  }

  #drag(a: Finger, b: Finger, event: PointerEvent): void {
    if (this.#mode === 'draw' && event.pointerId === this.#drawing?.pointerId) this.#stroke(event);
    if (this.#mode === 'turn') this.#target.orbit(b.x - a.x, b.y - a.y);
    if (this.#mode === 'pan') this.#target.pan(b.x - a.x, b.y - a.y);
    if (this.#mode === 'roll') this.#target.roll(this.#angleBetween(a, b));
  }

  #stroke(event: PointerEvent): void {
    const all = event.getCoalescedEvents?.() ?? [];
    const predicted = event.getPredictedEvents?.() ?? [];
    const pens = (all.length ? all : [event]).map((e) => this.#pen(e));
    const { x, y } = this.#at(event);
    // After a pause of the page a prediction can shoot far ahead of the pen.
    const near = (pen: Pen) => Math.hypot(pen.x - x, pen.y - y) < PREDICTION_PIXELS;
    this.#target.move(pens, predicted.map((e) => this.#pen(e)).filter(near));
  }

  #angleBetween(a: Finger, b: Finger): number {
    const { clientWidth: w, clientHeight: h } = this.#canvas;
    const angle = ({ x, y }: Finger) => Math.atan2(y - h / 2, x - w / 2);
    return turn(angle(b) - angle(a));
  }

  #up(event: PointerEvent): void {
    if (event.pointerType === 'touch') {
      this.#fingerUp(event);
      return;
    }
    if (event.pointerId !== this.#owner) return;
    if (this.#mode === 'draw' && event.pointerId === this.#drawing?.pointerId) this.#finish(event);
    if (this.#mode === 'turn' && event.button === 0) this.#tapped(event);
    this.#owner = null;
    this.#mode = 'none';
  }

  #finish(event: PointerEvent): void {
    // Where the pen left is where it last was: the event of leaving is a sample too.
    this.#target.move([{ ...this.#pen(event), pressure: this.#pen(this.#drawing ?? event).pressure }], []);
    this.#drawing = null;
    this.#target.up();
  }

  #lost(event: PointerEvent): void {
    this.#fingers.delete(event.pointerId);
    if (this.#drawing?.pointerId === event.pointerId) {
      this.#drawing = null;
      this.#target.cancel();
    }
    // A palm that was ignored is lost, too: it must not end what the pen does.
    if (event.pointerId === this.#owner) this.#owner = null;
    if (this.#owner === null && this.#fingers.size === 0) this.#mode = 'none';
  }

  #wheel(event: WheelEvent): void {
    event.preventDefault();
    const { x, y } = this.#at(event);
    const pixels = event.deltaMode === 1 ? event.deltaY * 16 : event.deltaY;
    // A pinch on a trackpad arrives as a wheel with Ctrl, in much smaller steps.
    this.#target.zoom(Math.exp(-pixels * (event.ctrlKey ? 0.01 : 0.0015)), x, y);
  }

  // ── fingers ─────────────────────────────────────────────────────────────────────────────────────────

  #fingerDown(event: PointerEvent): void {
    if (this.#owner !== null) return;
    this.#canvas.setPointerCapture(event.pointerId);
    this.#fingers.set(event.pointerId, this.#at(event));
    const count = this.#fingers.size;
    if (count === 1) this.#tap = { ...this.#tap, start: event.timeStamp, most: 1, moved: 0 };
    this.#tap.most = Math.max(this.#tap.most, count);
    if (count === 1 && this.#target.fingersDraw() && !this.#target.looking()) this.#begin(event);
    else if (count === 1) this.#mode = 'turn';
    else this.#toFingers(count);
  }

  #toFingers(count: number): void {
    if (this.#drawing) {
      this.#drawing = null;
      this.#target.cancel();
    }
    this.#mode = count === 2 ? 'two' : 'three';
  }

  #fingerMove(event: PointerEvent): void {
    const finger = this.#fingers.get(event.pointerId);
    if (!finger) return;
    const before = [...this.#fingers.values()].map((f) => ({ ...f }));
    const now = this.#at(event);
    const a = { ...finger };
    this.#tap.moved += Math.hypot(now.x - a.x, now.y - a.y);
    Object.assign(finger, now);
    const after = [...this.#fingers.values()];
    if (this.#mode === 'two') this.#pinch(before, after);
    else if (this.#mode === 'three') this.#target.orbit((now.x - a.x) / 3, (now.y - a.y) / 3);
    else this.#drag(a, now, event);
  }

  /** Pan, pinch and twist together. */
  #pinch(before: Finger[], after: Finger[]): void {
    const [a, b] = before;
    const [c, d] = after;
    if (!a || !b || !c || !d) return;
    const middle = (p: Finger, q: Finger) => ({ x: (p.x + q.x) / 2, y: (p.y + q.y) / 2 });
    const span = (p: Finger, q: Finger) => Math.max(1, Math.hypot(q.x - p.x, q.y - p.y));
    const angle = (p: Finger, q: Finger) => Math.atan2(q.y - p.y, q.x - p.x);
    const from = middle(a, b);
    const to = middle(c, d);
    this.#target.pan(to.x - from.x, to.y - from.y);
    this.#target.zoom(span(c, d) / span(a, b), to.x, to.y);
    this.#target.roll(turn(angle(c, d) - angle(a, b)));
  }

  #fingerUp(event: PointerEvent): void {
    if (!this.#fingers.delete(event.pointerId)) return;
    if (this.#mode === 'draw' && this.#drawing?.pointerId === event.pointerId) this.#finish(event);
    if (this.#fingers.size === 0) {
      this.#tapped(event);
      this.#mode = 'none';
    } else this.#mode = 'ignore';
  }

  #tapped(event: PointerEvent): void {
    const now = event.timeStamp;
    const { start, most, moved, previous } = this.#tap;
    if (moved > TAP.pixels) return;
    const one = most === 1 && this.#mode === 'turn';
    if (one) this.#target.tap(this.#pen(event));
    if (now - start > TAP.milliseconds) return;
    if (most === 2) this.#target.undo();
    if (most === 3) this.#target.redo();
    if (!one) return;
    if (now - previous < 2 * TAP.milliseconds) this.#target.focus();
    this.#tap.previous = now;
  }

  /** A pen lands: what the hand did is forgotten, and a stroke it had begun is withdrawn. */
  #endFingers(): void {
    this.#fingers.clear();
    this.#mode = 'none';
    if (!this.#drawing) return;
    this.#drawing = null;
    this.#target.cancel();
  }
}

/** The thesis' bindings: left draws, right turns, Ctrl with right pans, the middle rolls. */
function buttonMode(event: PointerEvent): Mode {
  if (event.button === 0) return 'draw';
  if (event.button === 1 || (event.button === 2 && event.altKey)) return 'roll';
  if (event.button === 2) return event.ctrlKey || event.metaKey ? 'pan' : 'turn';
  return 'ignore';
}

const turn = (angle: number) => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
