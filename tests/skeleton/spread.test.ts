/** What a skel's field may be within a box: holds what it is, tightly. */
import { describe, expect, test } from 'vitest';
import { AROUND, closed } from '../../src/field/closed.ts';
import { cos, sin, TAU } from '../../src/math/trig.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { Ball } from '../../src/skeleton/ball.ts';
import { bindSkel } from '../../src/skeleton/index.ts';
import { type SkelField, SPREAD } from '../../src/skeleton/skeleton.ts';
import type { Skel } from '../../src/skeleton/skels.ts';
import { random } from '../fixtures/random.ts';
import { type Variant, variants } from '../kernel/variants.ts';
import { scaleOf } from './compare.ts';
import { everySpecimen, pointsAround } from './specimens.ts';

const SEED = 52;
const SIZES = [0, 1e-3, 1e-2, 0.1, 0.5, 2, 10];
const KINDS = ['point', 'segment', 'polygon'] as const;
const spread = new Float64Array(SPREAD);
const range = new Float64Array(2);

function rangeOf(field: SkelField, [x, y, z]: Vec3, half: number, factor = 1): readonly [number, number] {
  spread.fill(0);
  field.spread(new Ball().set(x, y, z, AROUND * half), factor, spread);
  closed(spread, half, range);
  return [range[0]!, range[1]!];
}

/** Those and the middles of edges and faces. */
function* corners([x, y, z]: Vec3, half: number): Generator<Vec3> {
  for (let i = 0; i < 27; i++) {
    yield [
      x + half * ((i % 3) - 1),
      y + half * ((Math.floor(i / 3) % 3) - 1),
      z + half * (Math.floor(i / 9) - 1),
    ];
  }
}

/** The ends and centres of faces, edges and the cube, and places by lot. */
function* within([x, y, z]: Vec3, half: number, count: number, next: () => number): Generator<Vec3> {
  for (let i = 0; i < count; i++) {
    const one = () => (next() < 0.5 ? Math.floor(3 * next()) - 1 : 2 * next() - 1);
    yield [x + half * one(), y + half * one(), z + half * one()];
  }
}

const bound = (skel: Skel, { kernel, params }: Variant) => bindSkel(skel, kernel, params);
const ofKind = (kind: Skel['type']) => everySpecimen.filter(({ type }) => type === kind);

/** In words, what the interval or the centred form does not hold. */
function escaped(field: SkelField, p: Vec3, half: number, factor: number, next: () => number): string[] {
  const [low, high] = rangeOf(field, p, half, factor);
  const [middle, gx, gy, gz, rest] = [0, 1, 2, 3, 4].map((i) => spread[i]!) as [
    number,
    number,
    number,
    number,
    number,
  ];
  return [...within(p, half, 8, next)].flatMap((q) => {
    const value = factor * field.value(...q);
    const away = [gx * (q[0] - p[0]), gy * (q[1] - p[1]), gz * (q[2] - p[2])] as const;
    const rounding = 1e-15 * (Math.abs(middle) + Math.abs(away[0]) + Math.abs(away[1]) + Math.abs(away[2]));
    const miss = Math.abs(value - (middle + away[0] + away[1] + away[2])) - rounding;
    const place = `${half} about ${p}`;
    if (miss > rest) return [`${value} is ${miss / rest} of the rest away, ${place}`];
    return value >= low && value <= high ? [] : [`${value} not in ${low}…${high}, ${place}`];
  });
}

/** Weights of both signs and of any degree, outlines that go round themselves and long ones, skels of no weight. */
const WILD: readonly Skel[] = [
  ...[[1, -1], [-1, 0.2, 0.7], [0.3, 1, -2, 0.6], [0, 0, 0, 1], [-1, 0.1], [0]].map(
    (weights): Skel => ({ type: 'segment', a: [-0.5, 0.2, 1], b: [1.2, 1, -0.4], weights }),
  ),
  { type: 'point', at: [0.2, 0.1, -0.3], weight: 0 },
  ...[
    [1, 7, 1],
    [2, 7, -0.5],
    [3, 10, 1],
    [1, 90, 0.3],
  ].map(([turns, corners, weight]): Skel => {
    const at = (i: number) =>
      [cos((i * turns! * TAU) / corners!), sin((i * turns! * TAU) / corners!)] as const;
    const wavy = (i: number) => 1.5 + 0.4 * cos(i);
    const loop = Array.from(
      { length: corners! },
      (_, i) => [wavy(i) * at(i)[0], wavy(i) * at(i)[1]] as const,
    );
    return {
      type: 'polygon',
      origin: [0, 0.5, 0.2],
      u: [1, 0.2, 0],
      v: [0, 1, 0.4],
      loops: [loop],
      weight: weight!,
    };
  }),
];

