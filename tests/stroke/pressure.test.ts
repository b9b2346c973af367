import { expect, test } from 'vitest';
import { pathOf } from '../../src/stroke/path.ts';
import { pressureProfile } from '../../src/stroke/pressure.ts';
import { normal } from '../fixtures/random.ts';

const line = (pressure: (t: number) => number) =>
  Array.from({ length: 301 }, (_, i) => ({ x: i / 3, y: 0, pressure: pressure(i / 300) }));

test('follows what was pressed, smoothly, within 0–1 (seed 2)', () => {
  const n = normal(2);
  const profile = pressureProfile(
    pathOf(
      line((t) => 0.2 + 0.6 * t + 0.05 * n()),
      false,
    ),
    0,
  );
  for (const [i, value] of profile.entries())
    expect(Math.abs(value - 0.2 - (0.6 * i) / 63)).toBeLessThan(0.08);
  expect(
    Math.max(
      ...pressureProfile(
        pathOf(
          line(() => 1),
          false,
        ),
        0,
      ),
    ),
  ).toBe(1);
});

test('a closed profile begins where it is told', () => {
  const ring = Array.from({ length: 400 }, (_, i) => {
    const a = (2 * Math.PI * i) / 400;
    return { x: 10 * Math.cos(a), y: 10 * Math.sin(a), pressure: 0.5 + 0.4 * Math.cos(a) };
  });
  const path = pathOf(ring, true);
  const opposite = pressureProfile(path, path.length / 2);
  const straight = pressureProfile(path, 0);
  expect(straight[0]).toBeCloseTo(0.9, 2);
  expect(opposite[0]).toBeCloseTo(0.1, 2);
  for (let i = 0; i < 64; i++) expect(opposite[i]).toBeCloseTo(straight[(i + 32) % 64]!, 3);
});
