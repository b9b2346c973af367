import { expect, test } from 'vitest';
import { apply } from '../../../src/document/command/index.ts';
import { EMPTY_DOCUMENT, isSolid } from '../../../src/document/document.ts';
import { nodeOf } from '../../../src/document/solidNode.ts';
import { strokeAlong } from '../strokes.ts';

const tap = strokeAlong(() => [7, 9], {}, 3);

test('a tap becomes a ball when it is told to', () => {
  const drawn = apply(EMPTY_DOCUMENT, { type: 'addStroke', stroke: tap, form: 'point' });
  const [part] = apply(drawn, { type: 'keep' }).parts;
  const node = nodeOf(part as Extract<typeof part, { kind: 'solid' }>);
  expect(isSolid(part!)).toBe(true);
  expect(node).toMatchObject({ type: 'skels', skels: [{ skel: { type: 'point', at: [7, 9, 0] } }] });
});
