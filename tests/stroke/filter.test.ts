import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import type { Vec2 } from '../../src/math/vec.ts';
import { curveOf } from '../../src/stroke/arcLength.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import {
  FEWEST_CONTROLS,
  FILTER_DEFAULTS,
  type FilterKind,
  type FilterOptions,
  filterStroke,
} from '../../src/stroke/filter.ts';
import type { Sample } from '../../src/stroke/stroke.ts';
import { drawings } from '../fixtures/drawings.ts';
import { penStroke, samplesAt } from '../fixtures/pen.ts';
import { ellipse, halfCircle, polygon, polyline, type Shape } from '../fixtures/shapes.ts';

const kinds: readonly FilterKind[] = ['least-squares', 'chaikin', 'cubic'];

function curve(samples: readonly Sample[], options: Partial<FilterOptions> = {}): Curve {
  return curveOf(filterStroke(samples, { ...FILTER_DEFAULTS, ...options })!);
}

const along = (c: Curve, count = 400) => Array.from({ length: count + 1 }, (_, i) => c.point(i / count));
const outline = (shape: Shape, count = 2000) => Array.from({ length: count + 1 }, (_, i) => shape(i / count));

/** The greatest distance from a point of `a` to the nearest of the dense points `b`. */
function farthest(a: readonly Vec2[], b: readonly Vec2[]): number {
  let most = 0;
  for (const [x, y] of a) {
    let least = Infinity;
    for (const q of b) least = Math.min(least, (x - q[0]) ** 2 + (y - q[1]) ** 2);
    most = Math.max(most, least);
  }
  return Math.sqrt(most);
}

/** Area between the points and the chord that closes them. */
const area = (points: readonly Vec2[]) =>
  Math.abs(
    points.reduce((sum, p, i) => {
      const q = points[(i + 1) % points.length]!;
      return sum + 0.5 * (p[0] * q[1] - q[0] * p[1]);
    }, 0),
  );

