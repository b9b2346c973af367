import { describe, expect, it } from 'vitest';
import { knobsAround } from '../../src/element/gizmo.ts';
import { unrotate3 } from '../../src/math/tuple.ts';
import type { Quat, Vec2 } from '../../src/math/vec.ts';
import type { View } from '../../src/stroke/stroke.ts';
import { AXIS } from '../../src/tool/move.ts';
import { anyRotation } from '../tool/scene.ts';

const SIZE = { width: 1280, height: 960 };
const FREE = { left: 0, top: 0, right: 1280, bottom: 960 };
const MIDDLE: Vec2 = [640, 480];
const knobs = (rotation: Quat, middle = MIDDLE, others = true, free = FREE) => {
  const view: View = { pivot: [0, 0, 0], rotation, height: 200, fov: 0 };
  return knobsAround(view, SIZE, middle, free, others).filter(({ at }) => at !== null);
};

describe('the handles', () => {
  it.each(Array.from({ length: 40 }, (_, i) => i + 1))(
    'never touch each other, and lie on their axes (seed %i)',
    (seed) => {
      const rotation = anyRotation(seed);
      const found = knobs(rotation);
      for (const a of found)
        for (const b of found)
          if (a !== b)
            expect(Math.hypot(a.at![0] - b.at![0], a.at![1] - b.at![1])).toBeGreaterThanOrEqual(44);
      for (const { handle, at } of found) {
        if (handle !== 'x' && handle !== 'y' && handle !== 'z') continue;
        const [x, y] = unrotate3(rotation, AXIS[handle]);
        expect(at![0] * -y - at![1] * x).toBeCloseTo(0, 9);
      }
    },
  );

  it('leave out an axis that points at the viewer', () => {
    expect(knobs([0, 0, 0, 1]).map(({ handle }) => handle)).toEqual([
      'view',
      'x',
      'y',
      'surface',
      'turn',
      'turnY',
      'turnX',
      'scale',
    ]);
  });

  it('show two axes that lie one behind the other at opposite ends', () => {
    // From the left front, level: x and z appear as one line.
    const half = Math.PI / 8;
    const found = knobs([0, -Math.sin(half), 0, Math.cos(half)]);
    const [x, z] = ['x', 'z'].map((name) => found.find(({ handle }) => handle === name)!.at!);
    expect(x![0]).toBeCloseTo(-z![0], 9);
  });

  it('slide over nothing when there are no other parts', () => {
    expect(knobs([0, 0, 0, 1], MIDDLE, false).some(({ handle }) => handle === 'surface')).toBe(false);
  });

  it('stay where a hand can reach them, as far as an end of each is there', () => {
    const free = { left: 28, top: 92, right: 928, bottom: 932 };
    for (const middle of [
      [100, 100],
      [900, 100],
      [900, 900],
      [60, 500],
    ] as const) {
      for (const { handle, at } of knobs([0, 0, 0, 1], middle, true, free)) {
        if (handle === 'view') continue;
        const [x, y] = [middle[0] + at![0], middle[1] + at![1]];
        expect(
          x > free.left && x < free.right && y > free.top && y < free.bottom,
          `${handle} ${x} ${y}`,
        ).toBe(true);
      }
    }
  });
});
