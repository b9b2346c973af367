/** Cells of bodies: of about the same size all over a document, finer where something is thin, and no more than that. */
import { describe, expect, it } from 'vitest';
import { CELLS, makeBody } from '../../src/document/bodies.ts';
import { cellsOfBodies, finerCells } from '../../src/document/cells.ts';
import { apply, type Command } from '../../src/document/command/index.ts';
import { type Document, EMPTY_DOCUMENT, isBody } from '../../src/document/document.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { line } from './strokes.ts';

const ball = (radius: number): FieldNode => ({ type: 'shape', shape: { type: 'sphere', radius } });
const plate = (half: number, thickness: number): FieldNode => ({
  type: 'shape',
  shape: { type: 'box', half: [half, thickness / 2, half] },
});
const added = (node: FieldNode, x = 0): Command[] => [
  { type: 'addBody', node },
  { type: 'moveParts', ids: [], by: { rotation: [0, 0, 0, 1], translation: [x, 0, 0] } },
];
/** Bodies in a row, `apart` mm between their middles. */
function row(nodes: readonly FieldNode[], apart: number): Document {
  return nodes.reduce((document, node, i) => {
    const [add, move] = added(node, i * apart);
    const next = apply(document, add!);
    return apply(next, { ...move!, ids: [next.parts.at(-1)!.id] } as Command);
  }, EMPTY_DOCUMENT);
}
const cellsIn = (document: Document, cells?: number) =>
  document.parts.filter(isBody).map(({ node }) => cellsOfBodies(document, cells)(node));

describe('cells of bodies', () => {
  it('are those of the document for its only body, whatever its size', () => {
    expect(cellsIn(row([ball(0.001)], 0))).toEqual([CELLS]);
    expect(cellsIn(row([ball(1000)], 0), 40)).toEqual([40]);
  });

  it('are of about the same size, never larger than asked for', () => {
    const radii = [50, 40, 24, 12];
    const document = row(radii.map(ball), 0);
    const cell = 100 / CELLS;
    cellsIn(document).forEach((cells, i) => {
      const own = (2 * radii[i]!) / cells;
      expect(own).toBeLessThanOrEqual(cell * 1.03);
      expect(own).toBeGreaterThan(cell / 2);
    });
  });

  it('are 32 at least, but no more than were asked for', () => {
    const document = row([ball(100), ball(1)], 0);
    expect(cellsIn(document)).toEqual([CELLS, 32]);
    expect(cellsIn(document, 512)).toEqual([512, 64]);
    expect(cellsIn(document, 20)).toEqual([20, 20]);
  });

  it('become fewer where a document grows, and stay where a part moves a little', () => {
    const [near, little, far] = [200, 205, 2000].map((apart) => cellsIn(row([ball(50), ball(50)], apart)));
    expect(near![0]).toBeLessThan(CELLS);
    expect(little).toEqual(near);
    expect(far).toEqual([32, 32]);
  });

  it('count surfaces and hidden parts in', () => {
    const alone = row([ball(5), ball(5)], 0);
    const drawn: readonly Command[] = [{ type: 'addStroke', stroke: line(0) }, { type: 'keep' }];
    const beside = drawn.reduce(apply, alone);
    expect(cellsIn(beside)[0]).toBeLessThan(cellsIn(alone)[0]!);
    const ids = beside.parts.map(({ id }) => id);
    expect(cellsIn(apply(beside, { type: 'showParts', ids, visible: false }))).toEqual(cellsIn(beside));
  });

  it('take bodies without surface and without end', () => {
    const nothing: FieldNode = { type: 'subtraction', form: 'hard', parts: [ball(3), ball(5)] };
    const endless: FieldNode = { type: 'shape', shape: { type: 'halfSpace', normal: [0, 1, 0], offset: 0 } };
    expect(cellsIn(row([nothing, ball(5)], 0))[1]).toBe(CELLS);
    expect(cellsIn(row([endless, ball(50)], 0))).toEqual([CELLS, CELLS / 2]);
  });
});

describe('finer cells', () => {
  it('are as fine as a plate needs', () => {
    const node = plate(40, 0.7);
    const body = makeBody(node);
    const finer = finerCells(body);
    expect(finer).toBeGreaterThan(CELLS);
    expect(80 / finer).toBeLessThan(0.7 / 1.5);
    expect(80 / finer).toBeGreaterThan(0.7 / 1.6);
    const again = makeBody(node, finer);
    expect(again.mesh.thin).toBeNull();
    expect(finerCells(again)).toBe(finer);
  });

  it('are at most twice as many, and none for thick bodies', () => {
    expect(finerCells(makeBody(plate(40, 0.01)))).toBe(2 * CELLS);
    expect(finerCells(makeBody(ball(5)))).toBe(CELLS);
  });
});
