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

  async move(at: Point, force = 0.5, button: 'left' | 'right' = 'left'): Promise<void> {
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

/** Evenly counted points of a curve through the given ones: Catmull–Rom, refined until its bends are smooth. */
export function smoothThrough(points: readonly Point[], count: number): Point[] {
  let line = [...points];
  // Four-point subdivision: interpolating, and without the jumps of curvature that bands of light would show.
  for (let level = 0; level < 6; level++)
    line = line.flatMap((p, i) => (i + 1 < line.length ? [p, between(line, i)] : [p]));
  for (let pass = 0; pass < 60; pass++)
    line = line.map((p, i) => (i === 0 || i + 1 === line.length ? p : relaxed(line, i)));
  return Array.from({ length: count }, (_, i) => line[Math.round((i * (line.length - 1)) / (count - 1))]!);
}

function between(line: readonly Point[], i: number): Point {
  const mirror = (end: Point, next: Point): Point => [2 * end[0] - next[0], 2 * end[1] - next[1]];
  const b = line[i]!;
  const c = line[i + 1]!;
  const a = line[i - 1] ?? mirror(b, c);
  const d = line[i + 2] ?? mirror(c, b);
  const at = (k: 0 | 1) => (9 * (b[k] + c[k]) - a[k] - d[k]) / 16;
  return [at(0), at(1)];
}

function relaxed(line: readonly Point[], i: number): Point {
  const at = (k: 0 | 1) => (line[i - 1]![k] + 2 * line[i]![k] + line[i + 1]![k]) / 4;
  return [at(0), at(1)];
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
