import { describe, expect, test } from 'vitest';
import { length3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import type { Plane } from '../../src/stroke/stroke.ts';
import { deform } from '../../src/surface/deform.ts';
import { buildSheet } from '../../src/surface/index.ts';
import { straight } from '../../src/surface/outline.ts';
import { sectionAt } from '../../src/surface/sectionAt.ts';
import { line } from './curves.ts';

const SIDE: Plane = { origin: [0, 0, 0], x: [0, 0, -1], y: [0, 1, 0] };
const OPTIONS = { radius: 6, pressure: false, caps: true, u: 24, v: 16 };
const pair = [line([-20, 0], [-20, 100]), line([20, 0], [20, 100])];
const round = buildSheet('rotational', { curves: pair, sections: [], bends: [] }, OPTIONS)!;
const flat = buildSheet(
  'crossSection',
  { curves: pair, sections: [{ u: 0.5, outline: straight }], bends: [] },
  OPTIONS,
)!;

describe('sections of sheets', () => {
  test('lie at their u, between rows and at both ends', () => {
    for (const u of [0, 0.37, 0.5, 1]) {
      for (const p of sectionAt(round, u)!) {
        expect(p[1]).toBeCloseTo(100 * u, 9);
        expect(Math.hypot(p[0], p[2])).toBeCloseTo(20, 9);
      }
    }
  });

  test('closed ones end with their first point, open ones at q_r', () => {
    const ring = sectionAt(round, 0.2)!;
    expect(ring.at(-1)).toEqual(ring[0]);
    const across = sectionAt(flat, 0.2)!;
    expect(length3(sub3(across[0]!, across.at(-1)!))).toBeCloseTo(40, 9);
  });

  test('after a bend stand across its stroke', () => {
    // straight away from the person
    const curve = line([0, 0], [100, 0]);
    const bent = deform(round, { curve, plane: SIDE, keepsLength: true });
    const middle: Vec3 = [0, 0, -90];
    for (const p of sectionAt(bent, 0.9)!) {
      expect(p[2]).toBeCloseTo(-90, 9);
      expect(length3(sub3(p, middle))).toBeCloseTo(20, 9);
    }
  });

  test('there are none of a sheet without rows', () => {
    expect(sectionAt({ rows: [] }, 0.5)).toBeNull();
  });
});
