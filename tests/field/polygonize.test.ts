/** The dense polygonizer against what is known without it: volumes, areas, genus, radii by bisection. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { latticeAround, latticeOver, RESOLUTION } from '../../src/field/lattice.ts';
import { type Near, Tally } from '../../src/field/near.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { PAGE, polygonize } from '../../src/field/polygonize.ts';
import { topology } from '../../src/mesh/check.ts';
import { area, bounds, volume } from '../../src/mesh/measure.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { Shape } from '../../src/shape/index.ts';
import { body, box, placed, SKEW, sphere } from './trees.ts';

const shape = (of: Shape): FieldNode => ({ type: 'shape', shape: of });
const made = (node: FieldNode, resolution: number) => polygonize(bindField(node), resolution);

function expectSolid(mesh: Mesh, genus = 0, components = 1): void {
  expect(topology(mesh)).toMatchObject({ watertight: true, genus, components, degenerate: 0, finite: true });
  expect(volume(mesh)).toBeGreaterThan(0);
}

/** Each vertex' distance from the surface, by the field's own slope, at most this many cells. */
function expectOnSurface(node: FieldNode, resolution: number, cells = 2e-3): void {
  const field = bindField(node);
  const { mesh, lattice } = polygonize(field, resolution);
  const out = new Float64Array(4);
  let most = 0;
  for (let i = 0; i < mesh.positions.length; i += 3) {
    field.evaluate(mesh.positions[i]!, mesh.positions[i + 1]!, mesh.positions[i + 2]!, out);
    most = Math.max(most, Math.abs(out[0]!) / Math.hypot(out[1]!, out[2]!, out[3]!));
  }
  expect(most).toBeLessThan(cells * lattice.step);
}

describe('solids of known size', () => {
  test('a sphere: volume and area, and the error falls as 1/n²', () => {
    const errors = [16, 32, 64].map((resolution) => {
      const { mesh } = made(sphere(10), resolution);
      expectSolid(mesh);
      const exact = [(4 / 3) * Math.PI * 1000, 400 * Math.PI] as const;
      return [1 - volume(mesh) / exact[0], 1 - area(mesh) / exact[1]] as const;
    });
    for (const of of [0, 1] as const) {
      expect(errors[2]![of]).toBeGreaterThan(0);
      expect(errors[2]![of]).toBeLessThan(2e-3);
      expect(errors[0]![of] / errors[2]![of]).toBeGreaterThan(12);
    }
  });

  test('a torus has one hole', () => {
    const { mesh } = made(shape({ type: 'torus', ring: 10, tube: 3 }), 56);
    expectSolid(mesh, 1);
    expect(volume(mesh) / (2 * Math.PI * Math.PI * 10 * 9)).toBeCloseTo(1, 2);
  });

  test('a capsule', () => {
    const { mesh } = made(shape({ type: 'capsule', radius: 4, half: 8 }), 48);
    expectSolid(mesh);
    expect(volume(mesh) / (Math.PI * 16 * 16 + (4 / 3) * Math.PI * 64)).toBeCloseTo(1, 2);
    expect(area(mesh) / (2 * Math.PI * 4 * 16 + 4 * Math.PI * 16)).toBeCloseTo(1, 2);
  });

  test('a box keeps its faces; corners are cut by at most a cell', () => {
    const { mesh, lattice } = made(box(3, 5, 2), 32);
    expectSolid(mesh);
    const { min, max } = bounds(mesh);
    expect(max.map((x, i) => x - min[i]!)).toEqual([6, 10, 4].map((size) => expect.closeTo(size, 3)));
    expect(240 - volume(mesh)).toBeGreaterThan(0);
    expect(240 - volume(mesh)).toBeLessThan(4 * (6 + 10 + 4) * lattice.step ** 2);
  });

  test('two bodies apart are two components; one inside out of another is a cavity', () => {
    const pair: FieldNode = { type: 'union', form: 'hard', parts: [sphere(3), placed(sphere(2), 9, 0, 0)] };
    expectSolid(made(pair, 40).mesh, 0, 2);
    const hollow: FieldNode = { type: 'subtraction', form: 'hard', parts: [sphere(5), sphere(3)] };
    const { mesh } = made(hollow, 40);
    expectSolid(mesh, 0, 2);
    expect(volume(mesh) / ((4 / 3) * Math.PI * (125 - 27))).toBeCloseTo(1, 1);
  });
});

