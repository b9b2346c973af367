/** What ordinary deeds make can always be read again: found by a reading, kept as cases. */
import { describe, expect, it } from 'vitest';
import { apply, type Command } from '../../src/document/command/index.ts';
import { type Document, EMPTY_DOCUMENT, isSolid, type SolidPart } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { parse, serialize } from '../../src/document/serialize.ts';
import { groupsOf } from '../../src/document/solid.ts';
import { nodeOf } from '../../src/document/solidNode.ts';
import { bindField } from '../../src/field/bind.ts';
import { kernels } from '../../src/kernel/index.ts';
import { PLANE, strokeAlong } from './strokes.ts';

const ring = (radius: number, x = 0) =>
  strokeAlong((t) => [x + radius * Math.cos(6.28 * t), radius * Math.sin(6.28 * t)], {
    closed: true,
    plane: PLANE,
    pointer: 'pen',
  });

const line = () => strokeAlong((t) => [60 * t, 20 * t * t], { closed: false, plane: PLANE, pointer: 'pen' });

const done = (...commands: readonly Command[]): Document => commands.reduce(apply, EMPTY_DOCUMENT);
const readAgain = (document: Document): Document =>
  parse(serialize({ ...EMPTY_DRAWING, document }), 'x').document;
const stroke = (drawn: ReturnType<typeof ring>): Command => ({ type: 'addStroke', stroke: drawn });
const KEEP: Command = { type: 'keep' };
const solidOf = ({ parts }: Document): SolidPart => parts.filter(isSolid)[0]!;

describe('forms of several strokes', () => {
  const holed = [stroke(ring(40)), stroke(ring(10))];

  it.each(['ring', 'line', 'curve', 'point', 'rotational', 'tube', 'plate'] as const)(
    'an outline with a hole, chosen to be a %s',
    (form) => {
      const draft = done(...holed, { type: 'setForm', form });
      expect(readAgain(draft)).toEqual(draft);
      const kept = apply(draft, KEEP);
      expect(readAgain(kept)).toEqual(kept);
    },
  );

  it.each(['ring', 'line', 'curve', 'point', 'plate'] as const)('a kept one, made a %s', (form) => {
    const kept = done(...holed, KEEP);
    const ids = [solidOf(kept).id];
    const changed = apply(kept, { type: 'setGroups', ids, change: { form } });
    expect(readAgain(changed)).toEqual(changed);
    expect(groupsOf(solidOf(changed))[0]!.form).toBe(form === 'plate' ? 'plate' : 'soft');
  });
});

it('an extrusion has no fewer corners than one can have', () => {
  const kept = done(stroke(ring(40)), KEEP);
  const ids = [solidOf(kept).id];
  const changed = [
    { section: 'superQuadric', exponent: 1 } as const,
    { section: 'extrusion' } as const,
  ].reduce((document, change) => apply(document, { type: 'setGroups', ids, change }), kept);
  expect(readAgain(changed)).toEqual(changed);
  expect(() => bindField(nodeOf(solidOf(changed)))).not.toThrow();
});

it.each(kernels.map(({ name }) => name))(
  '%s: every form and profile has a field, or is nothing',
  (kernel) => {
    for (const form of ['soft', 'plate', 'ring', 'line'] as const) {
      for (const profile of [[1], [1, 0.25, 4], [0.01, 100]]) {
        const ids = ['part-1'];
        const kept = done(
          stroke(ring(40)),
          KEEP,
          { type: 'setGroups', ids, change: { form, profile } },
          { type: 'setComponents', ids, change: { kernel } },
        );
        expect(() => bindField(nodeOf(solidOf(kept)))).not.toThrow();
      }
    }
  },
);

