/** Trees of bodies in files: what comes out is what went in, and what makes no field is refused with its place. */
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { checkCommand, FileError, parse, serialize } from '../../src/document/serialize.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { Lot } from '../field/lot.ts';
import { randomTree } from '../field/randomTrees.ts';
import { EVERY_NODE, SKELS } from './everyNode.ts';

const file = (node: unknown): string =>
  JSON.stringify({ format: 'rotund', version: 2, document: { parts: [{ kind: 'body', node }] } });

const drawingOf = (node: FieldNode) => {
  const part = { id: 'part-1', name: 'Body 1', kind: 'body', node, colour: null, hidden: false } as const;
  const placement = { rotation: [0, 0, 0, 1], translation: [0, 0, 0] } as const;
  return { ...EMPTY_DRAWING, document: { ...EMPTY_DOCUMENT, parts: [{ ...part, placement }], nextId: 2 } };
};

const SEED = 71;
const trees = fc
  .record({ seed: fc.nat(), depth: fc.nat(3), unit: fc.constantFrom(0.01, 1, 20) })
  .map(({ seed, depth, unit }) => randomTree(new Lot(seed, unit), depth));

function refusal(text: string): string {
  try {
    parse(text, 'x.rotund');
  } catch (error) {
    if (error instanceof FileError) return error.message;
    throw error;
  }
  return 'read';
}

describe('trees', () => {
  it(`come back to the bit (random trees, seed ${SEED})`, () => {
    const returns = (node: FieldNode) => {
      const text = serialize(drawingOf(node));
      const back = parse(text, 'x.rotund');
      expect(back).toEqual(drawingOf(node));
      expect(serialize(back).length).toBe(text.length);
    };
    fc.assert(fc.property(trees, returns), { seed: SEED, numRuns: 150 });
  });

  it('come back with everything there is in one', () => {
    const text = serialize(drawingOf(EVERY_NODE));
    expect(parse(text, 'x.rotund')).toEqual(drawingOf(EVERY_NODE));
    expect(text).toContain('"version": 2');
  });

  it('may be 200 nodes deep, and no deeper', { timeout: 30_000 }, () => {
    const nested = (depth: number) => {
      let node: FieldNode = { type: 'shape', shape: { type: 'sphere', radius: 3 } };
      for (let i = 0; i < depth; i++) node = { type: 'union', form: 'hard', parts: [node] };
      return node;
    };
    const deep = drawingOf(nested(200));
    const text = serialize(deep);
    expect(parse(text, 'x.rotund')).toEqual(deep);
    // margins end somewhere: the text is as long as what is in it
    expect(text.length).toBeLessThan(60_000);
    expect(refusal(file(nested(201)))).toMatch(/makes no field: the tree is deeper than 200 nodes$/);
    expect(refusal(file(nested(300)))).toMatch(/expected at most 420 brackets/);
    expect(() => checkCommand({ type: 'addBody', node: nested(20_000) })).toThrow(FileError);
  });

  it(`are read or refused in one sentence, whatever is done to them (seed ${SEED})`, () => {
    const values = [null, 0, -1, 1e308, 0.5, 'x', [], {}, true, [[0, 0]], [1, 2, 3], undefined];
    const spoilt = fc.tuple(trees, fc.nat(), fc.constantFrom(...values)).map(([node, at, value]) => {
      const root = { node: structuredClone(node) as unknown };
      const spots = spotsIn(root);
      const { holder, key } = spots[at % spots.length]!;
      if (value === undefined && !Array.isArray(holder)) delete holder[key];
      else holder[key] = value ?? null;
      return root.node;
    });
    let refused = 0;
    const isRead = (node: unknown) => {
      const message = refusal(file(node));
      if (message !== 'read') refused++;
      expect(message).toMatch(/^read$|^x\.rotund, document\..*(: expected .+, found |: makes no field: )/);
    };
    fc.assert(fc.property(spoilt, isRead), { seed: SEED, numRuns: 400 });
    expect(refused).toBeGreaterThan(200);
  });
});

type Holder = Record<PropertyKey, unknown>;

function spotsIn(value: unknown): { holder: Holder; key: PropertyKey }[] {
  if (typeof value !== 'object' || value === null) return [];
  const holder = value as Holder;
  return Object.keys(value).flatMap((key) => [{ holder, key }, ...spotsIn(holder[key])]);
}

const body = (change: object): unknown => ({
  type: 'skels',
  kernel: 'cauchy',
  params: { s: 1 },
  threshold: 1,
  skels: [{ skel: { type: 'segment', a: [0, 0, 0], b: [4, 0, 0], weights: [2] } }],
  ...change,
});
const term = (skel: object) => body({ skels: [{ skel }] });
const inUnion = (node: unknown) => ({
  type: 'union',
  form: 'hard',
  parts: [{ type: 'shape', shape: { type: 'sphere', radius: 3 } }, node],
});