describe('convolution bodies', () => {
  const s = 0.3;
  const segment: FieldNode = {
    type: 'skels',
    kernel: 'cauchy',
    params: { s },
    threshold: 0.4,
    skels: [{ skel: { type: 'segment', a: [0, -20, 0], b: [0, 20, 0], weights: [1.5] } }],
  };

  test('the radius of a Cauchy segment, by bisection of its integral', () => {
    // ∫ (1 + s²(r² + t²))⁻² dt over the segment, as seen from the middle, by Simpson's rule
    const integral = (r: number) => {
      const n = 4000;
      let sum = 0;
      for (let i = 0; i <= n; i++) {
        const t = -20 + (40 * i) / n;
        const weight = i === 0 || i === n ? 1 : i % 2 === 1 ? 4 : 2;
        sum += weight / (1 + s * s * (r * r + t * t)) ** 2;
      }
      return (1.5 * sum * 40) / n / 3;
    };
    let [low, high] = [0.1, 20];
    for (let i = 0; i < 60; i++) {
      const middle = (low + high) / 2;
      if (integral(middle) > 0.4) low = middle;
      else high = middle;
    }
    const { mesh, lattice } = made(segment, 48);
    expectSolid(mesh);
    const radii: number[] = [];
    for (let i = 0; i < mesh.positions.length; i += 3) {
      if (Math.abs(mesh.positions[i + 1]!) < 0.6 * lattice.step)
        radii.push(Math.hypot(mesh.positions[i]!, mesh.positions[i + 2]!));
    }
    expect(radii.length).toBeGreaterThan(8);
    for (const radius of radii) expect(Math.abs(radius - low)).toBeLessThan(2e-3 * lattice.step);
  });

  test('normals are unit and those of differences', () => {
    const node: FieldNode = { type: 'affine', matrix: SKEW, node: body() };
    const field = bindField(node);
    const { mesh } = polygonize(field, 24);
    const h = 1e-4;
    for (let i = 0; i < mesh.positions.length; i += 33) {
      const at = [0, 1, 2].map((k) => mesh.positions[i + k]!) as [number, number, number];
      const slope = [0, 1, 2].map((axis) => {
        const on = (d: number) => field.value(...(at.map((x, k) => (k === axis ? x + d : x)) as typeof at));
        return (on(-h) - on(h)) / (2 * h);
      });
      const length = Math.hypot(...slope);
      const away = slope.map((x, k) => x / length - mesh.normals[i + k]!);
      // of the place the last step started from, up to a hundredth of a cell away, and without what far skels' polynomials miss
      expect(Math.hypot(...away)).toBeLessThan(3e-3);
      expect(Math.hypot(...mesh.normals.subarray(i, i + 3))).toBeCloseTo(1, 6);
    }
  });

  test.each(['cauchy', 'inverse', 'inverseQuintic', 'quartic'])(
    '%s: on the surface, watertight',
    (kernel) => {
      const params = kernel === 'cauchy' ? { s: 0.3 } : kernel === 'quartic' ? { R: 12 } : {};
      const node: FieldNode = { ...segment, kernel, params, threshold: 0.05 };
      expectSolid(made(node, 24).mesh);
      expectOnSurface(node, 24);
    },
  );

  test('colours are the field’s, what is far having those of the middle of its brick', () => {
    const { mesh } = made(body(), 24);
    const paint = new Float64Array(3);
    const field = bindField(body());
    for (let i = 0; i < mesh.positions.length; i += 99) {
      field.colour(mesh.positions[i]!, mesh.positions[i + 1]!, mesh.positions[i + 2]!, paint);
      for (let k = 0; k < 3; k++) expect(Math.abs(mesh.colours[i + k]! - paint[k]!)).toBeLessThan(0.01);
    }
  });
});

