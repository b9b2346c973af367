/** Meshes of shapes and of their sets against what is known of them: genus, volume, area, box. */
import { describe, expect, test } from 'vitest';
import type { FieldNode } from '../../src/field/node.ts';
import { random } from '../fixtures/random.ts';
import { along, expectKnown, expectSolid, type Known, made, set, shape } from './meshes.ts';
import { box, type Point, placed, sphere } from './trees.ts';

const PI = Math.PI;
const ball = (r: number) => (4 / 3) * PI * r ** 3;
const torus = (ring: number, tube: number) => shape({ type: 'torus', ring, tube });
const cylinder = (radius: number, half: number) => shape({ type: 'cylinder', radius, half });

describe('shapes', () => {
  const known: readonly (readonly [string, FieldNode, number, Known])[] = [
    [
      'an ellipsoid (of revolution: the area is closed)',
      shape({ type: 'ellipsoid', radii: [3, 6, 3] }),
      48,
      {
        volume: (4 / 3) * PI * 3 * 3 * 6,
        area: 2 * PI * 9 * (1 + (2 / Math.sqrt(0.75)) * Math.asin(Math.sqrt(0.75))),
        half: [3, 6, 3],
        curvature: 6 / 9,
        creases: 0,
      },
    ],
    [
      'a torus',
      torus(10, 3),
      64,
      {
        genus: 1,
        volume: 2 * PI * PI * 10 * 9,
        area: 4 * PI * PI * 10 * 3,
        half: [13, 3, 13],
        curvature: 1 / 3,
        creases: 0,
      },
    ],
    [
      'a cylinder',
      cylinder(4, 6),
      48,
      {
        volume: PI * 16 * 12,
        area: 2 * PI * 4 * 12 + 2 * PI * 16,
        half: [4, 6, 4],
        curvature: 1 / 4,
        creases: 4 * PI * 4,
      },
    ],
    [
      'a rounded box',
      shape({ type: 'roundedBox', half: [5, 4, 3], radius: 1 }),
      64,
      {
        // of the box within, the plates on its faces, quarter rods on its edges, a ball in eight pieces
        volume: 8 * 4 * 3 * 2 + 8 * (4 * 3 + 4 * 2 + 3 * 2) + 2 * PI * (4 + 3 + 2) + ball(1),
        area: 8 * (4 * 3 + 4 * 2 + 3 * 2) + 4 * PI * (4 + 3 + 2) + 4 * PI,
        half: [5, 4, 3],
        curvature: 1,
        creases: 0,
      },
    ],
  ];

  test.each(known)('%s', (_, node, resolution, what) => {
    expectKnown(made(node, resolution), what);
  });

  test.each(known)('%s, standing anywhere', (_, node, resolution, { half: _half, ...what }) => {
    expectKnown(made(along([1, 2, 3], node), resolution), what);
  });
});

