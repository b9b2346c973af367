import { describe, expect, it } from 'vitest';
import { groupsChosen } from '../../src/document/chosen.ts';
import { apply } from '../../src/document/command/index.ts';
import { formsOf, placesFor } from '../../src/element/groupCard.ts';
import { figure, solidOf } from '../document/figure.ts';

const document = figure();
const { part, groups } = solidOf(document);
const ring = document.parts[1]!;
const places = (...ids: readonly string[]) => placesFor(document, groupsChosen(document, ids));

describe('where forms can go', () => {
  it('is told of other components to blend with, solids to be attached to, and none', () => {
    const [, , ear] = groups;
    expect(places(ear!.id).map(({ words }) => words)).toEqual([
      `Blend with ${part.components[1]!.name} of ${part.name}`,
      `Blend with ${ring.name}`,
      `Attach to ${part.name}`,
      `Attach to ${ring.name}`,
      'On its own',
    ]);
  });

  it('is never where they are: each place changes the document', () => {
    for (const ids of [
      [groups[0]!.id],
      [groups[3]!.id],
      [part.id],
      [ring.id],
      [groups[1]!.id, groups[3]!.id],
    ]) {
      const chosen = groupsChosen(document, ids).map(({ group }) => group.id);
      const found = places(...ids);
      expect(found.length).toBeGreaterThan(0);
      for (const { to, words } of found)
        expect(apply(document, { type: 'moveGroups', ids: chosen, to }), words).not.toBe(document);
    }
  });

  it('is not on its own for all of a solid', () => {
    expect(places(ring.id).map(({ to }) => to)).not.toContain(null);
    expect(places(part.id).map(({ to }) => to)).not.toContain(null);
  });
});

describe('what forms can become', () => {
  it('depends on whether their stroke is closed; what they are is always among it', () => {
    expect(formsOf(groups[0]!)).toEqual(['soft', 'plate', 'ring', 'line']);
    expect(formsOf(groups[3]!)).toContain('point');
    const open = { ...groups[0]!, strokes: groups[0]!.strokes.map((s) => ({ ...s, closed: false })) };
    expect(formsOf(open)).toEqual(['line', 'curve', 'soft']);
  });
});