describe('the spread of a skel', () => {
  test(`holds every value of every kernel and specimen, with either sign (seed ${SEED})`, () => {
    const next = random(SEED);
    let boxes = 0;
    for (const variant of variants) {
      [...everySpecimen, ...WILD].forEach((skel, i) => {
        const field = bound(skel, variant);
        const wrong = pointsAround(skel, SEED + i, 8).flatMap((p, j) => {
          boxes++;
          return escaped(field, p, SIZES[(i + j) % SIZES.length]!, j % 2 === 0 ? 1 : -0.5, next);
        });
        expect(wrong, `${variant.title} ${JSON.stringify(skel)}`).toEqual([]);
      });
    }
    console.info(`spreads of skels: ${boxes} boxes hold ${8 * boxes} values`);
  });

  test(`holds them on the skel, where singular kernels stop growing (seed ${SEED})`, () => {
    const next = random(SEED);
    const places = (skel: Skel): Vec3[] => {
      if (skel.type === 'point') return [skel.at];
      if (skel.type === 'polygon') return [skel.origin];
      return [
        skel.a,
        skel.b,
        [0.5 * (skel.a[0] + skel.b[0]), 0.5 * (skel.a[1] + skel.b[1]), 0.5 * (skel.a[2] + skel.b[2])],
      ];
    };
    for (const variant of variants) {
      for (const skel of [...everySpecimen, ...WILD]) {
        const field = bound(skel, variant);
        for (const half of [0, 1e-14, 1e-12, 1e-9, 1e-3, 1]) {
          for (const p of places(skel)) {
            expect(rangeOf(field, p, half).every(Number.isFinite)).toBe(true);
            expect(escaped(field, p, half, 1, next), `${variant.title} ${JSON.stringify(skel)}`).toEqual([]);
          }
        }
      }
    }
  });

  test.each([1e6, 1e-6])(`holds them at sizes of %d mm (seed ${SEED})`, (unit) => {
    const next = random(SEED);
    for (const { kernel, params } of variants) {
      const scaled = {
        ...params,
        ...(params.s && { s: params.s / unit }),
        ...(params.R && { R: params.R * unit }),
      };
      everySpecimen.forEach((skel, i) => {
        const field = bindSkel(scaledSkel(skel, unit), kernel, scaled);
        const wrong = pointsAround(skel, SEED + i, 4).flatMap(([x, y, z], j) =>
          escaped(field, [x * unit, y * unit, z * unit], unit * SIZES[j % SIZES.length]!, 1, next),
        );
        expect(wrong, `${kernel.name} ${JSON.stringify(skel)}`).toEqual([]);
      });
    }
  });

  test('is nothing at all beyond a support', () => {
    const variant = variants.find(({ kernel }) => kernel.name === 'quartic')!;
    for (const skel of everySpecimen) {
      const field = bound(skel, variant);
      const { min, max } = field.box;
      const away = 2.5 + AROUND * 0.5 + 1e-9 + (max[0] - min[0]) + (max[1] - min[1]) + (max[2] - min[2]);
      for (const p of [
        [max[0] + away, 0, 0],
        [0, min[1] - away, 0],
        [min[0], max[1] + away, max[2]],
      ] as const)
        expect(rangeOf(field, p, 0.5)).toEqual([0, 0]);
    }
  });

  test('comes down to the value as the box shrinks to a point', () => {
    for (const variant of variants) {
      everySpecimen.forEach((skel, i) => {
        const field = bound(skel, variant);
        for (const p of pointsAround(skel, SEED + i, 2)) {
          const [low, high] = rangeOf(field, p, 0);
          const scale = Math.abs(field.value(...p)) + scaleOf(skel, variant, p).size;
          expect(high - low, `${variant.title} ${JSON.stringify(skel)} ${p}`).toBeLessThanOrEqual(
            1e-9 * scale + 1e-299,
          );
        }
      });
    }
  });

  test(`is tight: the width over that of the values sampled, about the skel (seed ${SEED})`, () => {
    for (const variant of variants.filter(({ params: { n } }) => n === undefined || n === 3)) {
      const looseness = KINDS.map((kind) => [0.01, 0.1, 0.5].map((half) => median(kind, half, variant)));
      const rows = looseness.map((numbers) => numbers.map((x) => x.toFixed(2)).join(', '));
      console.info(`looseness ${variant.title}, point | segment | polygon: ${rows.join(' | ')}`);
      for (const [fine, middle, coarse] of looseness) {
        expect(fine).toBeLessThan(1.3);
        expect(middle).toBeLessThan(3);
        expect(coarse).toBeLessThan(8);
      }
    }
  });
});

function scaledSkel(skel: Skel, unit: number): Skel {
  const scaled = ([x, y, z]: Vec3): Vec3 => [x * unit, y * unit, z * unit];
  switch (skel.type) {
    case 'point':
      return { ...skel, at: scaled(skel.at) };
    case 'segment': {
      const weights = skel.weights.map((weight, k) => weight / unit ** (k + 1));
      return { ...skel, a: scaled(skel.a), b: scaled(skel.b), weights };
    }
    case 'polygon': {
      const loops = skel.loops.map((loop) => loop.map(([x, y]) => [x * unit, y * unit] as const));
      return { ...skel, origin: scaled(skel.origin), loops };
    }
  }
}

/** Of the looseness of boxes whose centres are within 2 mm of the skel's box. */
function median(kind: Skel['type'], half: number, variant: Variant): number {
  const next = random(SEED);
  const found = ofKind(kind).flatMap((skel) => {
    const field = bound(skel, variant);
    const { min, max } = field.box;
    return Array.from({ length: 12 }, () => {
      const at = (i: 0 | 1 | 2) => min[i] - 2 + (max[i] - min[i] + 4) * next();
      const p: Vec3 = [at(0), at(1), at(2)];
      const [low, high] = rangeOf(field, p, half);
      const values = [...corners(p, half)].map((q) => field.value(...q));
      const width = Math.max(...values) - Math.min(...values);
      return width > 0 ? (high - low) / width : 1;
    });
  });
  return found.sort((a, b) => a - b)[found.length >> 1]!;
}
