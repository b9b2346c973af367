import { describe, expect, test } from 'vitest';
import { DEFAULT_BRUSH } from '../../../src/document/document.ts';
import { plate as form } from '../../../src/document/form/plate.ts';
import { kernelNamed, kernels } from '../../../src/kernel/index.ts';
import type { Vec2 } from '../../../src/math/vec.ts';
import type { MedialGraph } from '../../../src/skeleton/medial/axis.ts';
import { FieldError } from '../../../src/skeleton/skeleton.ts';
import type { Skel } from '../../../src/skeleton/skels.ts';
import { expectSolid, made } from '../../field/meshes.ts';
import { random } from '../../fixtures/random.ts';
import { box, disc, plate, polar, SHAPES, shifted } from '../../fixtures/silhouettes.ts';
import { outlineError } from '../../skeleton/medial/outlineError.ts';
import { lineInk, loopInk } from './inks.ts';
import { depth, type Formed, formed, THRESHOLD } from './surfaces.ts';

const KERNELS = ['cauchy', 'quartic', 'inverseCubic'] as const;
const UP = [0, 0, 1] as const;

const off = ({ shaped, sum }: Formed, loops: readonly (readonly Vec2[])[]) =>
  outlineError(shaped.skels as readonly Skel[], loops, sum.kernel, sum.params, THRESHOLD);

describe.each(KERNELS)('plates of the kernel %s', (kernel) => {
  test.each([3, 6, 10])('are 2 times %d mm thick in the middle', (radius) => {
    const found = formed(form, loopInk([disc(30)], { brush: { ...DEFAULT_BRUSH, radius } }), kernel)!;
    const half = depth(found, [0, 0, 0], UP, 60);
    expect(Math.abs(half / radius - 1)).toBeLessThan(0.02);
    expect(Math.abs(depth(found, [0, 0, 0], [0, 0, -1], 60) - half)).toBeLessThan(1e-6);
  });

  test.each(['disc', 'ellipse', 'bean', 'drop', 'box', 'plate with two holes'])(
    'follow the stroke: %s',
    (name) => {
      const found = formed(form, loopInk(SHAPES[name]!), kernel)!;
      expect(off(found, SHAPES[name]!).mean).toBeLessThan(name === 'box' ? 0.009 : 0.004);
      expect(found.shaped.skeleton.nodes.length).toBeLessThan(120);
    },
  );
});

describe.each(['cauchy', 'quartic'])('plates with holes, of the kernel %s', (kernel) => {
  test.each([0, 1, 2, 3, 4, 5])('%d holes', (count) => {
    const found = formed(form, loopInk(plate(Math.max(count, 1)).slice(0, 1 + count)), kernel)!;
    expect(found.shaped.skels).toHaveLength(1);
    expectSolid(made(found.node, 64).mesh, count);
  });
});

