import { expect, it } from 'vitest';
import { apply, type Command, describe as words } from '../../src/document/command/index.ts';
import { type Document, EMPTY_DOCUMENT } from '../../src/document/document.ts';
import type { FieldNode } from '../../src/field/node.ts';

const ball = (radius: number): FieldNode => ({ type: 'shape', shape: { type: 'sphere', radius } });
const done = (commands: readonly Command[]): Document => commands.reduce(apply, EMPTY_DOCUMENT);
const before = done([
  { type: 'addBody', node: ball(5), name: 'Head', colour: '#112233' },
  { type: 'moveParts', ids: ['part-1'], by: { rotation: [0, 0, 0, 1], translation: [1, 2, 3] } },
]);

it('gives a body another tree and leaves all else', () => {
  const node = ball(6);
  const command: Command = { type: 'setBody', id: 'part-1', node };
  const { parts, ...rest } = apply(before, command);
  expect(parts).toEqual([{ ...before.parts[0], node }]);
  expect({ ...rest, parts: before.parts }).toEqual(before);
  expect(words(before, command)).toBe('shape of Head');
});

it('does nothing where there is nothing to do', () => {
  const { node } = before.parts[0] as { node: FieldNode };
  expect(apply(before, { type: 'setBody', id: 'part-1', node })).toBe(before);
  expect(apply(before, { type: 'setBody', id: 'part-2', node: ball(1) })).toBe(before);
});
