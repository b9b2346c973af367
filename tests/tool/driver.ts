/** A drawing without a screen: the tool on a real document, with a picture of 800 × 600 px and 200 mm. */
import type { Command } from '../../src/document/command/index.ts';
import type { Document } from '../../src/document/document.ts';
import { commit, type History, newHistory, undo } from '../../src/document/history.ts';
import type { View } from '../../src/stroke/stroke.ts';
import { idle } from '../../src/tool/draw.ts';
import type { Bench, Notice, Pen, State } from '../../src/tool/tool.ts';
import type { Hit, Viewport } from '../../src/tool/viewport.ts';

export class Driver implements Bench {
  history: History = newHistory();
  state: State = idle;
  view: View = { pivot: [0, 0, 0], rotation: [0, 0, 0, 1], height: 200, fov: 0 };
  readonly size = { width: 800, height: 600 };
  readonly notices: Notice[] = [];
  /** what was offered with the last one */
  offer: readonly Command[] = [];
  /** from where it can be done */
  from: View | null = null;
  hit: Hit | null = null;
  /** in place of `hit`: what lies under a place of the picture */
  surface: Viewport['pick'] | null = null;
  /** what the camera was brought to */
  readonly focused: (readonly string[])[] = [];
  selection: readonly string[] = [];

  get document(): Document {
    return this.history.present;
  }

  get goal(): View {
    return this.view;
  }

  get viewport(): this {
    return this;
  }

  pick(x: number, y: number, except?: readonly string[]): Hit | null {
    return this.surface ? this.surface(x, y, except) : this.hit;
  }

  focus(ids: readonly string[]): void {
    this.focused.push(ids);
  }

  lookFrom(view: View): void {
    this.view = view;
  }

  commit(commands: readonly Command[]): void {
    this.history = commands.reduce(commit, this.history);
  }

  select(ids: readonly string[]): void {
    this.selection = ids;
  }

  notify(notice: Notice, offer: readonly Command[] = [], from: View | null = null): void {
    this.notices.push(notice);
    this.offer = offer;
    this.from = from;
  }

  undo(): void {
    this.history = undo(this.history);
  }

  /** Over the picture; without a place: away from it. */
  hover(x?: number, y?: number): void {
    const at = x === undefined || y === undefined ? null : pen(x, y, 0);
    this.state = this.state.hover?.(at, this) ?? this.state;
  }

  down(x: number, y: number): void {
    this.state = this.state.down?.(pen(x, y, 0), this) ?? this.state;
  }

  move(x: number, y: number, time = 8): void {
    this.state = this.state.move?.([pen(x, y, time)], this) ?? this.state;
  }

  up(): void {
    this.state = this.state.up?.(this) ?? this.state;
  }

  cancel(): void {
    this.state = this.state.cancel();
  }

  /** A whole stroke through the points, in steps of a few pixels. */
  draw(points: readonly (readonly [number, number])[]): void {
    this.trace(points);
    this.up();
  }

  trace(points: readonly (readonly [number, number])[]): void {
    const [first, ...rest] = points;
    this.down(...first!);
    let from = first!;
    let time = 0;
    for (const to of rest) {
      const steps = Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / 6));
      for (let i = 1; i <= steps; i++) {
        time += 8;
        this.move(from[0] + ((to[0] - from[0]) * i) / steps, from[1] + ((to[1] - from[1]) * i) / steps, time);
      }
      from = to;
    }
  }
}

const pen = (x: number, y: number, time: number): Pen => ({
  x,
  y,
  pressure: 0.5,
  tiltX: 0,
  tiltY: 0,
  time,
  pointer: 'pen',
});
