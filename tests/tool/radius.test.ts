/** A radius that is drawn: a line's length, a circle's radius, shown live, one undo step, gone when cancelled. */
import { describe, expect, it } from 'vitest';
import { apply, type Command } from '../../src/document/command/index.ts';
import { EMPTY_DOCUMENT, RADIUS_RANGE } from '../../src/document/document.ts';
import { LIMITS } from '../../src/document/limits.ts';
import type { Vec2 } from '../../src/math/vec.ts';
import { radiusOf, sizing } from '../../src/tool/radius.ts';
import type { Bench, Pen, State } from '../../src/tool/tool.ts';
import { VIEW } from '../document/strokes.ts';

const circle = (radius: number, turns = 1): Vec2[] =>
  Array.from({ length: 61 }, (_, i) => {
    const angle = (2 * Math.PI * turns * i) / 60;
    return [3 + radius * Math.cos(angle), radius * Math.sin(angle)];
  });

describe('the radius of a stroke', () => {
  it('is the length of a line', () => {
    expect(
      radiusOf(
        [
          [0, 0],
          [3, 4],
          [6, 8],
        ],
        false,
      ),
    ).toBe(10);
  });

  it.each([4, 12.5, 40])('is that of a circle of %d mm, closed or nearly, either way round', (radius) => {
    for (const turns of [1, 0.97, -1]) {
      const found = radiusOf(circle(radius, turns), true)!;
      expect(Math.abs(found / radius - 1)).toBeLessThan(0.02);
    }
  });

  it('is the length of a hook, not of a line there and back', () => {
    expect(
      radiusOf(
        [
          [0, 0],
          [20, 0],
          [20.5, 1],
          [0.4, 0.3],
        ],
        true,
      ),
    ).toBe(RADIUS_RANGE.min);
  });

  it('is one that brushes have', () => {
    expect(
      radiusOf(
        [
          [0, 0],
          [500, 0],
        ],
        false,
      ),
    ).toBe(RADIUS_RANGE.max);
    expect(
      radiusOf(
        [
          [0, 0],
          [0.01, 0],
        ],
        false,
      ),
    ).toBe(RADIUS_RANGE.min);
    expect(radiusOf([], false)).toBe(null);
    expect(radiusOf([[1, 1]], false)).toBe(null);
  });
});

describe('drawing it', () => {
  const back: State = { name: 'idle', cancel: () => back };
  const pen = (x: number, y: number): Pen => ({
    x,
    y,
    pressure: 0.5,
    tiltX: 0,
    tiltY: 0,
    time: 0,
    pointer: 'pen',
  });
  const hand = () => {
    const done: Command[] = [];
    const bench = {
      document: EMPTY_DOCUMENT,
      viewport: { view: VIEW, size: { width: 400, height: 400 }, pick: () => null },
      selection: [],
      commit: (commands: readonly Command[]) => done.push(...commands),
    } as unknown as Bench;
    const start = sizing({
      at: [0, 0, 0],
      command: (radius) => ({ type: 'setBrush', change: { radius } }),
      back,
    });
    return { done, bench, down: start.down!(pen(100, 100), bench)! };
  };

  it('shows what it does, and does it once', () => {
    const { done, bench, down } = hand();
    // 400 px are 200 mm
    const drawn = down.move!([pen(120, 100), pen(140, 100)], bench)!;
    expect(drawn.preview!(bench)!.brush.radius).toBe(20);
    expect(done).toEqual([]);
    expect(drawn.up!(bench)).toBe(back);
    expect(done.reduce(apply, EMPTY_DOCUMENT).brush.radius).toBe(20);
    expect(done).toHaveLength(1);
  });

  it('is as if nothing had been when it is cancelled', () => {
    const { done, bench, down } = hand();
    expect(down.move!([pen(180, 100)], bench)!.cancel()).toBe(back);
    expect(done).toEqual([]);
  });

  /** px, from the top, through this many turns */
  const ring = (turns: number, count = 120): Pen[] =>
    Array.from({ length: count }, (_, i) => {
      const angle = (2 * Math.PI * turns * i) / (count - 1);
      return pen(100 + 60 * Math.sin(angle), 160 - 60 * Math.cos(angle));
    });

  it('is a circle where Draw would close it, and says so', () => {
    const { bench, down } = hand();
    const open = down.move!(ring(0.85), bench)!;
    expect(open.wet!.closing).toBe(false);
    const closed = hand().down.move!(ring(0.97), bench)!;
    expect(closed.wet!.closing).toBe(true);
    // 60 px are 30 mm
    expect(Math.abs(closed.preview!(bench)!.brush.radius - 30)).toBeLessThan(0.6);
    // the gap, 2·30·sin 27°
    expect(open.preview!(bench)!.brush.radius).toBeCloseTo(27.2, 0);
  });

  it('copies no pens, takes no more than a file holds, and makes its preview once', () => {
    const { bench, down } = hand();
    const moved = down.move!(ring(0.5), bench)!;
    const more = moved.move!(ring(0.5, LIMITS.samples), bench)!;
    expect(more.wet!.pens).toBe(moved.wet!.pens);
    expect(more.wet!.pens).toHaveLength(LIMITS.samples);
    expect(more.preview!(bench)).toBe(more.preview!(bench));
  });

  it('waits on after a tap', () => {
    const { done, bench, down } = hand();
    expect(down.up!(bench)!.name).toBe('radius.idle');
    expect(down.move!([pen(102, 100)], bench)!.up!(bench)!.name).toBe('radius.idle');
    expect(done).toEqual([]);
  });
});
