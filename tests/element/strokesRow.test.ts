/** Strokes in hand go one by one, by the numbers that are on the picture. */
import { describe, expect, it } from 'vitest';
import { draftSolids } from '../../src/document/build.ts';
import { apply, type Command } from '../../src/document/command/index.ts';
import { type Document, EMPTY_DOCUMENT, formOfDraft } from '../../src/document/document.ts';
import { strokesOfForm } from '../../src/document/surfacePart.ts';
import { idleNumbers, removals } from '../../src/element/strokesRow.ts';
import { PLANE, strokeAlong } from '../document/strokes.ts';

const side = (x: number): Command => ({
  type: 'addStroke',
  stroke: strokeAlong((t) => [x, 60 * t], { plane: PLANE }),
});
const section = (u: number, as: 'front' | 'back'): Command => ({
  type: 'addSection',
  u,
  side: as,
  drawn: {
    stroke: strokeAlong((t) => [40 * t - 20, 60 * u - 40 * t * (1 - t)], { plane: PLANE }),
    half: null,
  },
});
const over = (u: number): Command => ({
  type: 'redrawSection',
  u,
  drawn: { stroke: strokeAlong((t) => [10 * t, 5 + t], { plane: PLANE }), half: 20 },
});
const done = (...commands: readonly Command[]): Document => commands.reduce(apply, EMPTY_DOCUMENT);
const patch = () =>
  done(
    side(-20),
    side(20),
    section(0.49, 'front'),
    section(0.49, 'back'),
    section(0.78, 'front'),
    over(0.49),
  );
const strokes = ({ draft }: Document) => strokesOfForm(formOfDraft(draft!));

describe('each stroke in hand', () => {
  it('has the number of its place among all: sides, then front, back and redrawings of each section', () => {
    expect(removals(patch()).map(({ number, what }) => [number, what])).toEqual([
      [1, 'side'],
      [2, 'side'],
      [3, 'front'],
      [4, 'back'],
      [5, 'redraw'],
      [6, 'front'],
    ]);
  });

  it.each([1, 2, 4, 5, 6])('goes alone: number %i', (number) => {
    const document = patch();
    const all = strokes(document);
    const { command } = removals(document).find((one) => one.number === number)!;
    expect(strokes(apply(document, command))).toEqual(all.filter((_, i) => i !== number - 1));
  });

  it('takes its section with it when it is the front, or all there is', () => {
    const front = removals(patch())[2]!.command;
    expect(strokes(apply(patch(), front))).toHaveLength(3);
    const redrawn = done(side(-20), side(20), over(0.5));
    expect(removals(redrawn).at(-1)!.command).toEqual({ type: 'removeSection', index: 0 });
  });

  it('stays when it is the only side', () => {
    const tube = done(side(0), over(0.5), over(0.5));
    expect(removals(tube).map(({ number }) => number)).toEqual([2, 3]);
  });

  it('goes from among several that were drawn over one section: the others stay', () => {
    const tube = done(side(0), over(0.5), over(0.5), over(0.5));
    for (const { number, command } of removals(tube))
      expect(strokes(apply(tube, command))).toEqual(strokes(tube).filter((_, i) => i !== number - 1));
  });

  it('says where its section is', () => {
    expect(removals(patch()).map(({ u }) => u)).toEqual([null, null, 0.49, 0.49, 0.49, 0.78]);
  });

  it('is told when it lies over nothing any more', () => {
    // a bulge that leans out beyond the right end of an open section, and a stroke across that bulge
    const bulge = strokeAlong((t) => [5 + 10 * t + 100 * t * (1 - t), 30 * Math.sin(Math.PI * t)], {
      plane: PLANE,
    });
    const crown = strokeAlong((t) => [26 + 5 * t, 21 + 4 * Math.sin(Math.PI * t)], { plane: PLANE });
    const flat = strokeAlong((t) => [40 * t - 20, 30], { plane: PLANE });
    const open = done(
      side(-20),
      side(20),
      { type: 'addSection', u: 0.5, drawn: { stroke: flat, half: null } },
      { type: 'redrawSection', u: 0.5, drawn: { stroke: bulge, half: 20 } },
      { type: 'redrawSection', u: 0.5, drawn: { stroke: crown, half: 20 } },
    );
    expect(idleNumbers(open)).toEqual([]);
    const { command } = removals(open).find(({ number }) => number === 4)!;
    const less = apply(open, command);
    expect(idleNumbers(less)).toEqual([4]);
    expect(draftSolids(less)[0]!.mesh.positions.every(Number.isFinite)).toBe(true);
  });
});
