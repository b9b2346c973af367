/** Trees of all that there is, drawn by lot: every kernel, skel, curve, section, shape and operation, sizes near `unit` mm. */
import type { Affine } from '../../src/field/affine.ts';
import type { AnySkel } from '../../src/field/expand.ts';
import type { Colour, FieldNode, SkelsNode, Term } from '../../src/field/node.ts';
import type { Warp } from '../../src/field/warp.ts';
import { kernels } from '../../src/kernel/index.ts';
import type { ParamSpec } from '../../src/kernel/kernel.ts';
import { cos, sin, TAU } from '../../src/math/trig.ts';
import type { Vec2, Vec3 } from '../../src/math/vec.ts';
import { type Shape, shapes } from '../../src/shape/index.ts';
import { random } from '../fixtures/random.ts';

export class Lot {
  readonly #next: () => number;
  readonly unit: number;

  constructor(seed: number, unit = 1) {
    this.#next = random(seed);
    this.unit = unit;
  }

  between(low: number, high: number): number {
    return low + (high - low) * this.#next();
  }
  one<T>(list: readonly T[]): T {
    return list[Math.floor(this.#next() * list.length)]!;
  }
  many<T>(count: number, make: (i: number) => T): T[] {
    return Array.from({ length: count }, (_, i) => make(i));
  }
  is(chance: number): boolean {
    return this.#next() < chance;
  }
  length(): number {
    return this.unit * this.between(0.5, 2);
  }
  direction(): Vec3 {
    return [this.between(-1, 1), this.between(-1, 1), this.between(-1, 1)];
  }
  place(): Vec3 {
    const [x, y, z] = this.direction();
    return [3 * this.unit * x, 3 * this.unit * y, 3 * this.unit * z];
  }
  colour(): Colour {
    return [this.between(0, 1), this.between(0, 1), this.between(0, 1)];
  }
}

export function randomTree(lot: Lot, depth = 3): FieldNode {
  if (depth === 0) return lot.is(0.5) ? randomBody(lot) : randomShape(lot);
  const child = () => randomTree(lot, depth - 1 - (lot.is(0.3) ? Math.min(depth - 1, 1) : 0));
  const size = lot.unit;
  switch (lot.one(['union', 'intersection', 'subtraction', 'blend', 'morph', 'affine', 'leaf'] as const)) {
    case 'blend':
      return {
        type: 'blend',
        a: child(),
        b: child(),
        a0: size * lot.between(-0.3, 0.3),
        a1: size * lot.between(0.3, 1),
        a2: size * lot.between(0.3, 1),
      };
    case 'morph':
      return { type: 'morph', from: child(), to: child(), t: lot.one([0, 0.3, 0.8, 1]) };
    case 'affine':
      return { type: 'affine', matrix: randomMatrix(lot), node: child() };
    case 'leaf':
      return randomTree(lot, 0);
    default: {
      const type = lot.one(['union', 'intersection', 'subtraction'] as const);
      const parts = lot.many(lot.one([1, 2, 3]), child);
      return { type, form: lot.one(['hard', 'smooth'] as const), parts };
    }
  }
}

/** Any stretch, shear or mirror that does not flatten. */
function randomMatrix(lot: Lot): Affine {
  const [x, y, z] = lot.place();
  const side = () => (lot.is(0.5) ? 1 : -1) * lot.between(0.6, 1.6);
  const off = () => lot.between(-0.4, 0.4);
  return [side(), off(), off(), x, off(), side(), off(), y, off(), off(), side(), z];
}

function randomShape(lot: Lot): FieldNode {
  const kind = lot.one(Object.values(shapes));
  // the first example of each is some 10 mm large
  const shape = kind.examples[0] as Shape;
  const k = lot.unit * lot.between(0.1, 0.3);
  const matrix: Affine = [k, 0, 0, lot.place()[0], 0, k, 0, 0, 0, 0, k, 0];
  return { type: 'affine', matrix, node: { type: 'shape', shape, colour: lot.colour() } };
}

export function randomBody(lot: Lot): SkelsNode {
  const kernel = lot.one(kernels);
  const value = ({ name }: ParamSpec) =>
    name === 's'
      ? lot.between(0.4, 1.2) / lot.unit
      : name === 'R'
        ? lot.unit * lot.between(2.5, 5)
        : lot.one([1.5, 2, 3, 4, 4.5, 6, 8]);
  const params = Object.fromEntries(kernel.params.map((spec) => [spec.name, value(spec)]));
  // a skel of `dimension` has a field near 1 in any unit
  const mass = (dimension: number) => lot.unit ** -(dimension + kernel.homogeneity);
  const skels = lot.many(lot.one([1, 2, 4]), () => randomTerm(lot, mass));
  return { type: 'skels', kernel: kernel.name, params, threshold: lot.between(0.2, 2), skels };
}

type Mass = (dimension: number) => number;

function randomTerm(lot: Lot, mass: Mass): Term {
  const skel = randomSkel(lot, mass);
  const factor = lot.one([1, 1, 0.7, -0.5, 0]);
  const colour = lot.is(0.5) ? { colour: lot.colour() } : {};
  return { skel, factor, ...colour, ...(lot.is(0.4) ? { warp: randomWarp(lot) } : {}) };
}

function randomWarp(lot: Lot): Warp {
  const turn = lot.between(0, 6);
  const flower = lot.many(24, (i) => 1 + 0.3 * sin((i * TAU) / 6 + turn));
  const section = lot.one<Warp['section']>([
    { type: 'round' },
    { type: 'superQuadric', exponent: lot.one([0.5, 1, 2.5, 8, 100]) },
    { type: 'extrusion', exponent: lot.one([2, 5, 20]) },
    { type: 'polar', radii: flower },
  ]);
  // the extrusion's own thickness is 1 mm, its exponents turn others into powers: left at 2 for other units
  const safe = section.type === 'extrusion' && lot.unit !== 1 ? { ...section, exponent: 2 } : section;
  const scale = [lot.between(0.5, 2), lot.between(0.5, 2)] as const;
  return { section: safe, scale, up: lot.direction(), along: lot.direction() };
}

const FIDELITY = { fieldError: 1, distance: 1.5 } as const;

function randomSkel(lot: Lot, mass: Mass): AnySkel {
  const points = (count: number) => lot.many(count, () => lot.place());
  const radii = (count: number) => lot.many(count, () => lot.length());
  const weights = (count: number) => lot.many(count, () => lot.between(0.2, 2) * mass(1));
  const fidelity = { ...FIDELITY, distance: FIDELITY.distance * lot.unit };
  switch (
    lot.one([
      'point',
      'ball',
      'segment',
      'cone',
      'polygon',
      'polyline',
      'nurbs',
      'profile',
      'arc',
      'quadratic',
    ] as const)
  ) {
    case 'point':
      return { type: 'point', at: lot.place(), weight: lot.between(-1, 3) * mass(0) };
    case 'ball':
      return { type: 'point', at: lot.place(), radius: lot.length() };
    case 'segment': {
      const degree = lot.one([0, 1, 2, 3]);
      const weight = (_: unknown, k: number) => (lot.between(-0.5, 1) * mass(1 + k)) / 3 ** k;
      return {
        type: 'segment',
        a: lot.place(),
        b: lot.place(),
        weights: Array.from({ length: degree + 1 }, weight),
      };
    }
    case 'cone':
      return { type: 'segment', a: lot.place(), b: lot.place(), radii: [lot.length(), lot.length()] };
    case 'polygon':
      return randomPolygon(lot, mass(2));
    case 'polyline': {
      const line = { type: 'polyline', points: points(4), closed: lot.is(0.5) } as const;
      return lot.is(0.5) ? { ...line, radii: radii(4) } : { ...line, weights: weights(4) };
    }
    case 'nurbs': {
      const curve = { type: 'nurbs', points: points(5), density: 3, rational: [1, 2, 1, 0.5, 1] } as const;
      return lot.is(0.5) ? { ...curve, radii: radii(5) } : { ...curve, weights: weights(5) };
    }
    case 'profile':
      return { type: 'profile', points: points(3), curve: { type: 'bezier', ordinates: weights(7) } };
    case 'arc':
      return {
        type: 'arc',
        centre: lot.place(),
        start: lot.place(),
        axis: lot.direction(),
        angle: lot.between(1, 6),
        weights: [mass(1), 0.5 * mass(1)],
        ...fidelity,
      };
    case 'quadratic':
      return { type: 'quadratic', points: points(5), weights: weights(3), ...fidelity };
  }
}

/** A star about the origin of its plane, with or without a hole; one in four crosses itself. */
function randomPolygon(lot: Lot, most: number): AnySkel {
  const turns = lot.is(0.25) ? 2 : 1;
  const corners = 7;
  const at = (i: number): Vec2 => {
    const radius = lot.unit * lot.between(1, 3);
    const angle = (i * turns * TAU) / corners;
    return [radius * cos(angle), radius * sin(angle)];
  };
  const k = 0.3 * lot.unit;
  const hole: Vec2[] = [
    [k, 0],
    [0, k],
    [-k, -k],
  ];
  const loops = [lot.many(corners, at), ...(lot.is(0.4) ? [hole] : [])];
  const plane = { origin: lot.place(), u: lot.direction(), v: lot.direction() };
  return { type: 'polygon', ...plane, loops, weight: lot.between(0.2, 1.5) * most };
}
