/** Random trees of every kind of node, skel, section and shape: what suites over all fields draw from. */
import type { Affine } from '../../src/field/affine.ts';
import type { FieldNode, SkelsNode, Term } from '../../src/field/node.ts';
import type { Warp } from '../../src/field/warp.ts';
import { kernels } from '../../src/kernel/index.ts';
import type { Kernel } from '../../src/kernel/kernel.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { type Shape, shapes } from '../../src/shape/index.ts';
import { random } from '../fixtures/random.ts';

/** in [0, 1) */
export type Uniform = () => number;

const pick = <T>(from: readonly T[], u: Uniform): T => from[Math.floor(from.length * u())]!;
const between = (low: number, high: number, u: Uniform) => Math.fround(low + (high - low) * u());
/** within a few mm of the origin */
const place = (u: Uniform): Vec3 => [between(-4, 4, u), between(-4, 4, u), between(-4, 4, u)];
const colour = (u: Uniform): Vec3 => [u(), u(), u()];

/** A tree of at most `depth` operations on a path, whose surface is within some mm of the origin. */
export function randomTree(u: Uniform, depth: number): FieldNode {
  const inner = () => randomTree(u, depth - 1);
  const choice = depth > 0 ? u() : 1;
  if (choice < 0.45) {
    return {
      type: pick(['union', 'intersection', 'subtraction'], u),
      form: pick(['hard', 'smooth'], u),
      parts: Array.from({ length: 1 + Math.floor(3 * u()) }, inner),
    };
  }
  if (choice < 0.6) {
    return { type: 'blend', a: inner(), b: inner(), a0: between(-1, 1, u), a1: between(0.3, 2, u), a2: 1 };
  }
  if (choice < 0.7) return { type: 'morph', from: inner(), to: inner(), t: u() };
  if (choice < 0.85) return { type: 'affine', matrix: randomMatrix(u), node: inner() };
  return u() < 0.4 ? randomShape(u) : randomBody(u);
}

/** `count` trees of one seed. */
export function randomTrees(seed: number, count: number, depth: number): FieldNode[] {
  const u = random(seed);
  return Array.from({ length: count }, () => randomTree(u, depth));
}

function randomMatrix(u: Uniform): Affine {
  const entry = (diagonal: number) => diagonal + between(-0.4, 0.4, u);
  const mirror = u() < 0.3 ? -1 : 1;
  const [x, y, z] = place(u);
  const row = (i: number) => [0, 1, 2].map((k) => entry(i === k ? (i === 0 ? mirror : 1) : 0));
  return [...row(0), x, ...row(1), y, ...row(2), z] as unknown as Affine;
}

function randomShape(u: Uniform): FieldNode {
  const kind = pick(Object.values(shapes), u);
  // the first example is of some mm; the others are awkward on purpose
  return { type: 'shape', shape: kind.examples[0] as Shape, colour: colour(u) };
}

function randomBody(u: Uniform): SkelsNode {
  const kernel = pick(kernels, u);
  const usual = { s: between(0.3, 1.2, u), R: between(2, 6, u), n: pick([2, 2.5, 3, 4, 5, 6, 7.3], u) };
  const params = Object.fromEntries(kernel.params.map(({ name }) => [name, usual[name]]));
  const skels = Array.from({ length: 1 + Math.floor(4 * u()) }, () => randomTerm(u, kernel));
  return {
    type: 'skels',
    kernel: kernel.name,
    params,
    threshold: between(0.2, 2, u),
    skels,
    colour: colour(u),
  };
}

function randomTerm(u: Uniform, kernel: Kernel): Term {
  const skel = randomSkel(u, kernel);
  const bare = { skel, factor: u() < 0.2 ? between(-1, -0.1, u) : between(0.3, 1.5, u), colour: colour(u) };
  const straight = skel.type === 'point' || skel.type === 'segment' || skel.type === 'polygon';
  return straight && u() < 0.5 ? { ...bare, warp: randomWarp(u) } : bare;
}

/** No polygons of singular kernels: beside a plate, close to its plane, little of them is left in float32. */
const SKELS = ['point', 'segment', 'polyline', 'nurbs', 'polygon'] as const;

function randomSkel(u: Uniform, { homogeneity }: Kernel): Term['skel'] {
  const weight = () => between(0.5, 2, u);
  switch (pick(homogeneity === 0 ? SKELS : SKELS.slice(0, -1), u)) {
    case 'point':
      return { type: 'point', at: place(u), weight: weight() };
    case 'segment':
      return { type: 'segment', a: place(u), b: place(u), weights: [weight(), between(-0.05, 0.1, u)] };
    case 'polygon':
      return {
        type: 'polygon',
        origin: place(u),
        u: [1, u(), 0],
        v: [0, u(), 1],
        loops: [DART, HOLE],
        weight: weight(),
      };
    case 'polyline': {
      const points = [place(u), place(u), place(u)];
      return { type: 'polyline', points, weights: points.map(weight), closed: u() < 0.5 };
    }
    default: {
      const points = Array.from({ length: 5 }, () => place(u));
      return { type: 'nurbs', points, weights: points.map(weight), density: 3 };
    }
  }
}

/** Concave, with a hole. */
const DART = [
  [-3, -2],
  [0, -1],
  [3, -2],
  [0, 3],
] as const;
const HOLE = [
  [-0.5, 0.25],
  [0, 1],
  [0.5, 0.25],
] as const;

function randomWarp(u: Uniform): Warp {
  const radii = Array.from({ length: 24 }, () => between(0.6, 1.6, u));
  const section = pick<Warp['section']>(
    [
      { type: 'round' },
      { type: 'superQuadric', exponent: pick([0.5, 1, 2, 5, 40], u) },
      { type: 'extrusion', exponent: pick([2, 6, 50], u) },
      { type: 'polar', radii },
    ],
    u,
  );
  // no skel above lies along either, but for a point in ten million
  return {
    section,
    scale: [between(0.5, 2, u), between(0.5, 2, u)],
    up: [0.1, 1, 0.3],
    along: [1, 0.2, -0.4],
  };
}