describe('boxes and lattices', () => {
  test('a box that is too small grows, one that is too large is fitted', () => {
    const field = bindField(sphere(10));
    const whole = polygonize(field, 32).mesh;
    for (const half of [4, 500]) {
      const { mesh, lattice } = polygonize(field, 32, {
        min: [-half, -half, -half],
        max: [half, half, half],
      });
      expectSolid(mesh);
      expect(volume(mesh) / volume(whole)).toBeCloseTo(1, 2);
      expect(lattice.step).toBeLessThan(1.5);
    }
  });

  test.each([16, 17, 72])('what has no end is cut off at the page, and closed there: %i cells', (cells) => {
    const { mesh, lattice } = made(shape({ type: 'halfSpace', normal: [0, 1, 0], offset: 0 }), cells);
    expectSolid(mesh);
    const { min, max } = bounds(mesh);
    expect(min).toEqual([-PAGE, -PAGE, -PAGE].map((x) => expect.closeTo(x, 4)));
    expect(max[1]).toBeCloseTo(0, 4);
    // no node may be in the middle, so it is a quarter of a cell more on that side
    for (const axis of [0, 2] as const) {
      expect(max[axis]).toBeGreaterThanOrEqual(PAGE);
      expect(max[axis]).toBeLessThan(PAGE + 0.5 * lattice.step);
    }
    expect(lattice.step).toBeLessThanOrEqual((2 * PAGE) / cells);
  });

  test('an empty field is an empty mesh', () => {
    const thin = body([{ skel: { type: 'point', at: [0, 0, 0], weight: 1e-6 } }]);
    const { mesh } = made(thin, 32);
    expect(mesh.indices.length).toBe(0);
    expect(topology(mesh)).toMatchObject({ watertight: true, components: 0 });
  });

  test('what is no number counts as outside', () => {
    const field = bindField(sphere(10));
    const holed = (of: Near): Near => {
      const near: Near = {
        low: of.low,
        high: of.high,
        error: of.error,
        mostMissed: of.mostMissed,
        errorAt: (x, y, z) => of.errorAt(x, y, z),
        asked: of.asked,
        branches: 1,
        node: 0,
        steep: 1,
        effect: () => Infinity,
        plain: of.plain,
        value: (x, y, z) => (x > 4 ? NaN : of.value(x, y, z)),
        evaluate: (...at) => of.evaluate(...at),
        colour: (...at) => of.colour(...at),
        branch: () => 0,
        holds: () => true,
        onBranch: (...at) => of.onBranch(...at),
        look: (...from) => of.look(...from),
        clear: () => of.clear(),
        reached: (clear) => of.reached(clear),
        around: () => of.around(),
        ahead: (...to) => of.ahead(...to),
        within: (...cube) => holed(of.within(...cube)),
        corners: (nodes, out) => nodes.exact(near, out),
        eachLeaf: (visit) => of.eachLeaf(visit),
        eachDropped: (way, visit) => of.eachDropped(way, visit),
      };
      return near;
    };
    const near = field.near(new Tally());
    const { mesh } = polygonize({ ...field, near: () => holed(near) }, 24, field.box);
    expectSolid(mesh);
  });

  test('no lattice is finer than allowed, and none is without end', () => {
    expect(latticeAround({ min: [0, 0, 0], max: [1, 1, 1] }, 1e9).step).toBeCloseTo(1 / RESOLUTION.max);
    expect(latticeAround({ min: [0, 0, 0], max: [1, 1, 1] }, NaN).step).toBeGreaterThan(0);
    expect(latticeOver(PAGE, 1e9).counts[0]).toBeLessThan(RESOLUTION.max + 8);
    expect(() => latticeAround({ min: [0, 0, 0], max: [1, Infinity, 1] }, 8)).toThrow(/bounded/);
    expect(() => latticeAround({ min: [NaN, 0, 0], max: [1, 1, 1] }, 8)).toThrow(/bounded/);
  });

  test.each([1e-6, 1e6])('the same body %f times as large', (scale) => {
    const { mesh } = made(sphere(10 * scale), 16);
    expectSolid(mesh);
    expect(volume(mesh) / scale ** 3 / volume(made(sphere(10), 16).mesh)).toBeCloseTo(1, 4);
  });
});
