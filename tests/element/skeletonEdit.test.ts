/** Nodes of a skeleton deleted by keys. */
import { expect, test } from 'vitest';
import { apply, type Command } from '../../src/document/command/index.ts';
import { EMPTY_DOCUMENT, type SolidPart } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { Session } from '../../src/element/session.ts';
import {
  chooseNode,
  chosenNode,
  removeNode,
  selectedSkeleton,
  toggleSkeleton,
} from '../../src/element/skeletonEdit.ts';
import { line } from '../document/strokes.ts';

const COMMANDS: readonly Command[] = [
  { type: 'addStroke', stroke: line(0, 40), form: 'line' },
  { type: 'keep' },
];
const GRAPH = {
  nodes: [0, 1, 2, 3].map((i) => ({ at: [10 * i, 0] as const, radius: 3 })),
  links: [
    [0, 1],
    [1, 2],
    [2, 3],
  ] as const,
};

function opened(): Session {
  const drawn = COMMANDS.reduce(apply, EMPTY_DOCUMENT);
  const [group] = (drawn.parts[0] as SolidPart).components[0]!.groups;
  const document = apply(drawn, { type: 'editSkeleton', id: group!.id, skeleton: GRAPH });
  const session = new Session({ changed() {}, drawn() {}, committed() {}, selected() {}, moded() {} });
  session.frames.asleep = true;
  session.open({ ...EMPTY_DRAWING, document }, { fresh: true });
  session.setTool('select');
  session.select(document.parts.map(({ id }) => id));
  toggleSkeleton(session);
  return session;
}

test('Delete again and again deletes node after node, and never the form', () => {
  const session = opened();
  chooseNode(session, { node: 3, time: 0 });
  for (const left of [3, 2, 1, 1, 1]) {
    expect(removeNode(session)).toBe(true);
    const at = selectedSkeleton(session)!;
    expect(at.graph.nodes).toHaveLength(left);
    expect(chosenNode(session, at)).toBe(left - 1);
  }
  expect(session.document.parts).toHaveLength(1);
});

test('Delete deletes nothing while a skeleton is shown and no node is chosen; hidden, it is for the form', () => {
  const session = opened();
  const before = session.document;
  expect(removeNode(session)).toBe(true);
  expect(session.document).toBe(before);
  toggleSkeleton(session);
  expect(removeNode(session)).toBe(false);
});