describe('what is wrong is said with its place', () => {
  const segment = { type: 'segment', a: [0, 0, 0], b: [4, 0, 0] };
  it.each<[unknown, string]>([
    [
      7,
      '.node: expected a node: skels, shape, union, intersection, subtraction, blend, morph or affine, found 7',
    ],
    [
      { type: 'soup' },
      '.node.type: expected a node: skels, shape, union, intersection, subtraction, blend, morph or affine, found "soup"',
    ],
    [
      inUnion(term({ ...segment, weights: ['2'] })),
      '.node.parts[1].skels[0].skel.weights[0]: expected a finite number, found "2"',
    ],
    [
      inUnion(term(segment)),
      '.node.parts[1].skels[0].skel: expected weights or radii, one of the two, found an object',
    ],
    [
      term({ ...segment, weights: [1], radii: [1, 1] }),
      '.node.skels[0].skel: expected weights or radii, one of the two, found an object',
    ],
    [
      term({ ...segment, a: [0, 0], weights: [1] }),
      '.node.skels[0].skel.a: expected three finite numbers, found [0, 0]',
    ],
    [
      term({ ...segment, weights: [1], colour: 3 }),
      '.node.skels[0].skel: expected only the fields type, a, b, weights, radii, found "colour"',
    ],
    [
      term({ type: 'knot' }),
      '.node.skels[0].skel.type: expected a skel: point, segment, polygon, polyline, nurbs, profile, arc or quadratic, found "knot"',
    ],
    [
      body({ kernel: 'cheese' }),
      '.node.kernel: expected one of "cauchy", "gaussian", "quartic", "inverse", "inverseSquared", "inverseCubic", "inverseQuintic", "power", found "cheese"',
    ],
    [body({ params: { s: 'wide' } }), '.node.params.s: expected a finite number, found "wide"'],
    [body({ colour: [0, 2, 0] }), '.node.colour[1]: expected a number from 0 to 1, found 2'],
    [
      { type: 'shape', shape: { type: 'sphere' } },
      '.node.shape.radius: expected a finite number, found nothing',
    ],
    [inUnion(body({ threshold: -1 })), '.node.parts[1]: makes no field: threshold must be above 0, got -1'],
    [
      inUnion(body({ params: { R: 3 } })),
      ".node.parts[1].params: makes no field: kernel cauchy has no parameter 'R'",
    ],
    [inUnion(body({ skels: [] })), '.node.parts[1]: makes no field: a body needs at least one skel'],
    [
      term({ ...segment, radii: [1, 1, 1] }),
      '.node.skels[0]: makes no field: a segment has 2 radii, found 3',
    ],
    [
      term({ ...segment, radii: [1, -1] }),
      '.node.skels[0].radii[1]: makes no field: the radius must be above 0, found -1',
    ],
    [
      { type: 'affine', matrix: [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0], node: body({}) },
      '.node: makes no field: matrix flattens space',
    ],
    [
      term({ type: 'nurbs', points: [], radii: [], density: 1e9 }),
      '.node.skels[0]: makes no field: a cubic curve needs 4 control points, got 0',
    ],
  ])('%j', (node, message) => {
    expect(refusal(file(node))).toBe(`x.rotund, document.parts[0]${message}`);
  });

  it('where a curve would be cut into more segments than there is room for', () => {
    const points = Array.from({ length: 1000 }, (_, i) => [i, 0, 0]);
    const radii = points.map(() => 1);
    const curve = (density: number) => file(term({ type: 'nurbs', points, radii, density }));
    expect(refusal(curve(200))).toBe(
      'x.rotund, document.parts[0].node.skels[0].skel.density: expected at most 100000 segments, points times density, found 200',
    );
    expect(refusal(curve(2))).toBe('read');
  });

  it('in scripts and at the border of the element alike', () => {
    const command = { type: 'addBody', node: body({ threshold: 0 }) };
    expect(refusal(JSON.stringify([command]))).toBe(
      'x.rotund, commands[0].node: makes no field: threshold must be above 0, got 0',
    );
    expect(() => checkCommand(command)).toThrow(
      'command, node: makes no field: threshold must be above 0, got 0',
    );
  });

  it('where a number is too large for JSON', () => {
    const text = file(body({ threshold: 1 })).replace('"threshold":1', '"threshold":1e999');
    expect(refusal(text)).toBe(
      'x.rotund, document.parts[0].node.threshold: expected a finite number, found Infinity',
    );
  });

  it('knows every kind of skel', () => {
    for (const skel of SKELS) expect(refusal(file(term(skel)))).toBe('read');
  });
});