describe('plates', () => {
  test('a plate in the hole of a plate is one of its own', () => {
    const found = formed(form, loopInk([disc(40), disc(28), disc(14)]))!;
    expect(found.shaped.skels).toHaveLength(2);
    expectSolid({ ...made(found.node, 64).mesh }, 1, 2);
  });

  test('of a stroke that crosses itself both lobes', () => {
    const eight = polar(() => 1, 160).map(([x], i): Vec2 => [40 * x, 16 * Math.sin((4 * Math.PI * i) / 160)]);
    const found = formed(form, loopInk([eight], { brush: { ...DEFAULT_BRUSH, radius: 3 } }))!;
    for (const side of [1, -1]) expect(found.field.value(20 * side, 0, 0)).toBeGreaterThan(0);
  });

  test('what is narrower than thick is no thicker than wide', () => {
    const found = formed(form, loopInk([box(80, 6)]))!;
    expect(depth(found, [0, 0, 0], UP, 60)).toBeLessThan(3.1);
  });

  test('the skeleton is made of cycles, as thick as the plate', () => {
    const { skeleton } = formed(form, loopInk(plate(2)))!.shaped;
    const degrees = skeleton.nodes.map((_, i) => skeleton.links.flat().filter((end) => end === i).length);
    expect(degrees.every((degree) => degree === 2)).toBe(true);
    expect(skeleton.nodes.every(({ radius }) => radius === DEFAULT_BRUSH.radius)).toBe(true);
  });

  test('a skeleton that was made gives the same plate when it is read back', () => {
    const ink = loopInk(plate(2));
    const first = formed(form, ink)!;
    const again = formed(form, { ...ink, skeleton: first.shaped.skeleton })!;
    const bits = [0, 1, 2, 3, 4, 5, 6, 7].map((i): readonly [number, number, number] => [
      9 * i - 30,
      3 * i,
      i,
    ]);
    // the place over which it is measured may be another one of the same
    for (const p of bits) {
      const [a, b] = [again.field.value(...p) + THRESHOLD, first.field.value(...p) + THRESHOLD];
      expect(Math.abs(a / b - 1)).toBeLessThan(0.02);
    }
  });

  test('a square by hand: its loops are what is thick, whatever hangs on them', () => {
    const nodes = [...box(60, 40), [0, 0] as const, [90, 0] as const].map((at) => ({ at, radius: 5 }));
    const skeleton: MedialGraph = {
      nodes,
      links: [
        [0, 1],
        [1, 2],
        [2, 3],
        [3, 0],
        [3, 5],
      ],
    };
    const found = formed(form, { ...loopInk([disc(30)]), skeleton })!;
    expect(found.shaped.skels).toHaveLength(1);
    expect(Math.abs(depth(found, [0, 0, 0], UP, 60) / 5 - 1)).toBeLessThan(0.02);
    expect(found.field.value(90, 0, 0)).toBeLessThan(0);
  });

  test('a hole by hand', () => {
    const cycle = (loop: readonly Vec2[], first: number) =>
      loop.map((_, i) => [first + i, first + ((i + 1) % loop.length)] as const);
    const [outer, hole] = [box(80, 80), shifted(box(30, 30), [5, 0])];
    const skeleton = {
      nodes: [...outer, ...hole].map((at) => ({ at, radius: 4 })),
      links: [...cycle(outer, 0), ...cycle(hole, 4)],
    };
    expectSolid(made(formed(form, { ...loopInk([disc(30)]), skeleton })!.node, 64).mesh, 1);
  });

  test('kernels without a field of planes are refused by name', () => {
    for (const kernel of kernels.filter(({ edge }) => !edge)) {
      const make = () => form.width(loopInk([disc(30)]), kernel);
      expect(make).toThrow(FieldError);
      expect(make).toThrow(kernel.name);
    }
  });

  test('nothing can be made of a straight stroke, or of no cycle', () => {
    const straight = lineInk(Array.from({ length: 40 }, (_, i): Vec2 => [i, 0]));
    expect(form.width(straight, kernelNamed('cauchy')!)).toBeNull();
    const skeleton = { nodes: [{ at: [0, 0] as const, radius: 4 }], links: [] };
    expect(formed(form, { ...loopInk([disc(30)]), skeleton })).toBeNull();
  });

  test.each(Array.from({ length: 12 }, (_, seed) => seed))(
    'a random outline, seed %d: finite, and followed',
    (seed) => {
      const next = random(seed);
      const waves = Array.from({ length: 5 }, (_, k) => [k + 2, (next() - 0.5) / (k + 2), next()] as const);
      const size = 10 + 60 * next();
      const loop = polar((t) =>
        waves.reduce((r, [k, a, p]) => r + size * a * Math.cos(2 * Math.PI * (k * t + p)), size),
      );
      for (const kernel of ['cauchy', 'quartic']) {
        const found = formed(form, loopInk([loop]), kernel)!;
        expect(off(found, [loop]).mean).toBeLessThan(0.02);
        const { nodes } = found.shaped.skeleton;
        expect(nodes.every(({ at, radius }) => [...at, radius].every(Number.isFinite))).toBe(true);
      }
    },
  );
});
