/** Trees of all that there is, drawn by lot: every kernel, skel, curve, section, shape and operation, sizes near `unit` mm. */
import type { Affine } from '../../src/field/affine.ts';
import type { FieldNode, SkelsNode, Term } from '../../src/field/node.ts';
import type { Warp } from '../../src/field/warp.ts';
import { kernels } from '../../src/kernel/index.ts';
import type { ParamSpec } from '../../src/kernel/kernel.ts';
import { sin, TAU } from '../../src/math/trig.ts';
import { type Shape, shapes } from '../../src/shape/index.ts';
import type { Lot } from './lot.ts';
import { type Mass, randomSkel } from './randomSkels.ts';

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
  const mass = (dimension: number) => lot.unit ** -(dimension + kernel.homogeneity);
  const skels = lot.many(lot.one([1, 2, 4]), () => randomTerm(lot, mass));
  return { type: 'skels', kernel: kernel.name, params, threshold: lot.between(0.2, 2), skels };
}

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
