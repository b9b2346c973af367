/** What is refused when a field is built, bounds, and skels that are nothing. */
import { describe, expect, it } from 'vitest';
import { kernelNamed, kernels } from '../../src/kernel/index.ts';
import { bindSkel } from '../../src/skeleton/index.ts';
import { FieldError } from '../../src/skeleton/skeleton.ts';
import type { PolygonSkel, Skel } from '../../src/skeleton/skels.ts';

const cauchy = kernelNamed('cauchy')!;
const square: PolygonSkel = {
  type: 'polygon',
  origin: [1, 2, 3],
  u: [2, 0, 0],
  v: [1, 1, 0],
  loops: [
    [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ],
  ],
  weight: 1,
};
const point: Skel = { type: 'point', at: [0, 0, 0], weight: 1 };
const segment: Skel = { type: 'segment', a: [0, 0, 0], b: [1, 2, 2], weights: [1, 2] };

const REFUSED: readonly (readonly [what: string, skel: Skel, message: RegExp])[] = [
  ['a point nowhere', { ...point, at: [0, Number.NaN, 0] }, /within ±.*, found NaN/],
  ['an infinite weight', { ...point, weight: Infinity }, /within ±.*, found Infinity/],
  [
    'a segment to infinity',
    { ...segment, b: [Infinity, 0, 0] },
    /within ±1000000000000000 mm, found Infinity/,
  ],
  ['a segment beyond all reason', { ...segment, b: [1e100, 0, 0] }, /within ±1000000000000000 mm/],
  ['a weight beyond all reason', { ...segment, weights: [1, 1e308] }, /within ±1e\+60, found 1e\+308/],
  ['no weights', { ...segment, weights: [] }, /1 to 4 weights.*found 0/],
  ['a weight of degree 4', { ...segment, weights: [1, 2, 3, 4, 5] }, /found 5/],
  ['axes on one line', { ...square, v: [-1, 0, 0] }, /span a plane/],
  ['an axis without length', { ...square, u: [0, 0, 0] }, /length above 0/],
  ['no loops', { ...square, loops: [] }, /at least one loop/],
  ['two vertices', { ...square, loops: [square.loops[0]!.slice(0, 2)] }, /at least 3 vertices, found 2/],
  [
    'vertices on one line',
    {
      ...square,
      loops: [
        [
          [0, 0],
          [1, 1],
          [2, 2],
        ],
      ],
    },
    /loop 0 of a polygon has no area/,
  ],
  [
    'a bow-tie',
    {
      ...square,
      loops: [
        [
          [0, 0],
          [2, 2],
          [2, 0],
          [0, 2],
        ],
      ],
    },
    /loop 0 of a polygon crosses itself/,
  ],
  [
    'four vertices on one line',
    {
      ...square,
      loops: [
        [
          [0, 0],
          [3, 3],
          [1, 1],
          [2, 2],
        ],
      ],
    },
    /loop 0 of a polygon has no area/,
  ],
  [
    'one vertex three times',
    {
      ...square,
      loops: [
        [
          [1, 1],
          [1, 1],
          [1, 1],
        ],
      ],
    },
    /no area/,
  ],
  [
    'a flat hole',
    {
      ...square,
      loops: [
        ...square.loops,
        [
          [0, 0],
          [1, 0],
          [0.5, 0],
        ],
      ],
    },
    /loop 1/,
  ],
  [
    'a hole larger than its outline',
    {
      ...square,
      loops: [
        ...square.loops,
        [
          [-9, -9],
          [9, -9],
          [0, 9],
        ],
      ],
    },
    /smaller/,
  ],
  [
    'a vertex nowhere',
    {
      ...square,
      loops: [
        [
          [0, 0],
          [1, 0],
          [0, Number.NaN],
        ],
      ],
    },
    /vertices.*found NaN/,
  ],
];

describe('building a field', () => {
  it.each(REFUSED)('refuses %s', (_, skel, message) => {
    expect(() => bindSkel(skel, cauchy, {})).toThrow(FieldError);
    expect(() => bindSkel(skel, cauchy, {})).toThrow(message);
  });

  it('refuses parameters that are unknown, out of range or no number', () => {
    for (const kernel of kernels) {
      for (const { name, min, max } of kernel.params) {
        for (const wrong of [min / 2, max * 2, 0, -1, Number.NaN, Infinity]) {
          expect(() => bindSkel(point, kernel, { [name]: wrong })).toThrow(
            `${kernel.name}: ${name} must be from`,
          );
        }
        for (const right of [min, max]) bindSkel(segment, kernel, { [name]: right });
      }
      expect(() => bindSkel(point, kernel, { q: 1 } as object)).toThrow(/has no parameter q/);
      bindSkel(point, kernel, {});
    }
  });

  it('refuses a pair without a field', () => {
    const flat = { ...cauchy, edge: null };
    expect(() => bindSkel(square, flat, {})).toThrow(FieldError);
    expect(() => bindSkel(square, flat, {})).toThrow(/polygons have no field of the kernel cauchy/);
    expect(bindSkel(segment, flat, {}).value(1, 1, 1)).toBeGreaterThan(0);
  });

  it('takes loops either way round, repeats a vertex or not', () => {
    const [loop] = square.loops;
    const turned = { ...square, loops: [[...loop!].reverse()] };
    const repeated = { ...square, loops: [[...loop!, loop![0]!]] };
    for (const kernel of kernels) {
      const wanted = bindSkel(square, kernel, {}).value(1.5, 2, 4);
      expect(bindSkel(turned, kernel, {}).value(1.5, 2, 4)).toBeCloseTo(wanted, 12);
      expect(bindSkel(repeated, kernel, {}).value(1.5, 2, 4)).toBeCloseTo(wanted, 12);
      expect(wanted).toBeGreaterThan(0);
    }
  });

  it('a segment of no length and skels of no weight are no field', () => {
    const nothing: readonly Skel[] = [
      { type: 'segment', a: [1, 2, 3], b: [1, 2, 3], weights: [5] },
      { type: 'segment', a: [0, 0, 0], b: [1e-100, 0, 0], weights: [5] },
      { ...segment, weights: [0, 0] },
      { ...point, weight: 0 },
      { ...square, weight: 0 },
    ];
    for (const kernel of kernels) {
      for (const skel of nothing) {
        const field = bindSkel(skel, kernel, {});
        const out = Float64Array.of(1, 2, 3, 4);
        field.add(1, 2, 3.5, 1, out);
        expect([...out]).toEqual([1, 2, 3, 4]);
        expect(field.value(1, 2, 3.5) === 0).toBe(true);
        expect(field.offset(1e-3)).toBe(0);
      }
    }
  });
});