describe('what would leave the space that files hold', () => {
  const wide = done(stroke(ring(40)), KEEP, stroke(line()), KEEP);

  it('stays when it is scaled or mirrored', () => {
    const ids = wide.parts.map(({ id }) => id);
    for (const command of [
      { type: 'scaleParts', ids, factor: 100, about: [9e5, 0, 0] },
      { type: 'scaleParts', ids, factor: 0.01, about: [0, 0, 0] },
      { type: 'mirrorParts', ids, about: [9e5, 0, 0], normal: [1, 0, 0] },
    ] as const) {
      const often = [1, 2, 3, 4, 5, 6].reduce((document) => apply(document, command), wide);
      expect(readAgain(often)).toEqual(often);
    }
  });

  it('a solid is scaled as a whole or not at all', () => {
    const far = ring(10);
    const two = done(
      stroke(ring(40)),
      KEEP,
      {
        type: 'addStroke',
        stroke: { ...far, plane: { ...far.plane, origin: [90_000, 0, 0] } },
        joins: { solid: 'part-1', component: 'component-2' },
      },
      KEEP,
    );
    expect(groupsOf(solidOf(two))).toHaveLength(2);
    const scaled = apply(two, { type: 'scaleParts', ids: ['part-1'], factor: 20, about: [0, 0, 0] });
    expect(scaled.parts).toEqual(two.parts);
  });
});

it('a skeleton is of the group that is named, not of all in a component', () => {
  const kept = done(stroke(ring(40)), KEEP);
  const skeleton = { nodes: [{ at: [0, 0], radius: 5 }], links: [] } as const;
  expect(apply(kept, { type: 'editSkeleton', id: 'component-2', skeleton })).toBe(kept);
  expect(apply(kept, { type: 'editSkeleton', id: 'group-3', skeleton })).not.toBe(kept);
});

it('what carves where nothing is becomes a body like others', () => {
  const kept = done(
    stroke(ring(40)),
    KEEP,
    {
      type: 'addStroke',
      stroke: ring(15, 20),
      joins: { solid: 'part-1', component: 'component-2' },
      carves: true,
    },
    { type: 'removeParts', ids: ['part-1'] },
    KEEP,
  );
  expect(groupsOf(solidOf(kept))[0]!.shape.weight).toBe(1);
});

describe('groups that are moved', () => {
  const at = (component: string | null): Command => ({
    type: 'addStroke',
    stroke: ring(12, 30),
    joins: { solid: 'part-1', component },
  });
  /** components of two and of two */
  const four = done(stroke(ring(40)), KEEP, at('component-2'), KEEP, at(null), KEEP, at('component-8'), KEEP);
  const ids = solidOf(four).components.map(({ groups }) => groups.map(({ id }) => id));

  it('have these components to begin with', () => expect(ids.map(({ length }) => length)).toEqual([2, 2]));

  it('stay what they are where a whole solid goes to itself or to its own', () => {
    for (const to of [{ solid: 'part-1', component: null }, null]) {
      expect(apply(four, { type: 'moveGroups', ids: ['part-1'], to })).toBe(four);
    }
  });

  it('one of each component becomes a third', () => {
    const to = { solid: 'part-1', component: null };
    const moved = apply(four, { type: 'moveGroups', ids: [ids[0]![0]!, ids[1]![0]!], to });
    expect(solidOf(moved).components.map(({ groups }) => groups.length)).toEqual([1, 1, 2]);
    expect(readAgain(moved)).toEqual(moved);
  });

  it('components that are taken whole go on as they are', () => {
    const twice = apply(four, { type: 'duplicateParts', ids: ['part-1'], offset: [0, 0, 90] });
    const copy = twice.parts[1]!;
    const to = { solid: 'part-1', component: null };
    const moved = apply(twice, { type: 'moveGroups', ids: [copy.id], to });
    expect(moved.parts).toHaveLength(1);
    expect(solidOf(moved).components.map(({ groups }) => groups.length)).toEqual([2, 2, 2, 2]);
    expect(readAgain(moved)).toEqual(moved);
  });
});
