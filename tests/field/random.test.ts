/** What any tree owes, on trees drawn by lot. */
import { describe, expect, test } from 'vitest';
import type { Affine } from '../../src/field/affine.ts';
import { bindField } from '../../src/field/bind.ts';
import type { TreeField } from '../../src/field/treeField.ts';
import type { Box } from '../../src/skeleton/skeleton.ts';
import { Lot } from './lot.ts';
import { randomBody, randomTree } from './randomTrees.ts';
import { evaluated, gradientError, type Point, SKEW } from './trees.ts';

const TREES = 60;
const SEED = 4000;
const out = new Float64Array(4);
const colour = new Float64Array(3);

/** Near and far from the middle. */
function places(lot: Lot, count: number): Point[] {
  return lot.many(count, (i) => {
    const half = [3, 8, 30][i % 3]! * lot.unit;
    const one = () => lot.between(-half, half);
    return [one(), one(), one()];
  });
}

const isOut = ({ min, max }: Box, p: Point, unit: number) =>
  p.some((x, i) => x < min[i]! - 1e-9 * unit || x > max[i]! + 1e-9 * unit);

/** Levels of the values of bodies and of shapes. */
const levelsOf = (unit: number) => [0, -0.1, -0.4, -0.1 * unit, -0.4 * unit];

/** In words, what is wrong with the field at points. */
function faults(field: TreeField, points: readonly Point[], unit: number): string[] {
  const boxes = levelsOf(unit).map((level) => [level, field.boxAbove(level)] as const);
  return points.flatMap((p) => faultsAt(field, boxes, p, unit).map((fault) => `${fault} at ${p}`));
}

function faultsAt(
  field: TreeField,
  boxes: readonly (readonly [level: number, box: Box | null])[],
  p: Point,
  unit: number,
): string[] {
  const value = field.value(...p);
  field.evaluate(...p, out);
  const seen = field.colour(...p, colour);
  const same = (x: number) => Math.abs(x - value) <= 1e-12 * Math.abs(value) + 1e-14 * (1 + unit);
  return [
    ...(Number.isFinite(value) && out.every(Number.isFinite) ? [] : ['not finite']),
    ...(same(out[0]!) && same(seen) ? [] : ['three values']),
    ...(colour.every((x) => x >= 0 && x <= 1) ? [] : ['colour']),
    ...boxes
      .filter(([level, box]) => box && value > level && isOut(box, p, unit))
      .map(([level]) => `box above ${level}`),
  ];
}

describe('trees drawn by lot', () => {
  test.each([1, 1e6, 1e-6])(
    `finite, one value, colours, boxes, sizes of %d mm (${TREES} trees from seed ${SEED})`,
    (unit) => {
      for (let seed = SEED; seed < SEED + TREES; seed++) {
        const lot = new Lot(seed, unit);
        const field = bindField(randomTree(lot));
        expect(faults(field, places(lot, 30), unit), `seed ${seed}`).toEqual([]);
      }
    },
  );

  test(`the gradient is the differences of the value (${TREES} trees from seed ${SEED})`, () => {
    for (let seed = SEED; seed < SEED + TREES; seed++) {
      const lot = new Lot(seed);
      const field = bindField(randomTree(lot));
      const points = places(lot, 24).filter((_, i) => i % 3 < 2);
      expect(gradientError(field, points, 2e-4), `seed ${seed}`).toBeLessThan(2e-5);
    }
  });

  test(`a body keeps its values under any matrix, gradients follow (${TREES} bodies from seed ${SEED})`, () => {
    for (let seed = SEED; seed < SEED + TREES; seed++) {
      const lot = new Lot(seed);
      const body = randomBody(lot);
      const size = [1, 1e6, 1e-6][seed % 3]!;
      // sheared and mirrored
      const m = SKEW.map((entry) => size * entry) as unknown as Affine;
      const [still, moved] = [bindField(body), bindField({ type: 'affine', matrix: m, node: body })];
      const away = lot.many(8, () => {
        const p = lot.place();
        const [value, ...gradient] = evaluated(still, p);
        const [found, gx, gy, gz] = evaluated(moved, applied(m, p));
        // ∇f = Mᵀ ∇f′
        const back = [0, 1, 2].map((k) => m[k]! * gx + m[4 + k]! * gy + m[8 + k]! * gz);
        const steep = 1 + Math.abs(value) + Math.max(...gradient.map(Math.abs));
        return Math.max(...[found - value, ...back.map((x, k) => x - gradient[k]!)].map(Math.abs)) / steep;
      });
      expect(Math.max(...away), `seed ${seed}`).toBeLessThan(1e-7);
      const places = lot.many(8, () => applied(m, lot.place()));
      expect(faults(moved, places, size), `seed ${seed}`).toEqual([]);
    }
  });

  test(`a sum is finite on its skels: ends, vertices, middles, beyond (${TREES} bodies from seed ${SEED})`, () => {
    for (let seed = SEED; seed < SEED + TREES; seed++) {
      const body = randomBody(new Lot(seed));
      const field = bindField(body);
      const { box } = field;
      for (const { skel } of body.skels) {
        const at = Object.values(skel).flatMap((entry: unknown) => vectors(entry));
        const more = at.slice(1).map((b, i) => b.map((x, k) => 0.5 * (x + at[i]![k]!)) as unknown as Point);
        const beyond = at.slice(1).map((b, i) => b.map((x, k) => 2 * x - at[i]![k]!) as unknown as Point);
        expect(faults(field, [...at, ...more, ...beyond], 1), `seed ${seed}`).toEqual([]);
      }
      if (box) expect([...box.min, ...box.max].every(Number.isFinite)).toBe(true);
    }
  });
});

const applied = (m: Affine, [x, y, z]: Point): Point => {
  const row = (r: number) => m[r]! * x + m[r + 1]! * y + m[r + 2]! * z + m[r + 3]!;
  return [row(0), row(4), row(8)];
};

/** The points among the data of a skel. */
function vectors(entry: unknown): Point[] {
  if (!Array.isArray(entry)) return [];
  if (entry.length === 3 && entry.every((x) => typeof x === 'number')) return [entry as unknown as Point];
  return entry.flatMap(vectors);
}
