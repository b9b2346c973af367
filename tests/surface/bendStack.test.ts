import { expect, test } from 'vitest';
import { functionCurve } from '../../src/stroke/arcLength.ts';
import type { Plane } from '../../src/stroke/stroke.ts';
import { type BendInput, deform } from '../../src/surface/deform.ts';
import { buildSheet } from '../../src/surface/index.ts';
import type { Sheet } from '../../src/surface/sheet.ts';
import { line } from './curves.ts';

const sheet = buildSheet(
  'rotational',
  { curves: [line([-20, 0], [-20, 100]), line([20, 0], [20, 100])], sections: [], bends: [] },
  { radius: 6, pressure: false, caps: true, u: 32, v: 8 },
)!;

/** An S seen from the right or from behind. */
const bend = (x: Plane['x']): BendInput => ({
  curve: functionCurve((t) => [12 * Math.sin(5 * t), 100 * t], false),
  plane: { origin: [0, 0, 0], x, y: [0, 1, 0] },
  keepsLength: true,
});
const STACK = [bend([0, 0, -1]), bend([-1, 0, 0]), bend([0, 0, -1]), bend([-1, 0, 0])];

/** The sheet, and how often its own spine was asked. */
function counted(): { readonly sheet: Sheet; readonly asked: () => number } {
  let count = 0;
  const { spine } = sheet;
  const whole: Sheet = {
    ...sheet,
    spine: {
      ...spine,
      at: (u, side) => {
        count++;
        return spine.at(u, side);
      },
    },
  };
  return { sheet: whole, asked: () => count };
}

function asked(bends: readonly BendInput[]): number {
  const { sheet: own, asked } = counted();
  bends.reduce(deform, own);
  return asked();
}

test('what bends ask does not multiply with their number', () => {
  const one = asked(STACK.slice(0, 1));
  expect(asked(STACK.slice(0, 2))).toBeLessThan(6 * one);
  expect(asked(STACK)).toBeLessThan(12 * one);
});

test('another frame of a drag asks the spine for nothing it was asked for before', () => {
  const { sheet: own, asked } = counted();
  const drawn = (by: number): BendInput => ({
    ...STACK[0]!,
    // the view is the same, not the object
    plane: { ...STACK[0]!.plane },
    curve: functionCurve((t) => [12 * Math.sin(5 * t) + by * t, 100 * t], false),
  });
  deform(own, drawn(0));
  const first = asked();
  expect(first).toBeGreaterThan(own.rows.length);
  for (const by of [1, 2, 3]) deform(own, drawn(by));
  expect(asked()).toBe(first);
});
