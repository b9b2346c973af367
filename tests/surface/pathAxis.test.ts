import { describe, expect, test } from 'vitest';
import { distance2 } from '../../src/math/tuple.ts';
import { pathAxis } from '../../src/surface/pathAxis.ts';
import { FRONT, probed } from './probed.ts';
import { arc, type Centre, spineOf, wavy } from './sheets.ts';

const axisOf = (centre: Centre) => pathAxis(spineOf(centre), FRONT, probed(centre), false);

describe('walking along the path', () => {
  test('a part of a circle is r times its angle long, and walked evenly', () => {
    const axis = axisOf(arc(0, 2));
    expect(Math.abs(axis.length - 120)).toBeLessThan(1e-9);
    for (const u of [0, 0.1, 0.5, 0.93, 1]) {
      const here = axis.at(u, 1);
      expect(Math.abs(here.walked() - 120 * u)).toBeLessThan(1e-9);
      expect(distance2(here.point(), [60 * Math.cos(2 * u), 60 * Math.sin(2 * u)])).toBeLessThan(1e-12);
      expect(distance2(here.direction(), [-Math.sin(2 * u), Math.cos(2 * u)])).toBeLessThan(1e-12);
    }
  });

  test('the speed is the derivative of the way walked', () => {
    const axis = axisOf(wavy(20, 2));
    const h = 1e-4;
    for (const u of [0.1, 0.37, 0.5, 0.81]) {
      const slope = (axis.at(u + h, 1).walked() - axis.at(u - h, 1).walked()) / (2 * h);
      expect(Math.abs(slope / axis.at(u, 1).speed() - 1)).toBeLessThan(1e-5);
    }
  });

  test('where the centre stands still the direction is that of a little further in', () => {
    const starts: Centre = {
      at: (u) => [
        [60 * u * u, 0, 0],
        [120 * u, 0, 0],
        [120, 0, 0],
      ],
    };
    expect(axisOf(starts).at(0, 1).direction()).toEqual([1, 0]);
  });
});
