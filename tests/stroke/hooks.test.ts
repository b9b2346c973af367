import { describe, expect, test } from 'vitest';
import type { Vec2 } from '../../src/math/vec.ts';
import { removeHooks } from '../../src/stroke/hooks.ts';
import { penStroke, samplesAt } from '../fixtures/pen.ts';

const paths: Readonly<Record<string, (t: number) => Vec2>> = {
  line: (t) => [100 * t, 30 * t],
  arc: (t) => [50 * Math.cos(3 * t), 50 * Math.sin(3 * t)],
  wave: (t) => [120 * t, 10 * Math.sin(9 * t)],
};
const distance = (p: { x: number; y: number }, q: Vec2) => Math.hypot(p.x - q[0], p.y - q[1]);

describe('removeHooks', () => {
  for (const [name, path] of Object.entries(paths)) {
    for (const seed of [1, 2, 3]) {
      test(`${name}: hooks of 2 mm at both ends go, the ends stay (seed ${seed})`, () => {
        const hooked = penStroke(path, { seed, hook: 2, jitter: 0.05 });
        const bare = removeHooks(hooked, 1);
        expect(distance(hooked[0]!, path(0))).toBeGreaterThan(1.5);
        expect(distance(bare[0]!, path(0))).toBeLessThan(0.75);
        expect(distance(bare.at(-1)!, path(1))).toBeLessThan(0.75);
        expect(bare.length).toBeGreaterThan(0.9 * hooked.length - 8);
      });

      test(`${name}: without hooks nothing is eaten (seed ${seed})`, () => {
        const plain = penStroke(path, { seed, jitter: 0.02 });
        const bare = removeHooks(plain, 1);
        expect(distance(bare[0]!, path(0))).toBeLessThan(0.5);
        expect(distance(bare.at(-1)!, path(1))).toBeLessThan(0.5);
      });
    }
  }

  test('strokes with sharp ends keep them: the arms of a tick, the start of a spiral', () => {
    const tick = samplesAt(Array.from({ length: 101 }, (_, i): Vec2 => (i < 15 ? [i, -i] : [i, i - 30])));
    expect(removeHooks(tick, 1)).toHaveLength(101);
    const spiral = (t: number): Vec2 => [30 * t * Math.cos(14 * t), 30 * t * Math.sin(14 * t)];
    const samples = penStroke(spiral, { seed: 4, hz: 240 });
    expect(removeHooks(samples, 1)).toHaveLength(samples.length);
  });

  test('two points, and a stroke that is all hook, stay', () => {
    expect(
      removeHooks(
        samplesAt([
          [0, 0],
          [5, 5],
        ]),
        1,
      ),
    ).toHaveLength(2);
    expect(
      removeHooks(
        samplesAt([
          [0, 0],
          [1, 0],
          [0, 0.1],
        ]),
        1,
      ),
    ).toHaveLength(3);
  });
});
