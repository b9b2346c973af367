import { describe, expect, it } from 'vitest';
import { copiesOf } from '../../src/document/command/duplicateParts.ts';
import { apply, type Command } from '../../src/document/command/index.ts';
import { EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { middleOfParts, seenParts } from '../../src/document/extent.ts';
import { mirrorOf } from '../../src/document/mirror.ts';
import type { Quat } from '../../src/math/vec.ts';
import { figure, solidOf } from './figure.ts';
import { line, VIEW } from './strokes.ts';

const document = figure();
const { groups } = solidOf(document);
const [, head, ear, eye] = groups.map(({ id }) => id) as [string, string, string, string];
const middle = (of: typeof document, ids: readonly string[]) => middleOfParts(seenParts(of, ids))!;

describe('where the mirror stands', () => {
  it('an ear goes to the other side of the middle of the largest form, upright', () => {
    const mirror = mirrorOf(document, [ear], VIEW)!;
    expect(mirror.across).toBe('Body');
    expect(mirror.normal).toEqual([1, 0, 0]);
    const mirrored = apply(document, { type: 'mirrorParts', ids: [ear], ...mirror });
    const [x, y] = middle(mirrored, [ear]);
    expect(x).toBeCloseTo(14, 6);
    expect(y).toBeCloseTo(52, 6);
  });

  it('a head in the middle is flipped where it is', () => {
    const mirror = mirrorOf(document, [head], VIEW)!;
    expect(mirror.across).toBeNull();
    const mirrored = apply(document, { type: 'mirrorParts', ids: [head], ...mirror });
    expect(middle(mirrored, [head])[0]).toBeCloseTo(middle(document, [head])[0], 9);
  });

  it('is as one looks: from the side front and back change places', () => {
    const side: Quat = [0, Math.SQRT1_2, 0, Math.SQRT1_2];
    expect(mirrorOf(document, [eye], { ...VIEW, rotation: side })!.normal).toEqual([0, 0, 1]);
    const nearly: Quat = [0, Math.sin(0.3), 0, Math.cos(0.3)];
    expect(mirrorOf(document, [eye], { ...VIEW, rotation: nearly })!.normal).toEqual([1, 0, 0]);
  });

  it('of parts is the largest other part; alone it is flipped, and of nothing there is none', () => {
    const KEEP: Command = { type: 'keep' };
    const commands: Command[] = [
      { type: 'addStroke', stroke: line(10, 80) },
      KEEP,
      { type: 'addStroke', stroke: line(40, 20) },
      KEEP,
    ];
    const two = commands.reduce(apply, EMPTY_DOCUMENT);
    const mirror = mirrorOf(two, ['part-2'], VIEW)!;
    expect(mirror.across).toBe(two.parts[0]!.name);
    const mirrored = apply(two, { type: 'mirrorParts', ids: ['part-2'], ...mirror });
    expect(middle(mirrored, ['part-2'])[0]).toBeCloseTo(-20, 6);
    expect(mirrorOf(two, ['part-1', 'part-2'], VIEW)!.across).toBeNull();
    expect(mirrorOf(two, [], VIEW)).toBeNull();
  });
});

describe('a mirrored copy', () => {
  it('is one step, stays in its component, and leaves the original', () => {
    const { about, normal } = mirrorOf(document, [ear], VIEW)!;
    const copies = copiesOf(document, [ear]);
    const command: Command = {
      type: 'duplicateParts',
      ids: [ear],
      offset: [0, 0, 0],
      mirror: { about, normal },
    };
    const twice = apply(document, command);
    expect(middle(twice, [ear])).toEqual(middle(document, [ear]));
    expect(middle(twice, copies)[0]).toBeCloseTo(14, 6);
    expect(solidOf(twice).part.components[0]!.groups).toHaveLength(4);
  });

  it('of a component is a component of its own', () => {
    const { part } = solidOf(document);
    const ids = [part.components[1]!.id];
    const twice = solidOf(apply(document, { type: 'duplicateParts', ids, offset: [5, 0, 0] }));
    expect(twice.part.components).toHaveLength(3);
    expect(copiesOf(document, ids)).toEqual([twice.part.components[2]!.id]);
    expect(new Set(twice.groups.map(({ id }) => id)).size).toBe(5);
  });
});
