/** Whole trees: chain rule, boxes, invariances, colours, refusals. */
import { describe, expect, test } from 'vitest';
import { bindField, PLAIN } from '../../src/field/bind.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { kernels } from '../../src/kernel/index.ts';
import { bindShape, type Shape, shapes } from '../../src/shape/index.ts';
import { FieldError } from '../../src/skeleton/skeleton.ts';
import {
  BONE,
  body,
  box,
  evaluated,
  gradientError,
  lostPoints,
  placed,
  points,
  RIGID,
  SKEW,
  sphere,
} from './trees.ts';

const affine = (matrix: typeof RIGID, node: FieldNode): FieldNode => ({ type: 'affine', matrix, node });
const set = (
  type: 'union' | 'intersection' | 'subtraction',
  form: 'hard' | 'smooth',
  ...parts: FieldNode[]
) => ({ type, form, parts }) as const;

const pair = [sphere(3), placed(box(2, 1, 4), 2, 1, 0)] as const;
const mixed = [body(), placed(sphere(2), 3, 0, 1)] as const;
const trees: readonly (readonly [string, FieldNode])[] = [
  ['body', body()],
  ['carved body', body([...BONE, { skel: { type: 'point', at: [0, 0.5, 0], weight: 2 }, factor: -1 }])],
  ...(['union', 'intersection', 'subtraction'] as const).flatMap((type) =>
    (['hard', 'smooth'] as const).flatMap((form) => [
      [`${form} ${type} of shapes`, set(type, form, ...pair)] as const,
      [`${form} ${type} with a body`, set(type, form, ...mixed, placed(sphere(1), -4, 0, 0))] as const,
    ]),
  ),
  ['blend of shapes', { type: 'blend', a: pair[0], b: pair[1], a0: 1.2, a1: 2, a2: 1 }],
  ['blend with a body', { type: 'blend', a: mixed[0], b: mixed[1], a0: 0.2, a1: 0.5, a2: 1 }],
  ['groove', { type: 'blend', a: pair[0], b: pair[1], a0: -0.8, a1: 1, a2: 1 }],
  ['morph of shapes', { type: 'morph', from: pair[0], to: pair[1], t: 0.4 }],
  ['morph with a body', { type: 'morph', from: mixed[0], to: mixed[1], t: 0.7 }],
  ['moved body', affine(RIGID, body())],
  ['skewed body', affine(SKEW, body())],
  ['skewed shapes', affine(SKEW, set('union', 'smooth', ...pair))],
  [
    'deep',
    affine(SKEW, {
      type: 'blend',
      a: set('subtraction', 'smooth', affine(RIGID, body()), sphere(1.5)),
      b: { type: 'morph', from: affine(RIGID, pair[1]), to: body(), t: 0.5 },
      a0: 0.1,
      a1: 1,
      a2: 1,
    }),
  ],
];

