import { expect, test } from 'vitest';
import { lineAxis } from '../../src/surface/lineAxis.ts';
import { FRONT, probed } from './probed.ts';
import { arc, spineOf, wavy } from './sheets.ts';

test('what is walked is the advance along the line, whatever sticks out of it', () => {
  const centre = wavy(5, 3);
  const axis = lineAxis(spineOf(centre), FRONT, [0, 1], probed(centre));
  expect(axis.length).toBeCloseTo(100, 12);
  for (const u of [0, 0.2, 0.71, 1]) {
    const here = axis.at(u, 1);
    expect(here.walked()).toBeCloseTo(100 * u, 12);
    expect(here.speed()).toBeCloseTo(100, 12);
    expect(here.direction()).toEqual([0, 1]);
    expect(here.point()[0]).toBeCloseTo(axis.ends[0][0], 12);
  }
});

test('a ring goes there and back, from end to end of its width', () => {
  const ring = arc(0, 2 * Math.PI, true);
  const axis = lineAxis(spineOf(ring), FRONT, [1, 0], probed(ring));
  expect(axis.closed).toBe(false);
  expect(axis.length).toBeCloseTo(120, 1);
  expect(axis.at(0.25, 1).walked()).toBeCloseTo(axis.at(0.75, 1).walked(), 9);
  expect(axis.at(0.25, 1).speed()).toBeLessThan(0);
  expect(axis.at(0.75, 1).speed()).toBeGreaterThan(0);
});
