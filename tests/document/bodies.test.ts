/** Bodies in documents: commands, meshes kept by the tree, colours. */
import { describe, expect, it } from 'vitest';
import { bodyMade, keepBody, makeBody } from '../../src/document/bodies.ts';
import { solidOf, solids } from '../../src/document/build.ts';
import { apply, type Command, describe as words } from '../../src/document/command/index.ts';
import { type BodyPart, type Document, EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { middleOf } from '../../src/document/extent.ts';
import { isTooLarge } from '../../src/document/size.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { topology } from '../../src/mesh/check.ts';
import { bounds, volume } from '../../src/mesh/measure.ts';
import { strokeAlong } from './strokes.ts';

const ball = (radius: number): FieldNode => ({
  type: 'shape',
  shape: { type: 'sphere', radius },
  colour: [0.5, 0.25, 0],
});
const done = (commands: readonly Command[]): Document => commands.reduce(apply, EMPTY_DOCUMENT);
const added = (node: FieldNode, data: { readonly name?: string; readonly colour?: string } = {}): Document =>
  done([{ type: 'addBody', node, ...data }]);
const first = ({ parts }: Document) => parts[0] as BodyPart;

describe('addBody', () => {
  it('adds a part with the next id and leaves the unfinished form alone', () => {
    const stroke = strokeAlong((t) => [40 * t, 0]);
    const document = done([
      { type: 'addStroke', stroke },
      { type: 'addBody', node: ball(5) },
      { type: 'addBody', node: ball(6), name: '  Head ', colour: '#112233' },
    ]);
    expect(document.parts.map(({ id, name, kind }) => [id, name, kind])).toEqual([
      ['part-1', 'Body 1', 'body'],
      ['part-2', 'Head', 'body'],
    ]);
    expect((document.parts as BodyPart[]).map(({ colour }) => colour)).toEqual([null, '#112233']);
    expect(document.draft?.strokes).toEqual([stroke]);
    expect(document.nextId).toBe(3);
    expect(words(EMPTY_DOCUMENT, { type: 'addBody', node: ball(5), name: 'Head' })).toBe('Head added');
  });
});

describe('a body', () => {
  it('has no mesh until it is made, and then a sound one where it was moved to', () => {
    const node = ball(10);
    const document = added(node);
    expect(solids(document)).toEqual([]);
    makeBody(node, 32);
    const moved = apply(document, {
      type: 'moveParts',
      ids: ['part-1'],
      by: { rotation: [0, 0, 0, 1], translation: [5, 0, 0] },
    });
    const [solid] = solids(moved);
    expect(topology(solid!.mesh)).toMatchObject({ watertight: true, genus: 0, finite: true });
    expect(volume(solid!.mesh)).toBeCloseTo((4 / 3) * Math.PI * 1000, -2);
    expect(bounds(solid!.mesh).max[0]).toBeCloseTo(15, 2);
    expect(middleOf(first(moved))![0]).toBeCloseTo(5, 2);
  });

  it('keeps its mesh when it is moved, hidden, named, coloured or copied', () => {
    const node = ball(10);
    const made = makeBody(node, 16);
    const changed = [
      { type: 'renamePart', id: 'part-1', name: 'Head' },
      { type: 'setPartBrush', ids: ['part-1'], change: { colour: '#ff0000' } },
      { type: 'showParts', ids: ['part-1'], visible: false },
      { type: 'duplicateParts', ids: ['part-1'], offset: [1, 0, 0] },
    ] as const;
    const document = changed.reduce(apply, added(node));
    for (const part of document.parts) expect(solidOf(part)!.mesh.indices).toBe(made.mesh.indices);
    expect(makeBody(node, 16)).toBe(made);
  });

  it('shows the finer mesh as soon as there is one', () => {
    const node = ball(10);
    const document = added(node);
    const coarse = makeBody(node, 12);
    expect(solids(document)[0]!.mesh).toBe(coarse.mesh);
    const fine = makeBody({ ...node }, 24);
    keepBody(node, fine);
    expect(solids(document)[0]!.mesh).toBe(fine.mesh);
    expect(bodyMade(node)).toBe(fine);
  });

  it('is painted by its tree, or all of one colour', () => {
    const node = ball(10);
    makeBody(node, 12);
    const document = added(node);
    const paint = solids(document)[0]!.mesh.colours!;
    expect([...paint.subarray(0, 3)]).toEqual([0.5, 0.25, 0]);
    const red = apply(document, { type: 'setPartBrush', ids: ['part-1'], change: { colour: '#ff0000' } });
    expect(solids(red)[0]).toMatchObject({ colour: '#ff0000' });
    expect(solids(red)[0]!.mesh.colours).toBeUndefined();
    // of a brush it has nothing else
    expect(apply(red, { type: 'setPartBrush', ids: ['part-1'], change: { radius: 3, levels: 1 } })).toBe(red);
  });

  it('counts for how large a document may be', () => {
    const skel = { type: 'point', at: [0, 0, 0], weight: 1 } as const;
    const skels = Array.from({ length: 10_000 }, () => ({ skel }));
    const node = { type: 'skels', kernel: 'cauchy', params: {}, threshold: 1, skels } as const;
    const document = added(node);
    expect(isTooLarge(document)).toBe(false);
    const copies = Array.from({ length: 5 }, (_, i) => ({ ...first(document), id: `part-${i + 2}` }));
    expect(isTooLarge({ ...document, parts: copies })).toBe(true);
  });
});
