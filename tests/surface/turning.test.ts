import { describe, expect, test } from 'vitest';
import type { Vec2 } from '../../src/math/vec.ts';
import { crossSectionSheet } from '../../src/surface/crossSection.ts';
import { joined, round } from '../../src/surface/joined.ts';
import { type Outline, straight } from '../../src/surface/outline.ts';
import { patchSheet } from '../../src/surface/patch.ts';
import type { Sheet } from '../../src/surface/sheet.ts';
import { leastPieces, turnOf } from '../../src/surface/turning.ts';
import { line } from './curves.ts';
import { smooth, wave } from './outlines.ts';

const { PI } = Math;

describe('the turn of outlines', () => {
  test('of a circle is a whole one, of a line none, of waves their own', () => {
    expect(turnOf(round.point, 0, 1)).toBeCloseTo(2 * PI, 1);
    expect(turnOf(straight.point, 0, 1)).toBeCloseTo(0, 9);
    // a wave of slope k is left and entered at atan k, and turns twice as far at its crest
    expect(turnOf(wave(0.2, 4).point, 0, 1)).toBeCloseTo(8 * Math.atan(0.4 * PI), 1);
  });

  test('a circle of the wished number is fine enough; a scribble has an end', () => {
    expect(leastPieces([2 * PI], 16, 1)).toEqual([16]);
    expect(leastPieces([1000, 3000], 16, 1)).toEqual([24, 72]);
  });
});

describe('sections of many bumps are followed as they were drawn', () => {
  const bumps = (count: number): Outline =>
    smooth((t) => {
      const r = 1 + 0.12 * (1 - Math.cos(2 * count * PI * t));
      return [-r * Math.cos(PI * t), r * Math.sin(PI * t)];
    });
  const source = {
    curves: [line([-1, 0], [-1, 5]), line([1, 0], [1, 5])],
    radius: 1,
    pressure: false,
    caps: 'flat',
  } as const;
  const detail = { between: 'cubic', columns: 16, subdivisions: { u: 1, v: 2 } } as const;
  for (const count of [1, 3, 5, 8]) {
    for (const outline of [bumps(count), joined(bumps(count), 'mirror')]) {
      test(`${count} bumps, ${outline.closed ? 'closed' : 'open'}: to 1 % of the half chord`, () => {
        expect(farthest(crossSectionSheet(source, outline, { u: 8, v: 64 })!, outline)).toBeLessThan(0.01);
        const places = [0.3, 0.7].map((u) => ({ u, outline }));
        for (const rows of [null, 8]) {
          expect(farthest(patchSheet(source, places, { ...detail, rows })!, outline)).toBeLessThan(0.01);
        }
      });
    }
  }
});

/** From the outline to a row in the middle, in half chords. */
function farthest({ rows }: Sheet, outline: Outline): number {
  const inside = rows.filter(({ at }) => !at.rigid);
  const { points } = inside[inside.length >> 1]!;
  const row = Array.from({ length: points.length / 3 }, (_, j): Vec2 => [points[3 * j]!, points[3 * j + 2]!]);
  const away = (p: Vec2): number => Math.min(...row.slice(1).map((b, j) => distanceTo(p, row[j]!, b)));
  return Math.max(...Array.from({ length: 1000 }, (_, i) => away(outline.point(i / 1000))));
}

function distanceTo([x, y]: Vec2, [ax, ay]: Vec2, [bx, by]: Vec2): number {
  const [dx, dy] = [bx - ax, by - ay];
  const t = Math.min(Math.max(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1), 0), 1);
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}