describe('boxes and offsets', () => {
  it('a box holds the skel, not its field', () => {
    expect(bindSkel(point, cauchy, {}).box).toEqual({ min: [0, 0, 0], max: [0, 0, 0] });
    expect(bindSkel({ ...segment, a: [0, 3, 0] }, cauchy, {}).box).toEqual({
      min: [0, 2, 0],
      max: [1, 3, 2],
    });
    expect(bindSkel(square, cauchy, {}).box).toEqual({ min: [0, 1, 3], max: [2, 3, 3] });
  });

  it('are the closed forms of infinite lines, points and plates where the skel is large', () => {
    const [s, w, T] = [4, 2, 0.3];
    const long: Skel = { type: 'segment', a: [-500, 0, 0], b: [500, 0, 0], weights: [w] };
    const line = Math.sqrt(((Math.PI * w) / (2 * s * T)) ** (2 / 3) - 1) / s;
    expect(bindSkel(long, cauchy, { s }).offset(T)).toBeCloseTo(line, 10);
    const lone = Math.sqrt(Math.sqrt(w / T) - 1) / s;
    expect(bindSkel({ ...point, weight: w }, cauchy, { s }).offset(T)).toBeCloseTo(lone, 10);
    const large = {
      ...square,
      loops: [square.loops[0]!.map(([x, y]) => [900 * x, 900 * y] as const)],
      weight: w,
    };
    const plate = Math.sqrt((w * Math.PI) / (s * s * T) - 1) / s;
    expect(bindSkel(large, cauchy, { s }).offset(T)).toBeCloseTo(plate, 10);
  });

  it('none where the field is nowhere as large, the support or infinity where any of it counts', () => {
    const quartic = kernelNamed('quartic')!;
    for (const skel of [point, segment, square]) {
      expect(bindSkel(skel, cauchy, { s: 1 }).offset(1e6)).toBe(0);
      expect(bindSkel(skel, quartic, { R: 2 }).offset(0)).toBe(2);
      expect(bindSkel(skel, quartic, { R: 2 }).offset(1e-12)).toBeLessThanOrEqual(2);
      expect(bindSkel(skel, cauchy, { s: 1 }).offset(0)).toBe(Infinity);
    }
  });

  it('a support ends: exactly nothing beyond', () => {
    const quartic = kernelNamed('quartic')!;
    for (const skel of [point, segment, square]) {
      const field = bindSkel(skel, quartic, { R: 2 });
      const out = new Float64Array(4);
      for (const [x, y, z] of [
        [1, 2, 30],
        [-40, 2, 3],
        [9, 9, 9],
      ] as const) {
        field.add(x, y, z, 1, out);
        expect(field.value(x, y, z) === 0).toBe(true);
      }
      expect([...out].every((x) => x === 0)).toBe(true);
    }
  });
});

describe('as far away as doubles go', () => {
  it.each(kernels.map((kernel) => [kernel.name, kernel] as const))('%s is finite', (_, kernel) => {
    for (const skel of [point, segment, square]) {
      const field = bindSkel(skel, kernel, {});
      for (const far of [1e12, 1e30, 1e100]) {
        for (const [x, y, z] of [
          [far, 2, 3],
          [1, -far, far],
          [-far, far, -far],
        ] as const) {
          const out = new Float64Array(4);
          field.add(x, y, z, 1, out);
          expect([...out, field.value(x, y, z)].every(Number.isFinite)).toBe(true);
          expect(Math.abs(out[0]!)).toBeLessThan(1e-9);
        }
      }
    }
  });
});

describe('on the skel itself', () => {
  it.each(kernels.map((kernel) => [kernel.name, kernel] as const))(
    '%s is finite and has the sign of its weight',
    (_, kernel) => {
      for (const [skel, [x, y, z]] of [
        [point, [0, 0, 0]],
        [segment, [0.5, 1, 1]],
        [segment, [1, 2, 2]],
        [square, [1.25, 2.25, 3]],
        [square, [1, 1, 3]],
      ] as const) {
        const out = new Float64Array(4);
        bindSkel(skel, kernel, {}).add(x, y, z, 1, out);
        expect([...out].every(Number.isFinite)).toBe(true);
        expect(out[0]).toBeGreaterThan(0);
      }
    },
  );
});