describe('trees', () => {
  test.each(trees)('%s: gradient = differences, the box holds the inside (seeds 61 and 62)', (_, tree) => {
    const field = bindField(tree);
    expect(gradientError(field, points(120, 7, 61))).toBeLessThan(2e-6);
    expect(lostPoints(field, 14, 2000, 62)).toEqual([]);
    expect(field.box).not.toBeNull();
  });

  test.each(trees)('%s: colour() knows the value, and stays between the colours (seed 63)', (_, tree) => {
    const field = bindField(tree);
    const colour = new Float64Array(3);
    for (const p of points(30, 9, 63)) {
      expect(field.colour(...p, colour)).toBeCloseTo(field.value(...p), 12);
      expect(colour.every((x) => x >= 0 && x <= 1)).toBe(true);
    }
  });

  test.each(kernels.map(({ name }) => name))(
    '%s: parts of a body sum to the whole (eq 1.4, seed 64)',
    (kernel) => {
      const params = {};
      const make = (skels: typeof BONE) => bindField({ type: 'skels', kernel, params, threshold: 1, skels });
      const able = BONE.filter((term) => {
        try {
          return make([term]) !== null;
        } catch {
          return false;
        }
      });
      expect(able.length).toBeGreaterThan(1);
      const [whole, parts] = [make(able), able.map((term) => make([term]))];
      for (const p of points(40, 8, 64)) {
        const sum = parts
          .map((part) => evaluated(part, p))
          .reduce((a, b) => a.map((x, i) => x + b[i]!) as never);
        const [value, ...gradient] = evaluated(whole, p);
        expect(Math.abs(value - (sum[0] + parts.length - 1))).toBeLessThan(1e-12 * (1 + Math.abs(value)));
        gradient.forEach((x, i) => {
          expect(Math.abs(x - sum[i + 1]!)).toBeLessThan(1e-12 * (1 + Math.abs(x)));
        });
      }
    },
  );

  test('a rigid motion of any tree moves its field, values unchanged (seed 65)', () => {
    for (const [, tree] of trees) {
      const [still, moved] = [bindField(tree), bindField(affine(RIGID, tree))];
      for (const [x, y, z] of points(10, 6, 65)) {
        const value = still.value(x, y, z);
        expect(Math.abs(moved.value(z + 3, x - 2, y + 5) - value)).toBeLessThan(
          1e-12 * (1 + Math.abs(value)),
        );
      }
    }
  });

  test('a scaled shape is the larger shape; a skewed one never says more than its distance (seed 66)', () => {
    const twice = bindField(affine([2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0], box(1, 2, 3)));
    const large = bindField(box(2, 4, 6));
    const skewed = bindField(affine(SKEW, sphere(2)));
    for (const p of points(200, 8, 66)) {
      expect(twice.value(...p)).toBeCloseTo(large.value(...p), 12);
      const [, ...gradient] = evaluated(skewed, p);
      expect(Math.sqrt(gradient.reduce((sum, x) => sum + x * x, 0))).toBeLessThan(1 + 1e-9);
    }
  });

  test('a scaled body is the body of scaled skels: F − T keeps its value (seed 67)', () => {
    const scaled = bindField(affine([2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0], body([BONE[1]!])));
    const built = bindField({
      ...body([{ skel: { type: 'point', at: [10, 2, 4], weight: 3 } }]),
      params: { s: 0.3 },
    });
    for (const p of points(100, 12, 67)) expect(scaled.value(...p)).toBeCloseTo(built.value(...p), 13);
  });

  test('a symmetric tree has a symmetric field (seed 68)', () => {
    const side = (x: number): FieldNode =>
      placed(
        body([{ skel: { type: 'segment', a: [0, -2, 0], b: [0, 2, 0], weights: [1, 0.1, 0.05] } }]),
        x,
        0,
        0,
      );
    for (const form of ['hard', 'smooth'] as const) {
      const field = bindField(set('union', form, side(-2), side(2), sphere(1)));
      for (const [x, y, z] of points(100, 4, 68)) {
        const [value, gx, gy, gz] = evaluated(field, [x, y, z]);
        const [mirrored, mx, my, mz] = evaluated(field, [-x, y, z]);
        expect(Math.abs(value - mirrored)).toBeLessThan(1e-13);
        expect(Math.max(Math.abs(gx + mx), Math.abs(gy - my), Math.abs(gz - mz))).toBeLessThan(1e-12);
      }
    }
  });

  test('sets have the insides of sets, in either form (seed 69)', () => {
    const fields = mixed.map(bindField);
    for (const form of ['hard', 'smooth'] as const) {
      const [union, both, first] = (['union', 'intersection', 'subtraction'] as const).map((type) =>
        bindField(set(type, form, ...mixed)),
      );
      for (const p of points(200, 5, 69)) {
        const [a, b] = fields.map((field) => field.value(...p) > 0);
        expect([union!, both!, first!].map((field) => field.value(...p) > 0)).toEqual([
          a || b,
          a && b,
          a && !b,
        ]);
      }
    }
  });

  test('a morph is its operands at the ends (seed 70)', () => {
    const [from, to] = mixed;
    const [start, end] = [bindField(from), bindField(to)];
    const at = (t: number) => bindField({ type: 'morph', from, to, t });
    for (const p of points(50, 6, 70)) {
      expect(evaluated(at(0), p)).toEqual(evaluated(start, p));
      expect(evaluated(at(1), p)).toEqual(evaluated(end, p));
    }
  });

  test('unbounded trees say so, bounded ones inside them count', () => {
    const half: FieldNode = { type: 'shape', shape: { type: 'halfSpace', normal: [0, 1, 0], offset: 0 } };
    expect(bindField(half).box).toBeNull();
    expect(bindField(set('union', 'hard', half, sphere(1))).box).toBeNull();
    expect(bindField(set('intersection', 'hard', half, sphere(1))).box).toEqual({
      min: [-1, -1, -1],
      max: [1, 1, 1],
    });
    expect(bindField(set('subtraction', 'smooth', half, sphere(1))).box).toBeNull();
    // a shift above what both bodies are worth far away fills space
    expect(bindField({ type: 'blend', a: body(), b: body(), a0: 50, a1: 1, a2: 1 }).box).toBeNull();
  });

  test('every shape of the list is a node', () => {
    for (const kind of Object.values(shapes)) {
      const shape = kind.examples[0] as Shape;
      expect(bindField({ type: 'shape', shape }).value(1, 2, 3)).toBe(bindShape(shape).value(1, 2, 3));
    }
  });
});

