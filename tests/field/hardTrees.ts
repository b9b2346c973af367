/** Trees with many creases, drawn by lot: turned boxes, cylinders, balls, rings and bodies in hard sets, some smooth ones and a blend here and there. */
import type { Affine } from '../../src/field/affine.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { cos, sin } from '../../src/math/trig.ts';
import type { Shape } from '../../src/shape/index.ts';
import type { Lot } from './lot.ts';
import { body, sphere } from './trees.ts';

export function hardTree(lot: Lot, depth = 3): FieldNode {
  if (depth === 0) return { type: 'affine', matrix: turnedBy(lot), node: solid(lot) };
  const child = () => hardTree(lot, lot.is(0.4) ? 0 : depth - 1);
  if (lot.is(0.08)) return { type: 'blend', a: child(), b: child(), a0: 0.3, a1: 1, a2: 1 };
  const type = lot.one(['union', 'intersection', 'subtraction', 'union'] as const);
  const form = lot.one(['hard', 'hard', 'hard', 'smooth'] as const);
  return { type, form, parts: lot.many(lot.one([2, 2, 3]), child) };
}

function turnedBy(lot: Lot): Affine {
  const [a, b] = [lot.between(0, 6), lot.between(0, 6)];
  const [c, s, d, t] = [cos(a), sin(a), cos(b), sin(b)];
  const [x, y, z] = lot.place();
  return [c, -s * d, s * t, x / 2, s, c * d, -c * t, y / 2, 0, t, d, z / 2];
}

function solid(lot: Lot): FieldNode {
  const size = () => lot.between(1, 3.5);
  const shape = (of: Shape): FieldNode => ({ type: 'shape', shape: of, colour: lot.colour() });
  switch (lot.one(['box', 'cylinder', 'box', 'cylinder', 'sphere', 'torus', 'body'] as const)) {
    case 'box':
      return shape({ type: 'box', half: [size(), size(), size()] });
    case 'cylinder':
      return shape({ type: 'cylinder', radius: size(), half: size() });
    case 'sphere':
      return sphere(size());
    case 'torus':
      return shape({ type: 'torus', ring: 2 + size(), tube: 0.5 * size() });
    case 'body':
      return body();
  }
}