describe.each(['hard', 'smooth'] as const)('%s sets', (form) => {
  test('a lens of two spheres', () => {
    const [r, d] = [5, 4];
    const lens = set('intersection', form, placed(sphere(r), -d / 2, 0, 0), placed(sphere(r), d / 2, 0, 0));
    expectKnown(made(lens, 48), {
      volume: (PI * (4 * r + d) * (2 * r - d) ** 2) / 12,
      area: 4 * PI * r * (r - d / 2),
      half: [r - d / 2, Math.sqrt(r * r - (d * d) / 4), Math.sqrt(r * r - (d * d) / 4)],
      curvature: 1 / r,
      creases: 2 * PI * Math.sqrt(r * r - (d * d) / 4),
    });
  });

  test('two spheres as one', () => {
    const [r, d] = [5, 6];
    const pair = set('union', form, placed(sphere(r), -d / 2, 0, 0), placed(sphere(r), d / 2, 0, 0));
    expectKnown(made(pair, 64), {
      volume: 2 * ball(r) - (PI * (4 * r + d) * (2 * r - d) ** 2) / 12,
      area: 8 * PI * r * r - 4 * PI * r * (r - d / 2),
      half: [r + d / 2, r, r],
      curvature: 1 / r,
      creases: 2 * PI * Math.sqrt(r * r - (d * d) / 4),
    });
  });

  test('a napkin ring: its volume is that of a ball as high', () => {
    const [r, a] = [6, 3];
    const high = Math.sqrt(r * r - a * a);
    expectKnown(made(set('subtraction', form, sphere(r), cylinder(a, 2 * r)), 64), {
      genus: 1,
      volume: ball(high),
      area: 4 * PI * (r + a) * high,
      half: [r, high, r],
      curvature: 1 / a,
      creases: 4 * PI * a,
    });
  });

  test('a pipe', () => {
    expectKnown(made(set('subtraction', form, cylinder(5, 8), cylinder(3, 10)), 64), {
      genus: 1,
      volume: PI * (25 - 9) * 16,
      area: 2 * PI * (5 + 3) * 16 + 2 * PI * (25 - 9),
      half: [5, 8, 5],
      curvature: 1 / 3,
      creases: 4 * PI * (5 + 3),
    });
  });

  test('Steinmetz’ solid: two crossed cylinders', () => {
    const r = 4;
    const crossed = set('intersection', form, cylinder(r, 2 * r), along([1, 0, 0], cylinder(r, 2 * r)));
    expectKnown(made(crossed, 56), {
      volume: (16 / 3) * r ** 3,
      area: 16 * r * r,
      half: [r, r, r],
      curvature: 1 / r,
      // two ellipses with half axes r and √2 r, by their circles' mean at most
      creases: 2 * 2 * PI * r * Math.sqrt(1.5),
    });
  });

  test('a cube with three tunnels that meet has genus 5', () => {
    const [l, a] = [5, 2];
    const tunnels = [box(2 * l, a, a), box(a, 2 * l, a), box(a, a, 2 * l)];
    expectKnown(made(set('subtraction', form, box(l, l, l), ...tunnels), 60), {
      genus: 5,
      volume: (2 * l) ** 3 - 3 * (2 * a) ** 2 * 2 * l + 2 * (2 * a) ** 3,
      area: 6 * ((2 * l) ** 2 - (2 * a) ** 2) + 6 * 4 * (2 * a) * (l - a),
      half: [l, l, l],
      curvature: 0,
      creases: 12 * 2 * l + 24 * 2 * a + 24 * (l - a),
    });
  });

  test('two tori, linked or as one', () => {
    const upright = along([1, 0, 0], torus(8, 2));
    const linked = made(set('union', form, torus(8, 2), placed(upright, 0, 0, 8)), 64);
    expectSolid(linked.mesh, 2, 2);
    const eight = made(set('union', form, torus(8, 2), placed(torus(8, 2), 18, 0, 0)), 72);
    expectSolid(eight.mesh, 2, 1);
  });
});

test('a plate with 100 holes has genus 100', () => {
  const holes = Array.from({ length: 100 }, (_, i) =>
    placed(cylinder(3, 4), 10 * (i % 10) - 45, 0, 10 * Math.floor(i / 10) - 45),
  );
  expectKnown(made(set('subtraction', 'hard', box(50, 2, 50), ...holes), 80), {
    genus: 100,
    volume: 4 * (100 * 100 - 100 * PI * 9),
    area: 2 * (100 * 100 - 100 * PI * 9) + 4 * 400 + 100 * 6 * PI * 4,
    half: [50, 2, 50],
    curvature: 1 / 3,
    creases: 200 * 6 * PI + 8 * 100 + 4 * 4,
  });
});

describe('what is hardly thicker than a cell', () => {
  test('a plate of 1.1 cells along the lattice stays whole', () => {
    const { mesh, lattice } = made(box(10, 0.55 * (20 / 40), 10), 40);
    expect(lattice.step).toBeCloseTo(0.5, 1);
    expectSolid(mesh);
  });

  test('a plate of 1.9 cells lying askew stays whole', () => {
    // √3 cells are enough for all neighbours along the axes to hang together
    const { mesh, lattice } = made(along([1, 2, 3], box(10, 0.6, 10)), 40);
    expect(1.2).toBeGreaterThan(Math.sqrt(3) * lattice.step);
    expectSolid(mesh);
  });

  test('needles in 20 directions stay whole (seed 91)', () => {
    const next = random(91);
    for (let i = 0; i < 20; i++) {
      const to: Point = [next() + 0.01, next() - 0.5, next() - 0.5];
      const node = (radius: number) => along(to, shape({ type: 'capsule', radius, half: 20 }));
      const { step } = made(node(0.5), 40).lattice;
      // an axis passes every cell at most half a diagonal from a node
      const { mesh, lattice } = made(node(0.93 * step), 40);
      expect(0.93).toBeGreaterThan((Math.sqrt(0.75) * lattice.step) / step);
      expectSolid(mesh);
    }
  });
});
