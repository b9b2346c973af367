import { describe, expect, it } from 'vitest';
import { apply } from '../../src/document/command/index.ts';
import { EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { dropAt } from '../../src/element/partDrag.ts';
import { factsOf, isHidden, madeOf, openedFor, rowsOf, toggled } from '../../src/element/partRows.ts';
import { figure, solidOf } from '../document/figure.ts';
import { strokeAlong } from '../document/strokes.ts';

const document = figure();
const { part, groups } = solidOf(document);
const [first, second] = part.components as [(typeof part.components)[0], (typeof part.components)[0]];
const NONE: ReadonlySet<string> = new Set();
const rows = (open: ReadonlySet<string>, of = document) => rowsOf(of.parts, open);
const shown = (open: ReadonlySet<string>) => rows(open).map(({ name, level }) => `${level} ${name}`);
const all = toggled(document, part.id, NONE);
const ring = document.parts[1]!;

describe('the rows of the list', () => {
  it('are the parts; of an open solid its components, where there are several, and their groups', () => {
    expect(shown(NONE)).toEqual([`1 ${part.name}`, `1 ${ring.name}`]);
    expect(shown(all)).toEqual([
      `1 ${part.name}`,
      `2 ${first.name}`,
      '3 Body',
      '3 Head',
      '3 Ear',
      `2 ${second.name}`,
      '3 Eye',
      `1 ${ring.name}`,
    ]);
    const two = toggled(document, ring.id, NONE);
    expect(shown(two).at(-1)).toMatch(/^2 Ring/);
  });

  it('say what they are in, where among its rows, and whether they are open', () => {
    const [solid, component, , head] = rows(all);
    expect(solid).toMatchObject({ at: 1, of: 2, parent: null, open: true });
    expect(component).toMatchObject({ at: 1, of: 2, parent: part.id, open: true });
    expect(head).toMatchObject({ at: 2, of: 3, parent: first.id, open: null });
    expect(rows(toggled(document, first.id, all)).map(({ name }) => name)).not.toContain('Head');
  });

  it('are the same while parts and what is open are', () => {
    expect(rows(all)).toBe(rows(all));
    expect(rowsOf([...document.parts], all)).not.toBe(rows(all));
  });

  it('tell what a form is and of how much: skels of soft ones, millimetres of others', () => {
    const found = rows(all);
    expect(factsOf(found[2]!)).toEqual(['Soft', expect.stringMatching(/^\d+ skels?$/)]);
    expect(factsOf(found[6]!)).toEqual(['Point', '6 mm']);
    const carved = apply(document, { type: 'setGroups', ids: [groups[2]!.id], change: { weight: -1 } });
    const row = rows(all, carved)[4]!;
    expect(row.icon).toBe('carve');
    expect(factsOf(row)).toContain('carves');
  });

  it('open for what is selected in them, and for nothing else', () => {
    expect(openedFor(document, [part.id], NONE)).toBe(NONE);
    expect([...openedFor(document, [groups[3]!.id], NONE)]).toEqual([part.id, second.id]);
    expect([...openedFor(document, [second.id], NONE)]).toEqual([part.id]);
    expect(openedFor(document, [groups[3]!.id], all)).toBe(all);
  });

  it('are hidden when nothing in them can be seen', () => {
    const hidden = apply(document, { type: 'showParts', ids: [groups[3]!.id], visible: false });
    expect(isHidden(hidden, [second.id])).toBe(true);
    expect(isHidden(hidden, [first.id, second.id])).toBe(false);
    expect(isHidden(hidden, [part.id])).toBe(false);
  });
});

describe('a drop', () => {
  const drop = (name: string, row: string, at: number) => {
    const list = rows(all);
    const id = list.find((each) => each.name === name)!.id;
    const index = list.findIndex((each) => each.name === row);
    return dropAt(document, list, [id], (index < 0 ? list.length : index) + at);
  };

  it('on a form or a component blends with it', () => {
    const to = { solid: part.id, component: first.id };
    expect(drop('Eye', 'Head', 0.1)).toMatchObject({ side: 'on', to, words: 'Blend with Head' });
    expect(drop('Eye', first.name, 0.9)).toMatchObject({ to });
    expect(drop(ring.name, 'Body', 0.5)).toMatchObject({ to });
  });

  it('on a solid attaches, between parts makes a solid of its own', () => {
    expect(drop('Ear', part.name, 0.5)?.to).toEqual({ solid: part.id, component: null });
    expect(drop('Ear', ring.name, 0.5)?.to).toEqual({ solid: ring.id, component: null });
    expect(drop('Ear', ring.name, 0.1)).toMatchObject({ side: 'before', to: null, words: 'On its own' });
    expect(drop('Ear', ring.name, 0.9)).toMatchObject({ side: 'after', to: null });
    expect(drop('Ear', '', 3)).toMatchObject({ id: ring.id, side: 'after', to: null });
  });

  it('that would change nothing is none', () => {
    expect(drop('Head', 'Body', 0.5)).toBeNull();
    expect(drop('Eye', part.name, 0.5)).toBeNull();
    expect(drop(ring.name, '', 1)).toBeNull();
    expect(drop(ring.name, ring.name, 0.5)).toBeNull();
    for (const [row, at] of [
      [part.name, 0.1],
      [part.name, 0.5],
      [first.name, 0.5],
      [ring.name, 0.1],
      ['', 3],
    ] as const)
      expect(drop(part.name, row, at), `a solid of two components on ${row}`).toBeNull();
  });
});

describe('what a surface is made of', () => {
  it('are the strokes that are numbered when they are in hand again: bends are none of them', () => {
    const side = (x: number) => strokeAlong((t) => [x, 60 * t - 30]);
    const kept = apply(
      apply(apply(EMPTY_DOCUMENT, { type: 'addStroke', stroke: side(-20) }), {
        type: 'addStroke',
        stroke: side(20),
      }),
      { type: 'keep' },
    );
    const stroke = strokeAlong((t) => [10 * Math.sin(Math.PI * t), 60 * t - 30]);
    const bent = apply(kept, {
      type: 'bend',
      id: 'part-1',
      bend: { stroke, keepsLength: true, isOff: false },
    });
    expect(bent.parts[0]).toMatchObject({ bends: [{}] });
    expect(madeOf(bent.parts[0]!)).toBe('2 strokes');
    const { draft } = apply(bent, { type: 'recreate', id: 'part-1' });
    expect(draft!.strokes).toHaveLength(2);
  });
});
