import { expect, test } from 'vitest';
import type { Plane } from '../../src/math/plane.ts';
import { bendAxis } from '../../src/surface/bendAxis.ts';
import type { Spine } from '../../src/surface/sheet.ts';
import { arc, type Centre, spineOf, upright, wavy } from './sheets.ts';

const FRONT: Plane = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] };
const ABOVE: Plane = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 0, -1] };

test('lines are walked along the line, others along the path', () => {
  const isStraight = (centre: Centre, closed = false) =>
    bendAxis(spineOf(centre), FRONT, closed)?.straight ?? null;
  expect(isStraight(upright)).toBe(true);
  expect(isStraight(wavy(8, 1))).toBe(false);
  // steep waves swing about
  expect(isStraight(wavy(2, 12))).toBe(true);
  const ring = arc(0, 2 * Math.PI, true);
  expect([isStraight(ring), isStraight(ring, true)]).toEqual([true, false]);
});

test('from the end there is none', () => {
  expect(bendAxis(spineOf(upright), ABOVE)).toBe(null);
});

test('the axis in the same view is made once, as long as the spine is the same', () => {
  const { at, ...rest } = spineOf(wavy(8, 1));
  let count = 0;
  const spine: Spine = {
    ...rest,
    at: (u, side) => {
      count++;
      return at(u, side);
    },
  };
  const axis = bendAxis(spine, FRONT);
  const first = count;
  expect(bendAxis(spine, { ...FRONT })).toBe(axis);
  expect(bendAxis(spine, { ...FRONT, origin: [1, 0, 0] })).not.toBe(axis);
  expect(count).toBe(first);
  expect(bendAxis({ ...spine }, FRONT)).not.toBe(axis);
});
