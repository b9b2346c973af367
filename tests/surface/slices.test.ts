import { describe, expect, test } from 'vitest';
import { length2 } from '../../src/math/tuple.ts';
import { slices } from '../../src/surface/slices.ts';
import { circle, halfCircle, line, polygon } from './curves.ts';

const thin = (): number => 1;

describe('slices', () => {
  test('of a smooth stroke are even, without creases or slides', () => {
    const found = slices(halfCircle(50, 1), thin, 10, 8);
    expect(found).toHaveLength(11);
    for (const { slide, flare, tangent } of found) {
      expect([Math.abs(slide), flare]).toEqual([0, 0]);
      expect(length2(tangent)).toBeCloseTo(1, 12);
    }
    expect(found.slice(1).every(({ joined }) => joined)).toBe(true);
  });

  test('a mitre is two slices in one place; both slide into the bisecting plane', () => {
    const found = slices(line([0, 0], [50, 0], [50, 50]), thin, 10, 8);
    const k = found.findIndex(({ joined }, i) => i > 0 && !joined);
    expect(found[k]!.point).toEqual(found[k - 1]!.point);
    // a turn to the left by 90°: the left side of the arriving leg ends 1 mm early, that of the leaving begins 1 mm late
    expect(found[k - 1]!.slide).toBeCloseTo(-1, 9);
    expect(found[k]!.slide).toBeCloseTo(1, 9);
    expect(found.filter(({ slide }) => Math.abs(slide) > 1e-12)).toHaveLength(2);
  });

  test('slides fall off over twice the mitre, or half the leg when that is shorter', () => {
    const slid = slices(line([0, 0], [50, 0], [50, 50]), () => 10, 100, 8).filter(
      ({ slide }) => Math.abs(slide) > 1e-9,
    );
    for (const { point, slide } of slid) {
      const away = Math.abs(point[0] - 50) + Math.abs(point[1]);
      expect(Math.abs(slide)).toBeCloseTo(1 - away / 20, 6);
    }
    const short = slices(line([0, 0], [50, 0], [50, 4], [100, 4]), () => 10, 200, 8);
    expect(short.every(({ slide }) => Number.isFinite(slide) && Math.abs(slide) <= 1 + 1e-9)).toBe(true);
  });

  test('a sharp turn is a fan of slices about the corner', () => {
    const found = slices(line([0, 0], [50, 0], [0, 10]), thin, 10, 32);
    expect(found.slice(1).every(({ joined }) => joined)).toBe(true);
    const atCorner = found.filter(({ point }) => Math.hypot(point[0] - 50, point[1]) < 1e-9);
    expect(atCorner.length).toBeGreaterThan(12);
    const angles = atCorner.map(({ tangent }) => Math.atan2(tangent[1], tangent[0]));
    expect(angles.every((angle, i) => i === 0 || angle > angles[i - 1]!)).toBe(true);
  });

  test('a closed stroke begins at its first corner and ends there', () => {
    for (const stroke of [
      circle(0, 0, 30),
      polygon([0, 0], [90, 0], [90, 90]),
      polygon([0, 0], [90, 0], [0, 90]),
    ]) {
      const found = slices(stroke, thin, 3, 8);
      expect(found.at(-1)!.point).toEqual(found[0]!.point);
      expect(found.length).toBeGreaterThanOrEqual(4);
    }
  });

  test('know how the radius grows and how the stroke bends, per mm', () => {
    for (const { flare, bend } of slices(halfCircle(50, 1), (u) => 5 + 10 * u, 10, 8)) {
      expect(flare).toBeCloseTo(10 / (Math.PI * 50), 9);
      expect(bend).toBeCloseTo(-1 / 50, 6);
    }
  });
});
