import fc from 'fast-check';
import { expect, test } from 'vitest';
import { cross2 } from '../../src/math/tuple.ts';
import { topology } from '../../src/mesh/check.ts';
import { volume } from '../../src/mesh/measure.ts';
import { polylineCurve } from '../../src/stroke/arcLength.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import { buildSurface } from '../../src/surface/index.ts';
import { joined } from '../../src/surface/joined.ts';
import { type Outline, outlineOf, roundHalf } from '../../src/surface/outline.ts';
import { bentStroke, normalError, smoothStroke, TILTED } from './curves.ts';

const stroke = fc.oneof(smoothStroke(30), bentStroke(false), bentStroke(true));
const x = fc.double({ min: -50, max: 50, noNaN: true });
/** on no lattice: a section that comes back to the last bit to where it was touches itself there */
const bent = fc.array(fc.tuple(x, x), { minLength: 3, maxLength: 7 }).map((points) =>
  polylineCurve(
    points.map(([p, q], i) => [p + 0.0137 * i * i, q]),
    false,
  ),
);
const drawn = fc
  .oneof(smoothStroke(30), bent)
  .map((curve) => outlineOf(curve, { reversed: false, across: true }));
const half = fc.oneof(fc.constant(roundHalf), drawn);
/** Numbers that are 0 make fronts and backs that are symmetric alike, and touch: moved a little they do not. */
const moved = ({ point, derivative, ...front }: Outline): Outline => ({
  ...front,
  point: (v) => [point(v)[0], point(v)[1] + 0.0123 * v * (1 - v) * (1.3 - v)],
  derivative: (v, side) => {
    const [dx, dy] = derivative(v, side);
    return [dx, dy + 0.0123 * (1.3 - 4.6 * v + 3 * v * v)];
  },
});
const closed = fc.tuple(half.map(moved), fc.oneof(fc.constant('mirror' as const), half));

const solidOf = (curves: readonly Curve[], outline: Outline, u: number, v: number) =>
  buildSurface('crossSection', { curves, sections: [{ u: 0.5, outline }], bends: [] }, TILTED, {
    radius: 3,
    pressure: false,
    caps: true,
    u,
    v,
  });
/** in square half chords, as 200 chords have it */
const areaOf = (outline: Outline): number =>
  Array.from({ length: 200 }, (_, i) => cross2(outline.point(i / 200), outline.point((i + 1) / 200))).reduce(
    (sum, part) => sum + part / 2,
    0,
  );
const quads = fc.integer({ min: 1, max: 30 });
const across = fc.integer({ min: 8, max: 30 });

test('random strokes with random sections: finite; with a back closed and not inside out (seed 540)', () => {
  const curves = fc.oneof(fc.tuple(stroke), fc.tuple(stroke, stroke));
  fc.assert(
    fc.property(curves, closed, quads, across, (strokes, [front, back], u, v) => {
      const solid = solidOf(strokes, joined(front, back), u, v);
      expect(topology(solid).finite).toBe(true);
      expect(normalError(solid)).toBeLessThan(1e-5);
      const size = Math.max(...strokes.map(({ length }) => length));
      // a back on its front encloses nothing
      if (Math.abs(areaOf(joined(front, back))) > 0.01) {
        expect(topology(solid).watertight).toBe(true);
        expect(volume(solid)).toBeGreaterThanOrEqual(-1e-6 * size * size * size);
      }
      const sheet = solidOf(strokes, front, u, v);
      expect(topology(sheet).finite).toBe(true);
      expect(normalError(sheet)).toBeLessThan(1e-5);
    }),
    { seed: 540, endOnFailure: Boolean(process.env.RUNS), numRuns: Number(process.env.RUNS ?? 100) },
  );
}, 600_000);