describe('many parts', () => {
  const many = new Array<FieldNode>(10_000).fill(sphere(2));

  test.each(['hard', 'smooth'] as const)('ten thousand in a %s union are finite in and out', (form) => {
    const field = bindField({ type: 'union', form, parts: many });
    expect(field.box).toEqual({ min: [-2, -2, -2], max: [2, 2, 2] });
    for (const x of [0.5, 1.999, 3]) {
      const numbers = evaluated(field, [x, 0, 0]);
      expect(numbers.every(Number.isFinite)).toBe(true);
      expect(numbers[0]).toBe(field.value(x, 0, 0));
      expect(numbers[0] > 0).toBe(x < 2);
    }
  });
});

describe('colours', () => {
  const red: FieldNode = { type: 'shape', shape: { type: 'sphere', radius: 2 }, colour: [1, 0, 0] };
  const blue = placed({ type: 'shape', shape: { type: 'sphere', radius: 2 }, colour: [0, 0, 1] }, 3, 0, 0);
  const at = (node: FieldNode, x: number, y: number, z: number): number[] => {
    const out = new Float64Array(3);
    bindField(node).colour(x, y, z, out);
    return [...out];
  };

  test('on a union each part keeps its own', () => {
    for (const form of ['hard', 'smooth'] as const) {
      expect(at(set('union', form, red, blue), -2, 0, 0)).toEqual([1, 0, 0]);
      at(set('union', form, red, blue), 5, 0, 0).forEach((x, i) => {
        expect(x).toBeCloseTo([0, 0, 1][i]!, 12);
      });
    }
  });

  test('a cut has the colour of what cut it', () => {
    expect(at(set('subtraction', 'hard', red, blue), 1, 0, 0)).toEqual([0, 0, 1]);
    expect(at(set('subtraction', 'hard', red, blue), -2, 0, 0)).toEqual([1, 0, 0]);
  });

  test('in a blend they flow into each other, in a morph with t', () => {
    const [r, , b] = at({ type: 'blend', a: red, b: blue, a0: 1, a1: 1, a2: 1 }, 1.5, 1.8, 0);
    expect(r).toBeCloseTo(0.5, 12);
    expect(b).toBeCloseTo(0.5, 12);
    expect(at({ type: 'morph', from: red, to: blue, t: 0.25 }, 1, 1, 1)).toEqual([0.75, 0, 0.25]);
  });

  test('skels mix by what they add; what carves has none', () => {
    const term = (x: number, colour: readonly [number, number, number], factor = 1) =>
      ({ skel: { type: 'point', at: [x, 0, 0], weight: 1 }, colour, factor }) as const;
    const mix = at(body([term(-1, [1, 0, 0]), term(1, [0, 0, 1])]), 0, 3, 0);
    expect(mix[0]).toBeCloseTo(0.5, 14);
    expect(mix[2]).toBeCloseTo(0.5, 14);
    expect(at(body([term(-1, [1, 0, 0]), term(1, [0, 0, 1], -1)]), 0, 3, 0)).toEqual([1, 0, 0]);
    expect(at(body([{ skel: { type: 'point', at: [0, 0, 0], weight: 1 } }]), 1, 0, 0)).toEqual([0, 1, 0]);
    expect(at(sphere(1), 1, 0, 0)).toEqual([...PLAIN]);
    const far = { ...body([term(0, [1, 0, 0])]), kernel: 'quartic', params: { R: 2 } };
    expect(at(far, 90, 0, 0)).toEqual([1, 0, 0]);
  });
});

