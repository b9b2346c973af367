/** A hatch turns back at every leg: work must follow its length, not explode with its corners. */
import { expect, test } from 'vitest';
import { curveOf } from '../../src/stroke/arcLength.ts';
import { filterStroke } from '../../src/stroke/filter.ts';
import type { Sample } from '../../src/stroke/stroke.ts';
import { tube } from '../../src/surface/tube.ts';

const PLANE = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] } as const;

/** Zigzags 40 mm high, 1 mm a leg. */
function hatch(legs: number, height = 40): Sample[] {
  return Array.from({ length: 10 * legs + 1 }, (_, i) => {
    const leg = Math.floor(i / 10);
    const t = (i % 10) / 10;
    const y = height * (leg % 2 === 0 ? t : 1 - t);
    return { x: i / 10, y, pressure: 0.5, tiltX: 0, tiltY: 0, time: 4 * i };
  });
}

test.each([100, 400])('a hatch of %i legs makes at most 12 rows a leg', (legs) => {
  const filtered = filterStroke(hatch(legs), { filter: 'least-squares', levels: 3 })!;
  expect(filtered.pieces.length).toBeGreaterThan(legs * 0.9);
  const controls = filtered.pieces.reduce((sum, piece) => sum + piece.length, 0);
  expect(controls).toBeLessThan(20 * legs);
  const mesh = tube(curveOf(filtered), PLANE, { radius: 1, pressure: false, caps: 'round', u: 64, v: 16 });
  expect(mesh.positions.length / 3 / 17).toBeLessThan(12 * legs + 64);
});

test('a stroke of kilometres stays within its budget of control points', () => {
  const filtered = filterStroke(hatch(20, 3e6), { filter: 'least-squares', levels: 3 })!;
  const controls = filtered.pieces.reduce((sum, piece) => sum + piece.length, 0);
  expect(controls).toBeLessThan(40_000);
});
