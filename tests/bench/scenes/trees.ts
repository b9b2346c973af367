/** Trees that something was done to: carved by shapes and by skels that take away, and with cross sections of their own. */
import type { FieldNode, SkelsNode, Term } from '../../../src/field/node.ts';
import type { Warp } from '../../../src/field/warp.ts';
import type { Vec3 } from '../../../src/math/vec.ts';
import type { Shape } from '../../../src/shape/index.ts';
import { random } from '../../fixtures/random.ts';
import { sceneNode } from './index.ts';

const at = ([x, y, z]: Vec3, shape: Shape): FieldNode => ({
  type: 'affine',
  matrix: [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z],
  node: { type: 'shape', shape },
});

/** The tree of 64 less eight soft bites of its own sum, and less eight shapes, which leave sharp edges. */
export function carvedTree(): FieldNode {
  const tree = sceneNode('tree64');
  const next = random(5);
  const tip = (): Vec3 => tree.skels[Math.floor(next() * tree.skels.length)]!.skel.b;
  const bites = Array.from(
    { length: 8 },
    (): Term => ({
      skel: { type: 'point', at: tip(), weight: 0.02 },
      factor: -1,
    }),
  );
  const cutters = Array.from({ length: 8 }, (_, i) => {
    const shapes: readonly Shape[] = [
      { type: 'sphere', radius: 0.06 },
      { type: 'box', half: [0.05, 0.02, 0.05] },
      { type: 'cylinder', radius: 0.02, half: 0.1 },
    ];
    return at(tip(), shapes[i % 3]!);
  });
  const carved: SkelsNode = { ...tree, skels: [...tree.skels, ...bites] };
  return { type: 'subtraction', form: 'hard', parts: [carved, ...cutters] };
}

const FLOWER = Array.from({ length: 24 }, (_, i) => 1 + 0.25 * Math.cos((i * 2 * Math.PI * 5) / 24));
const SECTIONS: readonly Warp['section'][] = [
  { type: 'round' },
  { type: 'superQuadric', exponent: 4 },
  { type: 'polar', radii: FLOWER },
];

/** The tree of 64 with flat, square and lobed limbs. */
export function warpedTree(): SkelsNode {
  const tree = sceneNode('tree64');
  const skels = tree.skels.map((term, i): Term => {
    const { a, b } = term.skel;
    // across the limb, more or less
    const flat = Math.abs(b[1] - a[1]) > Math.abs(b[2] - a[2]);
    const section = SECTIONS[i % SECTIONS.length]!;
    return { ...term, warp: { section, scale: [1.4, 0.8], up: flat ? [0, 0, 1] : [0, 1, 0] } };
  });
  return { ...tree, skels };
}
