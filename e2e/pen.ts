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

/** Points along cubic Béziers written as in SVG: `M x y C …`, absolute. */
export function alongPath(path: string, place: (p: Point) => Point, perCurve = 14): Point[] {
  const numbers = path.match(/-?[\d.]+/g)!.map(Number);
  const knots: Point[] = [];
  for (let i = 0; i + 1 < numbers.length; i += 2) knots.push([numbers[i]!, numbers[i + 1]!]);
  const points: Point[] = [place(knots[0]!)];
  for (let k = 0; k + 3 < knots.length; k += 3) {
    for (let i = 1; i <= perCurve; i++) points.push(place(bezier(knots.slice(k, k + 4), i / perCurve)));
  }
  return points;
}

function bezier([a, b, c, d]: readonly Point[], t: number): Point {
  const s = 1 - t;
  const at = (i: 0 | 1) => s ** 3 * a![i] + 3 * s * s * t * b![i] + 3 * s * t * t * c![i] + t ** 3 * d![i];
  return [at(0), at(1)];
}
