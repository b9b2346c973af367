import { describe, expect, it } from 'vitest';
import { groupAt, groupsChosen, partsWith } from '../../src/document/chosen.ts';
import { apply } from '../../src/document/command/index.ts';
import { nodeOf } from '../../src/document/solidNode.ts';
import { figure, solidOf } from './figure.ts';

const document = figure();
const { part, groups } = solidOf(document);
const names = (ids: readonly string[]) => groupsChosen(document, ids).map(({ group }) => group.name);

describe('what is chosen', () => {
  it('of a solid or a component is all that is in it, of a group itself, whatever the order of the ids', () => {
    expect(names([part.id])).toEqual(['Body', 'Head', 'Ear', 'Eye']);
    expect(names([part.components[0]!.id])).toEqual(['Body', 'Head', 'Ear']);
    expect(names([groups[3]!.id, groups[1]!.id])).toEqual(['Head', 'Eye']);
    expect(names([])).toEqual([]);
  });

  it('is in these parts', () => {
    expect(partsWith(document, [groups[2]!.id])).toEqual([part]);
    expect(partsWith(document, [document.parts[1]!.id, part.components[1]!.id])).toEqual(document.parts);
    expect(partsWith(document, ['nothing'])).toEqual([]);
  });
});

/** Red of 0, 1, ½ and ¼ in sRGB, and in light. */
const COLOURS = ['#000000', '#ff0000', '#800000', '#400000'];
const RED = [0, 1, 0.2158, 0.0513];
describe('the group that a skel of the tree is of', () => {
  /** Skels have the colour of their group. */
  const painted = groups.reduce(
    (before, { id }, i) =>
      apply(before, { type: 'setPartBrush', ids: [id], change: { colour: COLOURS[i]! } }),
    document,
  );

  it.each([null, 0, 1, 2])('is found, with group %s hidden', (hidden) => {
    const ids = hidden === null ? [] : [groups[hidden]!.id];
    const shown = apply(painted, { type: 'showParts', ids, visible: false });
    const solid = solidOf(shown).part;
    const node = nodeOf(solid);
    if (node.type !== 'union') throw new Error('two components are a union');
    node.parts.forEach((sum, i) => {
      if (sum.type !== 'skels') throw new Error('a component is a sum');
      expect(sum.skels.length).toBeGreaterThan(0);
      sum.skels.forEach(({ colour }, k) => {
        const group = groupAt(solid, `parts[${i}].skels[${k}]`)!;
        const [r] = colour!;
        const place = COLOURS.indexOf(group.brush.colour);
        expect(r).toBeCloseTo(RED[place]!, 2);
        expect(group.hidden).toBe(false);
      });
      expect(groupAt(solid, `parts[${i}].skels[${sum.skels.length}]`)).toBeNull();
    });
  });

  it('has no part in its place where there is one component', () => {
    const ring = document.parts[1]!;
    if (ring.kind !== 'solid') throw new Error('the ring is a solid');
    expect(groupAt(ring, 'skels[0]')?.form).toBe('ring');
    expect(groupAt(ring, 'a.skels[0]')).toBeNull();
    expect(groupAt(ring, '')).toBeNull();
  });
});
