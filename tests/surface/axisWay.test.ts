import { describe, expect, test } from 'vitest';
import { extentOf } from '../../src/surface/axisProbes.ts';
import { lineOf } from '../../src/surface/axisWay.ts';
import { probed, upBy } from './probed.ts';
import { arc, type Centre, upright, wavy } from './sheets.ts';

function way(centre: Centre) {
  const probes = probed(centre);
  return lineOf(probes, extentOf(probes), centre.closed ?? false);
}

describe('looked at as a line', () => {
  test('a line is one, and runs along itself', () => {
    expect(way(upright)).toEqual({ along: [0, 1], straight: true, exact: true, quiet: true });
  });

  test('low waves are straight but no line; where they are steep they swing about', () => {
    expect(way(wavy(2, 1))).toMatchObject({ straight: true, exact: false, quiet: true });
    expect(way(wavy(2, 12))).toMatchObject({ straight: true, quiet: false });
    expect(way(wavy(8, 1)).straight).toBe(false);
  });

  test('what goes there and back is a line along its longer side, but not quiet', () => {
    const { along, exact, quiet } = way(
      upBy((u) => [Math.sin(Math.PI * u), Math.PI * Math.cos(Math.PI * u)]),
    );
    expect(Math.abs(along[0])).toBeLessThan(1e-12);
    expect(along[1]).toBeCloseTo(1, 12);
    expect([exact, quiet]).toEqual([true, false]);
  });

  test('a ring is no line', () => {
    expect(way(arc(0, 2 * Math.PI, true)).straight).toBe(false);
  });
});
