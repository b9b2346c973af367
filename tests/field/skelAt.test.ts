/** The skel under a place, against the share that it has in the colour when it alone is painted; by hand where that is known. */
import { expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { skelAt } from '../../src/field/skelAt.ts';
import { BONE, body, placed, points, SKEW, sphere } from './trees.ts';

const SEED = 5200;
/** what colours leave out of sums, a thousandth of T of each piece, where sums are not far below T */
const UNSEEN = 0.02;
const LEAST = -0.2;

/** Every skel and shape of a tree: its path, and the tree with it white and all else black. */
function* painted(node: FieldNode): Generator<readonly [path: string, tree: FieldNode]> {
  const text = JSON.stringify(node);
  const count = [...text.matchAll(/"type":"(?:skels|shape)"/g)].length;
  for (let leaf = 0; leaf < count; leaf++) {
    for (let term = 0; ; term++) {
      let [path, leaves] = ['', -1];
      const paint = (inner: FieldNode, at: string): FieldNode => {
        const below = (name: string) => (at === '' ? name : `${at}.${name}`);
        switch (inner.type) {
          case 'shape': {
            const isIt = ++leaves === leaf && term === 0;
            if (isIt) path = `=${at}`;
            return { ...inner, colour: isIt ? [1, 1, 1] : [0, 0, 0] };
          }
          case 'skels': {
            const isHere = ++leaves === leaf;
            const skels = inner.skels.map((of, i) => {
              if (isHere && i === term) path = `=${below(`skels[${i}]`)}`;
              return { ...of, colour: isHere && i === term ? ([1, 1, 1] as const) : ([0, 0, 0] as const) };
            });
            return { ...inner, skels };
          }
          case 'affine':
            return { ...inner, node: paint(inner.node, below('node')) };
          case 'blend':
            return { ...inner, a: paint(inner.a, below('a')), b: paint(inner.b, below('b')) };
          case 'morph':
            return { ...inner, from: paint(inner.from, below('from')), to: paint(inner.to, below('to')) };
          default:
            return { ...inner, parts: inner.parts.map((part, i) => paint(part, below(`parts[${i}]`))) };
        }
      };
      const tree = paint(node, '');
      if (path === '') break;
      yield [path.slice(1), tree];
    }
  }
}

const ring: FieldNode = { type: 'shape', shape: { type: 'torus', ring: 6, tube: 1.5 } };
const curve: FieldNode = body([
  {
    skel: {
      type: 'polyline',
      closed: false,
      points: [
        [-6, 3, 0],
        [0, 5, 1],
        [6, 3, 0],
      ],
      weights: [2, 1, 2],
    },
  },
  { skel: { type: 'point', at: [0, -3, 0], weight: 4 } },
  { skel: { type: 'point', at: [2, -3, 0], weight: 2 }, factor: -0.5 },
]);
const TREES: readonly (readonly [name: string, tree: FieldNode])[] = [
  ['a sum with a curve and what carves', curve],
  ['a bone, skewed', { type: 'affine', matrix: SKEW, node: body(BONE, 1) }],
  ['a smooth union', { type: 'union', form: 'smooth', parts: [placed(body(BONE), 1, 2, 0), ring, curve] }],
  [
    'hard, nested',
    {
      type: 'subtraction',
      form: 'hard',
      parts: [{ type: 'union', form: 'hard', parts: [sphere(5), body(BONE)] }, placed(ring, 0, 4, 0)],
    },
  ],
  ['an intersection', { type: 'intersection', form: 'smooth', parts: [sphere(6), body(BONE, 0.2)] }],
  [
    'a blend',
    {
      type: 'blend',
      a0: 0.5,
      a1: 1,
      a2: 1,
      a: body(BONE),
      b: { type: 'affine', matrix: SKEW, node: sphere(3) },
    },
  ],
  ['a morph', { type: 'morph', t: 0.4, from: body(BONE), to: ring }],
];

test.each(TREES)('%s: the largest share of all (seed 5200)', (_, tree) => {
  const all = [...painted(tree)].map(([path, of]) => [path, bindField(of)] as const);
  const colour = new Float64Array(3);
  let told = 0;
  const field = bindField(tree);
  for (const [x, y, z] of points(1000, 8, SEED)) {
    if (field.value(x, y, z) < LEAST) continue;
    const shares = all.map(([path, of]) => {
      of.colour(x, y, z, colour);
      return [path, colour[0]!] as const;
    });
    const most = Math.max(...shares.map(([, share]) => share));
    const found = skelAt(tree, x, y, z)!;
    const own = shares.find(([path]) => path === found.path)!;
    expect(own, found.path).toBeDefined();
    // between two that are all but alike either is right
    expect(own[1]).toBeGreaterThan(most - UNSEEN);
    if (own[1] > 0.2) expect(Math.abs(own[1] - found.share)).toBeLessThan(0.25 * found.share);
    told++;
  }
  expect(told).toBeGreaterThan(20);
});

test('beyond every support there is none', () => {
  const point = (x: number) => ({ skel: { type: 'point', at: [x, 0, 0], weight: 3 } }) as const;
  const node = { ...body([point(-1), point(1)]), kernel: 'quartic', params: { R: 2 } } as const;
  expect(skelAt(node, 50, 0, 0)).toBeNull();
  expect(skelAt(node, 0.1, 0, 0)?.path).toBe('skels[1]');
  expect(skelAt(node, -2, 0, 0)).toEqual({ path: 'skels[0]', share: 1 });
});
