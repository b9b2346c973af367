/** A real pen for Chromium: the DevTools protocol sends pen events with pressure and tilt. */
import type { CDPSession, Page } from '@playwright/test';

export type Point = readonly [x: number, y: number];

export class PenDriver {
  readonly #session: CDPSession;
  readonly #pointer: 'pen' | 'mouse';

  private constructor(session: CDPSession, pointer: 'pen' | 'mouse') {
    this.#session = session;
    this.#pointer = pointer;
  }

  static async on(page: Page, pointer: 'pen' | 'mouse' = 'pen'): Promise<PenDriver> {
    return new PenDriver(await page.context().newCDPSession(page), pointer);
  }

  async #send(
    type: 'mousePressed' | 'mouseMoved' | 'mouseReleased',
    [x, y]: Point,
    force: number,
    button: 'left' | 'right' | 'none',
  ): Promise<void> {
    const buttons = { left: 1, right: 2, none: 0 }[type === 'mouseReleased' ? 'none' : button];
    const event = {
      type,
      x,
      y,
      button,
      buttons,
      clickCount: 1,
      pointerType: this.#pointer,
      force,
      tiltX: 20,
      tiltY: -10,
    };
    await this.#session.send('Input.dispatchMouseEvent', event);
  }

  async down(at: Point, button: 'left' | 'right' = 'left'): Promise<void> {
    await this.#send('mouseMoved', at, 0, 'none');
    await this.#send('mousePressed', at, 0.3, button);
  }

  async move(at: Point, force = 0.5, button: 'left' | 'right' | 'none' = 'left'): Promise<void> {
    await this.#send('mouseMoved', at, force, button);
  }

  async up(at: Point, button: 'left' | 'right' = 'left'): Promise<void> {
    await this.#send('mouseReleased', at, 0, button);
  }

  /** A stroke through the points: pressure swells and fades as a hand's does. */
  async draw(points: readonly Point[]): Promise<void> {
    await this.trace(points);
    await this.up(points.at(-1)!);
  }

  /** Sent without waiting for each answer, as a pen does: the browser coalesces what a frame cannot take. */
  async trace(points: readonly Point[]): Promise<void> {
    await this.down(points[0]!);
    const force = (i: number) => 0.35 + 0.35 * Math.sin((Math.PI * i) / points.length);
    await Promise.all(points.map((point, i) => this.move(point, force(i))));
  }
}

/**
 * `count` points of the cubic B-spline of a control polygon, from knot `from` to knot `to`: curvature without jumps,
 * as a practised hand draws, because bands of light show every jump.
 */
export function splineThrough(polygon: readonly Point[], from: number, to: number, count: number): Point[] {
  const n = polygon.length;
  return Array.from({ length: count }, (_, k) => {
    const t = from + ((to - from) * k) / (count - 1);
    const i = Math.floor(t);
    const s = t - i;
    const weights = [(1 - s) ** 3, 3 * s ** 3 - 6 * s ** 2 + 4, -3 * s ** 3 + 3 * s ** 2 + 3 * s + 1, s ** 3];
    const at = (axis: 0 | 1) =>
      weights.reduce((sum, w, j) => sum + (w / 6) * polygon[(i + j - 1 + 2 * n) % n]![axis], 0);
    return [at(0), at(1)];
  });
}

/** A hand is never still: up to 0.4 px beside the line, the ends where they were meant. */
export function trembling(line: readonly Point[], seed: number): Point[] {
  let state = seed * 2654435761;
  const random = () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32 - 0.5;
  };
  const inner = (i: number) => (i === 0 || i + 1 === line.length ? 0 : 0.8);
  return line.map(([x, y], i) => [x + inner(i) * random(), y + inner(i) * random()]);
}
