/** The maps of cross sections: their iso-curves by definition, slopes by differences, awkward points. */
import { describe, expect, test } from 'vitest';
import { extrusion } from '../../src/field/extrusion.ts';
import { controlRadii, polarProfile } from '../../src/field/polarProfile.ts';
import { ROUND, type Section } from '../../src/field/section.ts';
import { superQuadric } from '../../src/field/superQuadric.ts';
import { pow } from '../../src/math/pow.ts';
import { cos, sin, TAU } from '../../src/math/trig.ts';
import { FieldError } from '../../src/skeleton/skeleton.ts';
import { random } from '../fixtures/random.ts';

const flower = Array.from({ length: 24 }, (_, i) => 1 + 0.3 * sin((i * TAU) / 6));
const sections: readonly [string, Section][] = [
  ['round', ROUND],
  ...[0.3, 0.5, 1, 2, 3.7, 50, 100].map((exponent): [string, Section] => [
    `super-quadric ${exponent}`,
    superQuadric({ type: 'superQuadric', exponent }),
  ]),
  ...[2, 7.5, 50, 100].map((exponent): [string, Section] => [
    `extrusion ${exponent}`,
    extrusion({ type: 'extrusion', exponent }),
  ]),
  ['polar flower', polarProfile({ type: 'polar', radii: flower })],
];

const generic = (section: Section, x: number, y: number) => section.value(x, y) * Math.sqrt(x * x + y * y);
const out = new Float64Array(3);

describe('sections', () => {
  test.each([0.3, 0.5, 1, 2, 4, 50, 100])('|x|^a + |y|^a = 1 is mapped to the unit circle, a = %d', (a) => {
    const section = superQuadric({ type: 'superQuadric', exponent: a });
    let worst = 0;
    for (let i = 0; i <= 1000; i++) {
      // where |x|^a = u
      const u = i / 1000;
      const [x, y] = [pow(u, 1 / a), -pow(1 - u, 1 / a)];
      worst = Math.max(worst, Math.abs(generic(section, x, y) - 1));
    }
    expect(worst).toBeLessThan(2e-15);
  });

  test.each([2, 8, 100])('x² + |y|^a = r² is mapped to radius r, a = %d', (a) => {
    const section = extrusion({ type: 'extrusion', exponent: a });
    for (const r of [0.2, 1, 30]) {
      for (let i = 0; i <= 200; i++) {
        const x = r * (i / 100 - 1);
        const y = pow(Math.max(r * r - x * x, 0), 1 / a);
        expect(Math.abs(generic(section, x, y) / r - 1)).toBeLessThan(1e-13);
      }
    }
    expect(section.extent(9)[1]).toBeCloseTo(pow(9, 2 / a), 12);
  });

  test('the curve R(θ) of the Bernstein basis is mapped to the unit circle, and is differentiable at joints', () => {
    const section = polarProfile({ type: 'polar', radii: flower });
    const control = controlRadii(flower);
    for (let k = 0; k < 12; k++) {
      const [a, b, c, d] = control.subarray(4 * k, 4 * k + 4) as unknown as [number, number, number, number];
      expect(d).toBe(control[(4 * k + 4) % 48]);
      expect(d - c).toBeCloseTo(control[(4 * k + 5) % 48]! - control[(4 * k + 4) % 48]!, 14);
      for (let t = 0.03; t < 1; t += 0.1) {
        const s = 1 - t;
        const radius = s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
        const angle = ((k + t) * TAU) / 12;
        expect(generic(section, radius * cos(angle), radius * sin(angle))).toBeCloseTo(1, 13);
      }
    }
  });

  test.each(sections)(
    '%s: slopes are differences, value() agrees, extent holds the disc (seed 21)',
    (_, section) => {
      const next = random(21);
      let worst = 0;
      const wrong: number[][] = [];
      for (let i = 0; i < 500; i++) {
        const [x, y] = [2.4 * next() - 1.2, 2.4 * next() - 1.2];
        section.evaluate(x, y, out);
        if (out[0] !== section.value(x, y)) wrong.push([x, y]);
        const r = out[0]! * Math.sqrt(x * x + y * y);
        const [ex, ey] = section.extent(r);
        if (Math.abs(x) > ex * (1 + 1e-12) || Math.abs(y) > ey * (1 + 1e-12)) wrong.push([x, y]);
        // off the creases
        if (Math.min(Math.abs(x), Math.abs(y)) < 0.05 || Math.abs(Math.abs(x) - Math.abs(y)) < 0.05) continue;
        const h = 1e-6;
        const dx = (section.value(x + h, y) - section.value(x - h, y)) / (2 * h);
        const dy = (section.value(x, y + h) - section.value(x, y - h)) / (2 * h);
        const scale = 1 + Math.abs(dx) + Math.abs(dy);
        worst = Math.max(worst, Math.abs(dx - out[1]!) / scale, Math.abs(dy - out[2]!) / scale);
      }
      expect(wrong).toEqual([]);
      expect(worst).toBeLessThan(2e-7);
    },
  );

  test.each(sections)('%s: finite at the skel, on the axes, near and far', (_, section) => {
    const steps = [0, 1e-30, 1e-6, 0.1, 1, 10, 1e6];
    for (const x of [...steps, ...steps.map((s) => -s)]) {
      for (const y of steps) {
        section.evaluate(x, y, out);
        expect([...out].every(Number.isFinite)).toBe(true);
        expect(out[0]).toBeGreaterThanOrEqual(0);
      }
    }
    expect(section.value(0, 0)).toBe(1);
  });

  test('α = 2 and a constant profile change nothing', () => {
    const square = superQuadric({ type: 'superQuadric', exponent: 2 });
    const even = polarProfile({ type: 'polar', radii: new Array<number>(24).fill(1) });
    for (const [x, y] of [
      [3, 4],
      [-0.2, 5],
      [1, 1],
    ] as const) {
      expect(square.value(x, y)).toBeCloseTo(1, 15);
      expect(even.value(x, y)).toBeCloseTo(1, 15);
    }
  });

  test('what is out of range is refused', () => {
    expect(() => superQuadric({ type: 'superQuadric', exponent: 0.2 })).toThrow(/0.3–100, got 0.2/);
    expect(() => superQuadric({ type: 'superQuadric', exponent: Number.NaN })).toThrow(FieldError);
    expect(() => extrusion({ type: 'extrusion', exponent: 1.5 })).toThrow(/2–100/);
    expect(() => polarProfile({ type: 'polar', radii: [1, 1] })).toThrow(/24 numbers, got 2/);
    expect(() => polarProfile({ type: 'polar', radii: flower.map((r, i) => (i === 3 ? 0.01 : r)) })).toThrow(
      /radii\[3\] must be at least 0.05, got 0.01/,
    );
  });
});
