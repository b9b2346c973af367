import { describe, expect, test } from 'vitest';
import { cross2, length2, sub2 } from '../../src/math/tuple.ts';
import { crossSectionSheet } from '../../src/surface/crossSection.ts';
import { joined, round } from '../../src/surface/joined.ts';
import { type Outline, roundHalf, straight } from '../../src/surface/outline.ts';
import { line } from './curves.ts';
import { bent, comb, mushroom, raisedBy, roof, wave } from './outlines.ts';

/** by 4,000 chords, positive when clockwise: front first */
function areaOf(outline: Outline): number {
  let sum = 0;
  for (let i = 0; i < 4000; i++) sum -= cross2(outline.point(i / 4000), outline.point((i + 1) / 4000)) / 2;
  return sum;
}

describe('a front and a back', () => {
  test('begin and end in each other; q_r is at a half', () => {
    for (const front of [roundHalf, roof, comb, mushroom, straight, wave(0.4, 2)]) {
      for (const closed of [joined(front, 'mirror'), joined(front, raisedBy(roof, -1))]) {
        expect(closed.closed).toBe(true);
        expect(closed.point(0)).toEqual([-1, 0]);
        expect(closed.point(1)).toEqual([-1, 0]);
        expect(closed.point(0.5)).toEqual([1, 0]);
        expect([...closed.corners].sort((a, b) => a - b)).toEqual(closed.corners);
        for (const v of closed.corners) expect(v >= 0 && v < 1).toBe(true);
        for (let i = 1; i < 500; i++) {
          const step = length2(sub2(closed.point(i / 500), closed.point((i - 1) / 500)));
          expect(step).toBeLessThan(0.1);
        }
      }
    }
  });

  test('two half circles are one smooth circle', () => {
    expect(round.corners).toEqual([]);
    expect(areaOf(round)).toBeCloseTo(Math.PI, 5);
    for (const v of [0, 0.5]) {
      const [before, after] = [round.derivative(v, -1), round.derivative(v, 1)];
      expect(before).toEqual(after);
      expect(length2(after)).toBeCloseTo(2 * Math.PI, 12);
    }
    for (const v of [0.1, 0.6, 0.9]) {
      const [x, y] = round.point(v);
      expect(cross2([x, y], round.derivative(v, 1))).toBeCloseTo(-2 * Math.PI, 9);
    }
  });

  test('that meet at an angle have corners where they meet, and their own in between', () => {
    const lens = joined(raisedBy(wave(1, 1), 0.3), 'mirror');
    expect(lens.corners).toEqual([0, 0.5]);
    const roofs = joined(roof, 'mirror');
    expect(roofs.corners).toEqual([0, 0.25, 0.5, 0.75].map((v) => expect.closeTo(v, 9)));
    const cut = joined(roundHalf, bent([-1, 0], [-1, -2], [1, -2], [1, 0]));
    expect(cut.corners).toEqual([expect.closeTo(2 / 3, 9), expect.closeTo(5 / 6, 9)]);
    expect(areaOf(cut)).toBeCloseTo(Math.PI / 2 + 4, 3);
  });
});

describe('a mirrored front', () => {
  test('encloses the same whichever side of the chord it lies on, and never goes round the other way', () => {
    for (const front of [roundHalf, roof, comb, wave(0.7, 1)])
      expect(areaOf(joined(raisedBy(front, -1), 'mirror'))).toBeCloseTo(areaOf(joined(front, 'mirror')), 3);
    // |sin| over half waves
    for (const waves of [1, 2, 3])
      expect(areaOf(joined(wave(0.5, waves), 'mirror'))).toBeCloseTo(4 / Math.PI, 2);
  });

  test('that goes through the chord has a crease there, on a web', () => {
    const lobes = joined(wave(0.5, 2), 'mirror');
    expect(lobes.corners).toEqual([0, 0.25, 0.5, 0.75].map((v) => expect.closeTo(v, 6)));
    expect(Math.abs(lobes.point(0.25)[1] - lobes.point(0.75)[1])).toBeGreaterThan(1e-3);
    const [before, after] = [lobes.derivative(0.25, -1), lobes.derivative(0.25, 1)];
    expect(before[1] / before[0]).toBeCloseTo(-0.5 * Math.PI, 3);
    expect(after[1] / after[0]).toBeCloseTo(0.5 * Math.PI, 3);
  });

  test('that is straight makes a plate', () => {
    const plate = joined(straight, 'mirror');
    expect(areaOf(plate)).toBeGreaterThan(1e-3);
    expect(areaOf(plate)).toBeLessThan(1e-2);
    expect(plate.corners).toEqual([0, 0.5]);
  });
});

test('the mirror image of an S that is drawn as its back is its mirror', () => {
  const back = raisedBy(wave(0.5, 2), -1);
  const [drawn, mirrored] = [joined(wave(0.5, 2), back), joined(wave(0.5, 2), 'mirror')];
  for (let i = 0; i <= 20; i++) expect(drawn.point(i / 20)).toEqual(mirrored.point(i / 20));
  const curves = [line([-1, 0], [-1, 5]), line([1, 0], [1, 5])];
  const sheet = crossSectionSheet({ curves, radius: 1, pressure: false, caps: 'flat' }, drawn, {
    u: 4,
    v: 32,
  })!;
  // both lids are there: it has a back
  expect(sheet.rows.some(({ at }) => at.rigid)).toBe(true);
});
