import { expect, test } from 'vitest';
import { directionIn, holdAt, holdsOf, signAt } from '../../src/surface/holds.ts';
import { probed, upBy } from './probed.ts';
import { wavy } from './sheets.ts';

test('a way that always goes on has none', () => {
  expect(holdsOf(probed(wavy(8, 1)), 1)).toEqual([]);
});

test('where the way turns back it is held, and runs the other way from then on', () => {
  const there = upBy((u) => [Math.sin(Math.PI * u), Math.PI * Math.cos(Math.PI * u)]);
  const holds = holdsOf(probed(there), 1e-2);
  expect(holds.length).toBe(1);
  const hold = holds[0]!;
  expect(hold.back).toBe(true);
  expect(hold.from).toBeLessThan(0.5);
  expect(hold.to).toBeGreaterThan(0.5);
  expect(holdAt(holds, 0.5)).toBe(hold);
  expect(holdAt(holds, 0.25)).toBeUndefined();
  expect([signAt(holds, 0.25), signAt(holds, 0.75)]).toEqual([1, -1]);
  for (const u of [hold.from, 0.5, hold.to]) expect(directionIn(hold, u)[1]).toBeCloseTo(1, 12);
});

test('where it stands still its direction is led from what was before to what comes after', () => {
  // up, a rest, then to the right
  const holds = holdsOf(
    [0, 0.2, 0.4, 0.5, 0.6, 0.8, 1].map((u) => ({
      u,
      side: 1,
      l: [0, 0],
      rate: u < 0.3 ? [0, 50] : u > 0.7 ? [50, 0] : [0, 0],
    })),
    1,
  );
  expect(holds.map(({ from, to, back }) => [from, to, back])).toEqual([[0.2, 0.8, false]]);
  const [x, y] = directionIn(holds[0]!, 0.5);
  expect(Math.abs(x - Math.SQRT1_2) + Math.abs(y - Math.SQRT1_2)).toBeLessThan(1e-12);
});
