/** Scripts that aim at what is not there are refused, and told what was expected. */
import { describe, expect, it } from 'vitest';
import { checkCommands } from '../../src/document/check.ts';
import { EMPTY_DOCUMENT } from '../../src/document/document.ts';

const line = (...samples: readonly (readonly [number, number])[]) => ({ samples });
const SIDES = [-20, 20].map((x) => ({ type: 'addStroke', stroke: line([x, 0], [x, 60]) }));
const drawn = { stroke: line([-20, 30], [0, 10], [20, 30]) };
const SECTION = { type: 'addSection', u: 0.5, drawn };
const KEEP = { type: 'keep' };
const bend = (stroke: object) => ({
  type: 'bend',
  id: 'part-1',
  bend: { stroke, keepsLength: true },
});
const all = (...commands: readonly object[]) => checkCommands(commands, EMPTY_DOCUMENT);

describe('a command in a script', () => {
  it.each([
    ['no unfinished form', [SECTION], 'commands, [0].type: expected an unfinished form'],
    ['no such section', [...SIDES, SECTION, { type: 'removeSection', index: 1 }], 'the index of a section'],
    [
      'no back',
      [...SIDES, SECTION, { type: 'removeSection', index: 0, only: 'back' }],
      'that has a back by then',
    ],
    [
      'ends in one place',
      [...SIDES, { ...SECTION, drawn: { stroke: line([0, 0], [9, 9], [0, 0]) } }],
      'ends are in two places',
    ],
    ['no such stroke', [...SIDES, { type: 'setStroke', index: 2, stroke: null }], 'the index of a stroke'],
    [
      'no such bend',
      [...SIDES, KEEP, { type: 'setBend', id: 'part-1', index: 0, change: null }],
      'index of a bend',
    ],
    ['a dot', [...SIDES, KEEP, bend(line([0, 0], [0, 0]))], 'longer than a dot'],
    [
      'seen from its end',
      [...SIDES, KEEP, bend({ ...line([0, 0], [30, 30]), plane: { x: [1, 0, 0], y: [0, 0, 1] } })],
      'not from its end',
    ],
  ])('is refused: %s', (_, commands, message) => {
    expect(() => all(...commands)).toThrow(message);
  });

  it('is taken where all is there', () => {
    const back = { ...SECTION, side: 'back' };
    const less = { type: 'removeSection', index: 0, only: 'back' };
    const bent = bend({ ...line([0, 0], [10, 60]), plane: { x: [0, 0, -1] } });
    expect(all(...SIDES, SECTION, back, less, KEEP, bent)).toHaveLength(7);
  });
});
