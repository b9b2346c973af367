import { describe, expect, test } from 'vitest';
import type { Vec2 } from '../../src/math/vec.ts';
import { curveOf } from '../../src/stroke/arcLength.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import { FILTER_DEFAULTS, filterStroke } from '../../src/stroke/filter.ts';
import { splice } from '../../src/stroke/splice.ts';
import type { Stroke } from '../../src/stroke/stroke.ts';
import { penStroke, samplesAt } from '../fixtures/pen.ts';

function strokeOf(samples: Stroke['samples'], closed = false): Stroke {
  return {
    samples,
    plane: { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] },
    view: { pivot: [0, 0, 0], rotation: [0, 0, 0, 1], height: 200, fov: 0 },
    pointer: 'pen',
    closed,
  };
}

const pen = (path: (t: number) => Vec2, seed: number, hook = 0): Stroke =>
  strokeOf(penStroke(path, { seed, jitter: 0.05, quantise: 0.25, rest: 4, hook }));
const reversed = ({ samples, ...rest }: Stroke): Stroke => {
  const last = samples.at(-1)!.time;
  return { ...rest, samples: samples.map((s) => ({ ...s, time: last - s.time })).reverse() };
};
const curve = ({ samples, closed }: Stroke): Curve =>
  curveOf(filterStroke(samples, { ...FILTER_DEFAULTS, closed })!);
const away = (c: Curve, [x, y]: Vec2): number =>
  Math.min(
    ...Array.from({ length: 1001 }, (_, i) => Math.hypot(c.point(i / 1000)[0] - x, c.point(i / 1000)[1] - y)),
  );
const ascending = ({ samples }: Stroke): boolean =>
  samples.every((s, i) => i === 0 || s.time >= samples[i - 1]!.time);

const straight = (t: number): Vec2 => [150 * t, 0];
/** leaves and meets the line smoothly, `off` mm beside it */
const bump =
  (off: number) =>
  (t: number): Vec2 => [40 + 70 * t, off + 15 * Math.sin(Math.PI * t) ** 2];

describe('splice', () => {
  for (const off of [0, 1, -2, 3]) {
    for (const hook of [0, 1.5]) {
      test(`a bump ${off} mm beside the line, flicks of ${hook} mm: no corner that nobody drew (seeds 1–5)`, () => {
        for (const seed of [1, 2, 3, 4, 5]) {
          const old = pen(straight, seed);
          const over = pen(bump(off), seed + 10, hook);
          for (const drawn of [over, reversed(over)]) {
            const after = splice(old, drawn, 1);
            const c = curve(after);
            expect(c.corners).toEqual([]);
            expect(away(c, [75, off + 15])).toBeLessThan(1);
            for (const x of [5, 25, 125, 145]) expect(away(c, [x, 0])).toBeLessThan(0.5);
            expect(away(c, [75, 0])).toBeGreaterThan(10);
            expect(c.length).toBeLessThan(150 + 20);
            expect(ascending(after)).toBe(true);
          }
        }
      });
    }
  }

  test('new samples stay as they were drawn, with their pressure', () => {
    const over = pen(bump(1), 3);
    const after = splice(pen(straight, 4), over, 1);
    const places = after.samples.map(({ x, y, pressure }) => `${x} ${y} ${pressure}`);
    for (const { x, y, pressure } of over.samples) expect(places).toContain(`${x} ${y} ${pressure}`);
  });

  test('corners that were drawn stay, those replaced go', () => {
    const old = strokeOf(
      samplesAt([
        [0, 0],
        [50, 0],
        [50, 50],
        [100, 50],
      ]),
    );
    const over = strokeOf(
      samplesAt([
        [80, 50],
        [80, 90],
        [110, 90],
      ]),
    );
    const c = curve(splice(old, over, 1));
    for (const corner of [
      [50, 0],
      [50, 50],
      [80, 90],
    ] as Vec2[])
      expect(away(c, corner)).toBeLessThan(1);
    expect(c.corners).toHaveLength(4);
    const round = pen((t) => [20 + 30 * t, 30 * t * t], 1);
    expect(curve(splice(old, round, 1)).corners.length).toBeLessThan(3);
  });

  test('drawn on from either end it is longer', () => {
    const old = pen(straight, 1);
    for (const on of [
      pen((t) => [148 + 60 * t, 1 + 10 * t * t], 2),
      pen((t) => [2 - 60 * t, 1 + 10 * t * t], 3),
    ]) {
      for (const drawn of [on, reversed(on)]) {
        const c = curve(splice(old, drawn, 1));
        expect(c.length).toBeGreaterThan(195);
        expect(c.length).toBeLessThan(225);
        expect(c.corners).toEqual([]);
      }
    }
  });

  const round = (t: number): Vec2 => [50 * Math.cos(2 * Math.PI * t), 50 * Math.sin(2 * Math.PI * t)];
  /** a wave of 8 mm outward between two angles */
  const wave =
    (from: number, to: number) =>
    (t: number): Vec2 => {
      const a = from + (to - from) * t;
      const r = 50 + 8 * Math.sin(Math.PI * t) ** 2;
      return [r * Math.cos(a), r * Math.sin(a)];
    };
  for (const [name, from, to] of [
    ['away from the seam', 1, 2.5],
    ['over the seam', -0.8, 0.9],
    ['most of it', 0.5, 5.5],
    ['most of it, over the seam', -2.5, 2.2],
  ] as const) {
    test(`closed strokes lose the nearer part: ${name} (seeds 1–3)`, () => {
      for (const seed of [1, 2, 3]) {
        const old = { ...pen(round, seed), closed: true };
        const over = pen(wave(from, to), seed + 20);
        for (const drawn of [over, reversed(over)]) {
          const after = splice(old, drawn, 1);
          expect(after.closed).toBe(true);
          expect(ascending(after)).toBe(true);
          const c = curve(after);
          expect(c.corners).toEqual([]);
          const middle = (from + to) / 2;
          expect(away(c, [58 * Math.cos(middle), 58 * Math.sin(middle)])).toBeLessThan(1);
          expect(away(c, [-50 * Math.cos(middle), -50 * Math.sin(middle)])).toBeLessThan(1);
          expect(c.length).toBeLessThan(2 * Math.PI * 60);
        }
      }
    });
  }

  test('a closed stroke over a closed one takes its place', () => {
    const old = { ...pen(round, 1), closed: true };
    const over = { ...pen((t) => [60 * Math.cos(6.3 * t), 30 * Math.sin(6.3 * t)], 2), closed: true };
    const c = curve(splice(old, over, 1));
    expect(away(c, [60, 0])).toBeLessThan(1);
    expect(away(c, [0, 50])).toBeGreaterThan(15);
  });

  test('dots and spurs say nothing', () => {
    const old = pen(straight, 1);
    const dot = strokeOf(samplesAt([[40, 3]]));
    const spur = strokeOf(
      samplesAt([
        [40, 0],
        [40, 30],
        [41, 0],
      ]),
    );
    const broken = strokeOf(
      samplesAt([
        [Number.NaN, 0],
        [Number.NaN, 3],
      ]),
    );
    for (const drawn of [dot, spur, broken, strokeOf([])]) expect(splice(old, drawn, 1)).toBe(old);
  });
});
