/** Trees and what the tests ask of any field. */
import type { Affine } from '../../src/field/affine.ts';
import type { FieldNode, SkelsNode, Term } from '../../src/field/node.ts';
import type { Field } from '../../src/shape/shape.ts';
import { random } from '../fixtures/random.ts';

export type Point = readonly [x: number, y: number, z: number];

export const sphere = (radius: number): FieldNode => ({ type: 'shape', shape: { type: 'sphere', radius } });
export const box = (x: number, y: number, z: number): FieldNode => ({
  type: 'shape',
  shape: { type: 'box', half: [x, y, z] },
});
export const placed = (node: FieldNode, x: number, y: number, z: number): FieldNode => ({
  type: 'affine',
  matrix: [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z],
  node,
});

/** A third of a turn about (1, 1, 1), then a move. */
export const RIGID: Affine = [0, 0, 1, 3, 1, 0, 0, -2, 0, 1, 0, 5];
/** Stretch, shear and a mirror. */
export const SKEW: Affine = [2, 0.5, 0, 1, 0, 1.5, 0.3, 0, 0, 0, -1, 2];

/** A bone: a tapering segment, a point at its end, a plate beside it. */
export const BONE: readonly Term[] = [
  { skel: { type: 'segment', a: [-4, 0, 0], b: [5, 1, 2], weights: [2, 0.2] } },
  { skel: { type: 'point', at: [5, 1, 2], weight: 3 }, colour: [1, 0, 0] },
  {
    skel: {
      type: 'polygon',
      origin: [0, -2, 0],
      u: [1, 0, 0],
      v: [0, 0, 1],
      loops: [
        [
          [-2, -1],
          [3, -1],
          [2, 2],
        ],
      ],
      weight: 0.7,
    },
    factor: 0.8,
    colour: [0, 0, 1],
  },
];

export const body = (skels: readonly Term[] = BONE, threshold = 1): SkelsNode => ({
  type: 'skels',
  kernel: 'cauchy',
  params: { s: 0.6 },
  threshold,
  skels,
  colour: [0, 1, 0],
});

/** Uniform in a cube about the origin. */
export function points(count: number, half: number, seed: number): Point[] {
  const next = random(seed);
  const one = () => half * (2 * next() - 1);
  return Array.from({ length: count }, () => [one(), one(), one()]);
}

const out = new Float64Array(4);

/** Value and gradient. */
export function evaluated(field: Field, p: Point): readonly [number, number, number, number] {
  field.evaluate(...p, out);
  return [out[0]!, out[1]!, out[2]!, out[3]!];
}

/**
 * The largest difference between the gradient and fourth-order differences, relative to 1 + its length; NaN when value() and
 * evaluate() differ by more than rounding. Points whose differences depend on the step (an edge is near) are left out; at
 * most a fifth may be.
 */
export function gradientError(field: Field, at: readonly Point[], h = 1e-3): number {
  let left = 0;
  const errors = at.map((p) => {
    const [value, ...gradient] = evaluated(field, p);
    if (Math.abs(value - field.value(...p)) > 1e-13 * (1 + Math.abs(value))) return NaN;
    const scale = 1 + Math.max(...gradient.map(Math.abs));
    const [fine, coarse] = [differences(field, p, h), differences(field, p, 2 * h)];
    const away = (a: readonly number[], b: readonly number[]) =>
      Math.max(...a.map((x, i) => Math.abs(x - b[i]!))) / scale;
    if (away(fine, coarse) > 1e-6) {
      left++;
      return 0;
    }
    return away(fine, gradient);
  });
  return left > 0.2 * at.length ? NaN : Math.max(...errors);
}

function differences(field: Field, p: Point, h: number): number[] {
  return [0, 1, 2].map((axis) => {
    const at = (k: number) => {
      const [x, y, z] = p.map((c, i) => (i === axis ? c + k * h : c)) as [number, number, number];
      return field.value(x, y, z);
    };
    return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
  });
}

/** Points inside the field that its box does not hold, of `count` in a cube. */
export function lostPoints(field: Field, half: number, count: number, seed: number): Point[] {
  return points(count, half, seed).filter((p) => {
    if (!field.box || field.value(...p) <= 0) return false;
    const { min, max } = field.box;
    return p.some((x, i) => x < min[i]! || x > max[i]!);
  });
}