describe('refusals name the place', () => {
  const bad = { type: 'shape', shape: { type: 'sphere', radius: -1 } } as const;
  test.each<[string, FieldNode, RegExp]>([
    ['a shape', bad, /^shape: radius must be above 0 mm, got -1$/],
    ['deep', set('union', 'hard', sphere(1), affine(RIGID, bad)), /^parts\[1\]\.node\.shape: radius/],
    ['a morph', { type: 'morph', from: bad, to: bad, t: 0.5 }, /^from\.shape: /],
    ['its t', set('union', 'hard', { type: 'morph', from: bad, to: bad, t: 2 }), /^parts\[0\]: t must be/],
    ['a blend', { type: 'blend', a: sphere(1), b: bad, a0: 1, a1: 1, a2: 1 }, /^b\.shape: /],
    ['a flat matrix', affine([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0], sphere(1)), /^matrix flattens/],
    ['nothing to unite', set('union', 'hard'), /^union has no parts$/],
    ['a form', set('union', 'soft' as never, sphere(1)), /unknown form 'soft'/],
    ['a node', { type: 'twist' } as never, /^unknown node 'twist'/],
    ['a kernel', { ...body(), kernel: 'gauss' }, /^unknown kernel 'gauss'/],
    ['a parameter', { ...body(), params: { s: -1 } }, /^params: s must be .* got -1/],
    ['a foreign parameter', { ...body(), params: { R: 1 } }, /^params: kernel cauchy has no parameter 'R'/],
    ['no skels', body([]), /at least one skel/],
    ['a threshold', body(BONE, 0), /threshold must be above 0, got 0/],
    ['a factor', body([{ ...BONE[0]!, factor: Number.NaN }]), /^skels\[0\]: factor/],
    ['a colour', body([BONE[0]!, { ...BONE[1]!, colour: [2, 0, 0] }]), /^skels\[1\]: a colour/],
    [
      'a skel',
      body([{ skel: { type: 'point', at: [0, 0, 0], weight: Number.NaN } }]),
      /^skels\[0\]: .*weight/,
    ],
    ['a kind of skel', body([{ skel: { type: 'helix' } as never }]), /^skels\[0\]: unknown skel 'helix'/],
  ])('%s', (_, tree, message) => {
    expect(() => bindField(tree)).toThrow(message);
    expect(() => bindField(tree)).toThrow(FieldError);
  });

  test('a tree too deep for the stack', () => {
    let tree = sphere(1);
    for (let i = 0; i < 300; i++) tree = placed(tree, 0, 0, 0);
    expect(() => bindField(tree)).toThrow(/deeper than 200/);
  });

  test('a pair without a field', () => {
    const polygon = BONE[2]!;
    const refused = kernels.filter(({ edge }) => !edge);
    for (const { name } of refused) {
      expect(() => bindField({ ...body([BONE[0]!, polygon]), kernel: name, params: {} })).toThrow(
        /^skels\[1\]: /,
      );
    }
  });
});
