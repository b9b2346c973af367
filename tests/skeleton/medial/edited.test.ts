/** Skeletons that were moved by hand: the surface follows their circles, and nothing is not a number. */
import { describe, expect, it } from 'vitest';
import { kernelNamed } from '../../../src/kernel/index.ts';
import { bindSkel } from '../../../src/skeleton/index.ts';
import type { MedialGraph } from '../../../src/skeleton/medial/axis.ts';
import { envelopeOf, skeletonSkels } from '../../../src/skeleton/medial/edited.ts';
import { silhouetteOf } from '../../../src/skeleton/medial/silhouette.ts';
import { widthOf } from '../../../src/skeleton/medial/width.ts';
import { random } from '../../fixtures/random.ts';
import { SHAPES } from '../../fixtures/silhouettes.ts';

const KERNELS = ['cauchy', 'quartic', 'gaussian', 'inverse', 'inverseCubic'].map(
  (name) => kernelNamed(name)!,
);
const usual = (kernel: (typeof KERNELS)[number]) =>
  Object.fromEntries(kernel.params.map(({ name, default: value }) => [name, value]));

function solved(graph: MedialGraph, kernel = KERNELS[0]!) {
  const params = widthOf([graph], kernel, usual(kernel));
  const found = skeletonSkels(graph, kernel, params, 1)!;
  const fields = found.skels.map((skel) => bindSkel(skel, kernel, params));
  return { ...found, field: (x: number, y: number) => fields.reduce((sum, f) => sum + f.value(x, y, 0), 0) };
}

/** mm from the middle to where the field comes down to 1. */
function radiusAlong(
  field: (x: number, y: number) => number,
  [x, y]: readonly number[],
  dx: number,
  dy: number,
) {
  let [near, far] = [0, 1];
  while (field(x! + far * dx, y! + far * dy) > 1) far *= 2;
  for (let i = 0; i < 40; i++) {
    const middle = (near + far) / 2;
    if (field(x! + middle * dx, y! + middle * dy) > 1) near = middle;
    else far = middle;
  }
  return near;
}

const bar: MedialGraph = {
  nodes: [
    { at: [0, 0], radius: 5 },
    { at: [20, 0], radius: 8 },
  ],
  links: [[0, 1]],
};

describe('envelopeOf', () => {
  it('is of the circles and their cones, and in none of them', () => {
    const places = envelopeOf(bar);
    expect(places.length).toBeGreaterThan(30);
    for (const [x, y] of places) {
      const gaps = Array.from({ length: 401 }, (_, i) => {
        const t = i / 400;
        return Math.hypot(x - 20 * t, y) - (5 + 3 * t);
      });
      expect(Math.min(...gaps)).toBeGreaterThan(-0.01);
      expect(Math.min(...gaps)).toBeLessThan(0.01);
    }
  });
});

describe('skeletonSkels', () => {
  it.each(KERNELS)(
    'two circles and their cone are followed within a tenth of the radius ($name)',
    (kernel) => {
      const { field, graph } = solved(bar, kernel);
      expect(graph).toBe(bar);
      for (const { at, radius } of bar.nodes) {
        expect(Math.abs(radiusAlong(field, at, 0, 1) / radius - 1)).toBeLessThan(0.1);
      }
      expect(Math.abs(radiusAlong(field, [0, 0], -1, 0) / 5 - 1)).toBeLessThan(0.1);
    },
  );

  it('one circle is a ball', () => {
    const { skels, field } = solved({ nodes: [{ at: [3, 4], radius: 7 }], links: [] });
    expect(skels.map(({ type }) => type)).toEqual(['point']);
    expect(radiusAlong(field, [3, 4], 1, 0)).toBeCloseTo(7, 3);
  });

  it('a star one of whose arms was moved and made thicker follows it', () => {
    const kernel = KERNELS[0]!;
    const { graph, params } = silhouetteOf(SHAPES.star!, kernel, usual(kernel), 1)!;
    const far = graph.nodes.reduce((best, { at }, i) => (at[0] > graph.nodes[best]!.at[0] ? i : best), 0);
    const nodes = graph.nodes.map((node, i) =>
      i === far ? { at: [node.at[0] + 12, node.at[1] + 3] as const, radius: 1.5 * node.radius } : node,
    );
    const edited = { nodes, links: graph.links };
    const { skels } = skeletonSkels(edited, kernel, params, 1)!;
    const fields = skels.map((skel) => bindSkel(skel, kernel, params));
    const field = (x: number, y: number) => fields.reduce((sum, f) => sum + f.value(x, y, 0), 0);
    const { at, radius } = nodes[far]!;
    expect(Math.abs(radiusAlong(field, at, 1, 0) / radius - 1)).toBeLessThan(0.2);
  });

  it('circles that were put together, links to oneself and twice, and what is no number leave numbers', () => {
    const at = [1, 2] as const;
    const odd: MedialGraph[] = [
      {
        nodes: [
          { at, radius: 2 },
          { at, radius: 3 },
        ],
        links: [[0, 1]],
      },
      {
        nodes: [
          { at, radius: 2 },
          { at, radius: 2 },
        ],
        links: [],
      },
      {
        nodes: [
          { at, radius: 2 },
          { at: [1, 2 + 1e-14], radius: 2 },
          { at: [9, 9], radius: 1 },
        ],
        links: [
          [0, 1],
          [1, 2],
        ],
      },
      {
        nodes: [
          { at, radius: 2 },
          { at: [9, 2], radius: 0 },
        ],
        links: [
          [0, 1],
          [1, 0],
          [0, 0],
          [0, 5],
        ],
      },
      {
        nodes: [
          { at, radius: Number.NaN },
          { at: [9, 2], radius: 1 },
        ],
        links: [[0, 1]],
      },
      {
        nodes: [
          { at, radius: 1e-6 },
          { at: [900, 2], radius: 40 },
        ],
        links: [[0, 1]],
      },
    ];
    for (const kernel of KERNELS) for (const graph of odd) expectNumbers(solved(graph, kernel));
  });

  it('is none where nothing is left', () => {
    const kernel = KERNELS[0]!;
    expect(skeletonSkels({ nodes: [], links: [] }, kernel, usual(kernel), 1)).toBeNull();
    expect(
      skeletonSkels({ nodes: [{ at: [0, 0], radius: 0 }], links: [] }, kernel, usual(kernel), 1),
    ).toBeNull();
  });

  it.each([1, 2, 3])('any graph gives numbers (20 of them, seed %i)', (seed) => {
    const next = random(seed);
    for (let k = 0; k < 20; k++) {
      const count = 1 + Math.floor(6 * next());
      const nodes = Array.from({ length: count }, () => ({
        at: [40 * next(), 40 * next()] as const,
        radius: 8 * next() * next(),
      }));
      const links = Array.from(
        { length: count },
        () => [Math.floor(count * next()), Math.floor(count * next())] as const,
      );
      expectNumbers(solved({ nodes, links }, KERNELS[k % KERNELS.length]));
    }
  });
});

function expectNumbers({ skels, relative, residual, ratio }: ReturnType<typeof solved>): void {
  const numbers = skels.flatMap((skel) => Object.values(skel).flat()).filter((v) => typeof v !== 'string');
  for (const number of [...numbers, ...relative, residual, ratio]) expect(Number.isFinite(number)).toBe(true);
  expect(skels.length).toBeGreaterThan(0);
}
