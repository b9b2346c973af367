/** What is told of bodies that pictures do not show whole. */
import { describe, expect, it } from 'vitest';
import { keepBody, makeBody } from '../../src/document/bodies.ts';
import { apply } from '../../src/document/command/index.ts';
import { EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { flawsIn } from '../../src/element/flaws.ts';
import { DRAFT } from '../../src/field/fieldWork.ts';
import type { FieldNode } from '../../src/field/node.ts';

const box = (half: readonly [number, number, number]): FieldNode => ({
  type: 'shape',
  shape: { type: 'box', half },
});
const apart = (gap: number): FieldNode => ({
  type: 'union',
  form: 'hard',
  parts: [
    box([10, 10, 10]),
    { type: 'affine', matrix: [1, 0, 0, 20 + gap, 0, 1, 0, 0, 0, 0, 1, 0], node: box([10, 10, 10]) },
  ],
});
const documentOf = (...nodes: readonly FieldNode[]) =>
  nodes.reduce((document, node) => apply(document, { type: 'addBody', node }), EMPTY_DOCUMENT);

describe('flaws', () => {
  it('are what is thin, near to itself or without end, part by part', () => {
    const nodes = [box([20, 0.1, 20]), apart(0.3), box([5, 5, 5])];
    for (const node of nodes) makeBody(node, 64);
    const endless: FieldNode = { type: 'shape', shape: { type: 'halfSpace', normal: [0, 1, 0], offset: 0 } };
    const document = documentOf(...nodes, endless);
    const told = flawsIn(document, () => null);
    expect(told.map(({ part, what }) => [part, what])).toEqual([
      [document.parts[0]!.id, 'thin'],
      [document.parts[1]!.id, 'gaps'],
      [document.parts[3]!.id, 'cut'],
    ]);
    expect(told[2]!.words).toContain('100 mm');
  });

  it('are no more than that there is nothing, where there is nothing; hidden parts have none', () => {
    const document = documentOf(box([20, 0.1, 20]));
    expect(flawsIn(document, () => 'Nothing.').map(({ what, words }) => [what, words])).toEqual([
      ['none', 'Nothing.'],
    ]);
    const ids = document.parts.map(({ id }) => id);
    expect(flawsIn(apply(document, { type: 'showParts', ids, visible: false }), () => 'Nothing.')).toEqual(
      [],
    );
  });

  it('are not told of drafts', () => {
    const node = box([20, 0.1, 20]);
    keepBody(node, { ...makeBody(node, DRAFT), cells: DRAFT });
    expect(flawsIn(documentOf(node), () => null)).toEqual([]);
  });
});