describe('filterStroke', () => {
  test('dots are null: none, one, equal, only broken samples', () => {
    for (const points of [
      [],
      [[1, 2]],
      [
        [1, 2],
        [1, 2],
      ],
      [
        [NaN, 1],
        [1, NaN],
      ],
      [
        [3, 3],
        [NaN, 0],
      ],
    ] as Vec2[][]) {
      expect(filterStroke(samplesAt(points), FILTER_DEFAULTS)).toBeNull();
    }
  });

  test.each([-1, 1.5, 7, NaN])('levels %f are refused', (levels) => {
    expect(() =>
      filterStroke(
        samplesAt([
          [0, 0],
          [1, 0],
        ]),
        { ...FILTER_DEFAULTS, levels },
      ),
    ).toThrow(RangeError);
  });

  for (const filter of kinds) {
    for (const levels of [0, 1, 2, 3, 4, 5, 6]) {
      test(`${filter}, ${levels} levels: a line stays one, ends pinned exactly, never fewer than 8 controls`, () => {
        for (const length of [0.01, 2, 40, 700]) {
          const samples = samplesAt(
            [0, 0.1, 0.4, 0.45, 0.9, 1].map((t): Vec2 => [t * length, 3 * t * length]),
          );
          const filtered = filterStroke(samples, { filter, levels })!;
          expect(filtered.degree).toBe(filter === 'chaikin' ? 2 : 3);
          expect(filtered.pieces).toHaveLength(1);
          expect(filtered.pieces[0]!.length).toBeGreaterThanOrEqual(FEWEST_CONTROLS);
          const c = curveOf(filtered);
          expect(c.point(0)).toEqual([0, 0]);
          expect(c.point(1)).toEqual([length, 3 * length]);
          for (const [i, p] of along(c, 10).entries()) {
            expect(p[0] / length).toBeCloseTo(i / 10, 4);
            expect(p[1] / length).toBeCloseTo((3 * i) / 10, 4);
          }
        }
      });
    }
  }

  for (const count of [18, 34, 50]) {
    for (const radius of [2, 10, 50, 200]) {
      const samples = samplesAt(outline(halfCircle(radius), count - 1));
      const half = (Math.PI * radius * radius) / 2;

      test(`a half circle of ${count} samples and radius ${radius} keeps it; the sphere made of it its volume`, () => {
        const points = along(curve(samples), 2000);
        const misses = points.map((p) => Math.abs(Math.hypot(p[0], p[1]) / radius - 1));
        expect(Math.max(...misses)).toBeLessThan(0.003);
        expect(Math.abs(area(points) / half - 1)).toBeLessThan(0.004);
        // the solid of revolution about the chord, by frusta
        const volume = points.slice(1).reduce((sum, p, i) => {
          const q = points[i]!;
          return sum + (Math.PI / 3) * (p[1] - q[1]) * (p[0] ** 2 + p[0] * q[0] + q[0] ** 2);
        }, 0);
        expect(Math.abs(volume / ((4 / 3) * Math.PI * radius ** 3) - 1)).toBeLessThan(0.006);
      });

      test.each(['chaikin', 'cubic'] as const)(
        `by %s ${count} samples, radius ${radius}: within 2 %`,
        (filter) => {
          const points = along(curve(samples, { filter }), 2000);
          const misses = points.map((p) => Math.abs(Math.hypot(p[0], p[1]) / radius - 1));
          expect(Math.max(...misses)).toBeLessThan(0.02);
          expect(Math.abs(area(points) / half - 1)).toBeLessThan(0.02);
        },
      );
    }
  }

  for (const seed of [1, 2, 3, 4]) {
    test(`pens of 60, 120 and 240 Hz draw the same curve (seed ${seed})`, () => {
      const wave: Shape = (t) => [120 * t, 20 * Math.sin(7 * t)];
      const dense = outline(wave);
      const at = (hz: number) => penStroke(wave, { seed, hz, speed: 80, jitter: 0.1 });
      const curves = [60, 120, 240].map((hz) => curve(at(hz)));
      for (const c of curves) {
        expect(farthest(along(c), dense)).toBeLessThan(0.3);
        expect(farthest(along(c), along(curves[2]!, 2000))).toBeLessThan(0.35);
        for (const u of [0.2, 0.5, 0.8]) {
          const [p, q] = [c.point(u), curves[2]!.point(u)];
          expect(Math.hypot(p[0] - q[0], p[1] - q[1])).toBeLessThan(0.6);
        }
      }
      const controls = [60, 120, 240].map((hz) => filterStroke(at(hz), FILTER_DEFAULTS)!.pieces[0]!.length);
      expect(Math.max(...controls) - Math.min(...controls)).toBeLessThanOrEqual(2);
    });
  }

  test('through the whole pipeline a dense pen is less noisy than a sparse one (seeds 1–6)', () => {
    const table = kinds.map((filter) => {
      const gains = [60, 240].map((hz) => {
        const squares = [1, 2, 3, 4, 5, 6].flatMap((seed) => {
          const line = penStroke((t) => [300 * t, 0], { seed, hz, speed: 100, jitter: 0.1 });
          return along(curve(line, { filter })).map((p) => (p[1] / 0.1) ** 2);
        });
        return Math.sqrt(squares.reduce((a, b) => a + b) / squares.length);
      });
      console.log(
        `pipeline noise gain at 60 / 240 Hz, ${filter}: ${gains.map((g) => g.toFixed(2)).join(' / ')}`,
      );
      return gains as [number, number];
    });
    for (const [sparse, dense] of table) expect(dense).toBeLessThan(sparse);
    expect(table[0]![0]).toBeLessThan(0.8 * table[1]![0]);
  });

  describe.each(Object.entries(drawings))('%s', (_, { samples, meant, closed, corners }) => {
    for (const filter of kinds) {
      test(`${filter}: becomes what was meant`, () => {
        const c = curve(samples, { filter });
        expect(c.closed).toBe(closed);
        expect(c.corners).toHaveLength(corners);
        expect(farthest(along(c), outline(meant))).toBeLessThan(1.2);
        expect(farthest(outline(meant, 300), along(c, 3000))).toBeLessThan(1.2);
      });
    }
  });

  test('a square is four pieces that meet, its corners sharp; without corners it is one round piece', () => {
    const samples = penStroke(polyline(polygon(4, 40)), { seed: 1 });
    const square = filterStroke(samples, FILTER_DEFAULTS)!;
    expect([square.closed, square.periodic, square.pieces.length]).toEqual([true, false, 4]);
    square.pieces.forEach((piece, i) => {
      expect(piece.at(-1)).toEqual(square.pieces[(i + 1) % 4]![0]);
    });
    expect(area(along(curveOf(square), 2000)) / 3200).toBeCloseTo(1, 1.7);
    const round = filterStroke(samples, { ...FILTER_DEFAULTS, corners: false })!;
    expect([round.closed, round.periodic, round.pieces.length]).toEqual([true, true, 1]);
  });

  test('closing can be asked for and forbidden', () => {
    const arc = penStroke((t) => [40 * Math.cos(5 * t), 40 * Math.sin(5 * t)], { seed: 1 });
    const ring = penStroke(ellipse(40, 40), { seed: 1 });
    const closed = (samples: readonly Sample[], wish: boolean | 'auto') =>
      filterStroke(samples, { ...FILTER_DEFAULTS, closed: wish })!.closed;
    expect([closed(arc, 'auto'), closed(arc, true), closed(arc, false)]).toEqual([false, true, false]);
    expect([closed(ring, 'auto'), closed(ring, true), closed(ring, false)]).toEqual([true, true, false]);
    expect(
      closed(
        samplesAt([
          [0, 0],
          [1, 0],
        ]),
        true,
      ),
    ).toBe(false);
  });

  for (const scale of [1e-3, 1e3]) {
    test(`a drawing seen ${scale} times as large, grain and all, is filtered alike`, () => {
      const { samples } = drawings.hookedWave!;
      const scaled = samples.map((s) => ({ ...s, x: s.x * scale, y: s.y * scale }));
      const [a, b] = [curve(samples), curve(scaled, { grain: scale })];
      for (const u of [0, 0.1, 0.37, 0.5, 0.9, 1]) {
        expect(b.point(u)[0] / scale).toBeCloseTo(a.point(u)[0], 6);
        expect(b.point(u)[1] / scale).toBeCloseTo(a.point(u)[1], 6);
      }
    });
  }

  test('pressure is carried through: light at both ends, strong in the middle', () => {
    const c = curve(penStroke((t) => [100 * t, 5 * t], { seed: 1 }));
    expect(c.pressure(0)).toBeLessThan(0.3);
    expect(c.pressure(0.5)).toBeGreaterThan(0.75);
    expect(c.pressure(1)).toBeLessThan(0.3);
  });

  test('two points, a line drawn back on itself, and 100,000 samples', () => {
    expect(
      curve(
        samplesAt([
          [0, 0],
          [10, 0],
        ]),
      ).length,
    ).toBeCloseTo(10, 9);
    const back = curve(
      samplesAt([
        [0, 0],
        [50, 0],
        [10, 0],
      ]),
    );
    expect(back.length).toBeCloseTo(90, 6);
    expect(back.corners).toHaveLength(1);
    const many = Array.from({ length: 100_000 }, (_, i): Vec2 => [i / 50, 30 * Math.sin(i / 2000)]);
    const c = curve(samplesAt(many));
    expect(
      farthest(
        along(c, 200),
        many.filter((_, i) => i % 10 === 0),
      ),
    ).toBeLessThan(0.3);
  });

  test('whatever is drawn, the curve is finite, and pieces meet exactly (seed 8)', () => {
    const coordinate = fc.oneof(
      fc.integer({ min: -40, max: 40 }).map((v) => v / 4),
      fc.double({ min: -200, max: 200 }),
      fc.constantFrom(NaN, Infinity, 1e300, 0),
    );
    const points = fc.array(fc.tuple(coordinate, coordinate), { maxLength: 60 });
    fc.assert(
      fc.property(
        points,
        fc.constantFrom(...kinds),
        fc.nat(6),
        fc.constantFrom<boolean | 'auto'>(true, 'auto'),
        (p, filter, levels, closed) => {
          const filtered = filterStroke(samplesAt(p), { filter, levels, closed });
          if (filtered === null) return;
          const { pieces, periodic } = filtered;
          for (const [i, piece] of pieces.entries()) {
            const next = pieces[i + 1] ?? (filtered.closed ? pieces[0]! : undefined);
            if (next && !periodic) expect(piece.at(-1)).toEqual(next[0]);
          }
          const c = curveOf(filtered);
          expect(c.length).toBeGreaterThan(0);
          for (let i = 0; i <= 20; i++) {
            const [x, y] = c.point(i / 20);
            expect(Number.isFinite(x) && Number.isFinite(y)).toBe(true);
            const t = c.tangent(i / 20);
            expect(Math.hypot(t[0], t[1])).toBeCloseTo(1, 9);
            expect(c.pressure(i / 20)).toBeCloseTo(0.5, 9);
          }
        },
      ),
      { seed: 8, numRuns: 150 },
    );
  });

  test('the samples are left alone and the same samples give the same bits', () => {
    const { samples } = drawings.overshotCircle!;
    const before = structuredClone(samples);
    const twice = [filterStroke(samples, FILTER_DEFAULTS), filterStroke(samples, FILTER_DEFAULTS)];
    expect(twice[0]).toEqual(twice[1]);
    expect(samples).toEqual(before);
  });
});
