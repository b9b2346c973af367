/** What is said of an unfinished form: of what it is, and of what it joins. */
import { describe, expect, it } from 'vitest';
import { apply, type Command } from '../../src/document/command/index.ts';
import { type Document, EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { chipSize, formChoices } from '../../src/element/chip.ts';
import {
  awaitedBack,
  backsToDraw,
  droppedWords,
  fact,
  joinWord,
  keptWords,
  previewWords,
  shortName,
  startedOn,
} from '../../src/element/draftWords.ts';
import { strokeAlong } from '../document/strokes.ts';

const ring = (radius: number) =>
  strokeAlong((t) => [radius * Math.cos(6.2 * t), radius * Math.sin(6.2 * t)], { closed: true });
const LINE = strokeAlong((t) => [30 * t, 10 * t]);
const INTO = { solid: 'part-1', component: 'component-2' };

const after = (...commands: Command[]): Document => commands.reduce(apply, EMPTY_DOCUMENT);
const body: readonly Command[] = [{ type: 'addStroke', stroke: ring(40) }, { type: 'keep' }];

describe('an outline', () => {
  it('is a soft solid with so many holes, and may be something else', () => {
    const one = after({ type: 'addStroke', stroke: ring(40) });
    expect([previewWords(one), shortName(one), fact(one)]).toEqual([
      'Soft solid, preview',
      'Soft solid',
      '1 stroke',
    ]);
    expect(formChoices(one)).toEqual(['soft', 'plate', 'ring', 'tube']);
    const two = apply(one, { type: 'addStroke', stroke: ring(10) });
    expect(fact(two)).toBe('1 hole');
    const plate = apply(two, { type: 'setForm', form: 'plate' });
    expect([previewWords(plate), fact(plate)]).toEqual(['Plate, preview', '12 mm thick']);
    expect(keptWords(plate)).toBe('Plate added, part 1');
  });

  it('may carve, blend, sit on or stand beside what it starts on', () => {
    const joining = after(...body, { type: 'addStroke', stroke: ring(20), joins: INTO });
    expect(formChoices(joining)).toContain('carve');
    expect([previewWords(joining), fact(joining), joinWord(joining)]).toEqual([
      'Soft solid, preview. Joins Solid 1',
      'joins Solid 1',
      'blend',
    ]);
    expect(keptWords(joining)).toBe('Soft solid added to Solid 1');
    const sitting = apply(joining, { type: 'setForm', joins: { ...INTO, component: null } });
    expect([fact(sitting), joinWord(sitting)]).toEqual(['sits on Solid 1', 'attach']);
    expect(startedOn(sitting)!.joins).toEqual(INTO);
    const carving = apply(joining, { type: 'setForm', carves: true });
    expect(previewWords(carving)).toBe('Carving, preview. Takes away from Solid 1');
    expect(keptWords(carving)).toBe('Solid 1 carved');
    expect(joinWord(apply(joining, { type: 'setForm', joins: null }))).toBe('apart');
  });

  it('is what it starts on no more when that is hidden or gone', () => {
    const joining = after(...body, { type: 'addStroke', stroke: ring(20), joins: INTO });
    for (const command of [
      { type: 'removeParts', ids: ['part-1'] },
      { type: 'showParts', ids: ['part-1'], visible: false },
    ] as const) {
      const lone = apply(joining, command);
      expect(startedOn(lone)).toBeNull();
      expect(previewWords(lone)).toBe('Soft solid, preview');
    }
  });
});

it('an open stroke may be a line or a curve; two of them are sides of one form, and a point is a point', () => {
  const one = after({ type: 'addStroke', stroke: LINE });
  expect(formChoices(one)).toEqual(['tube', 'line', 'curve']);
  expect(fact(apply(one, { type: 'setForm', form: 'line' }))).toBe('6 mm radius');
  expect(formChoices(apply(one, { type: 'addStroke', stroke: LINE }))).toEqual([]);
  expect(formChoices(after({ type: 'addStroke', stroke: LINE, form: 'point' }))).toEqual([]);
});

it('the chip is as wide as its choices', () => {
  const widths = [after({ type: 'addStroke', stroke: LINE }), after({ type: 'addStroke', stroke: ring(9) })];
  const [line, outline] = widths.map((document) => chipSize(document, { width: 1200, height: 800 }));
  expect(outline!.width).toBeGreaterThan(line!.width);
  expect(chipSize(widths[1]!, { width: 800, height: 800 }).width).toBeLessThan(outline!.width);
});

describe('a surface with sections', () => {
  const side = (x: number) => strokeAlong((t) => [x, 60 * t]);
  const across = (y: number) => strokeAlong((t) => [-20 + 40 * t, y - 20 * t * (1 - t)]);
  const add = (u: number): Command => ({
    type: 'addSection',
    u,
    drawn: { stroke: across(60 * u), half: null },
  });
  const one = after(
    { type: 'addStroke', stroke: side(-20) },
    { type: 'addStroke', stroke: side(20) },
    add(0.58),
  );

  it('says where its one section is, or how many there are', () => {
    expect([previewWords(one), shortName(one), fact(one)]).toEqual([
      'Section surface, preview',
      'Section surface',
      'section at 58 %',
    ]);
    const two = apply(one, add(0.2));
    expect([previewWords(two), shortName(two), fact(two)]).toEqual([
      'Patch, preview, 2 sections',
      'Patch',
      '2 sections',
    ]);
    const back = apply(two, { type: 'setForm', form: 'rotational' });
    expect([shortName(back), fact(back)]).toEqual(['Rotational', '2 strokes']);
  });

  it('is a tube with sections where a side was taken away', () => {
    const less: Command = { type: 'setStroke', index: 1, stroke: null };
    const tube = apply(one, less);
    expect([previewWords(tube), shortName(tube)]).toEqual([
      'Tube with a section, preview',
      'Tube with a section',
    ]);
    expect(shortName(apply(apply(one, add(0.2)), less))).toBe('Tube with sections');
  });

  it('lacks a back of its own until that is drawn', () => {
    const lacking = ({ draft }: Document) =>
      backsToDraw({ sections: draft!.sections ?? [], back: draft!.back ?? 'none' });
    const drawn = apply(one, { type: 'setSurface', change: { back: 'drawn' } });
    expect([one, drawn, apply(drawn, add(0.2))].map(lacking)).toEqual([null, 'at 58 %', 'at 20 % or 58 %']);
    expect(lacking(apply(drawn, { ...add(0.58), side: 'back' } as Command))).toBeNull();
  });

  it('awaits a back right after its front, or when there shall be backs, and not for ever', () => {
    const set: Command = { type: 'setSurface', change: { back: 'drawn' } };
    const drawn = apply(one, set);
    const two = apply(drawn, add(0.2));
    expect(awaitedBack(drawn, [set])).toBe('at 58 %');
    expect(awaitedBack(two, [add(0.2)])).toBe('at 20 %');
    for (const other of [
      { ...add(0.58), side: 'back' },
      { type: 'removeSection', index: 0 },
      { type: 'setForm', form: 'rotational' },
    ] as Command[])
      expect(awaitedBack(apply(two, other), [other])).toBeNull();
    expect(awaitedBack(apply(one, add(0.2)), [add(0.2)])).toBeNull();
  });

  it('awaits the back of a section that took the place of one across the seam of a ring', () => {
    const drawn = { stroke: strokeAlong((t) => [36 + 8 * t, 9 * t * (1 - t)]), half: null };
    const at = (u: number): Command => ({ type: 'addSection', u, drawn });
    const rings = after(
      { type: 'addStroke', stroke: ring(40) },
      { type: 'setForm', form: 'tube' },
      { type: 'setSurface', change: { back: 'drawn' } },
      at(0.99),
      at(0.002),
      at(0.997),
    );
    expect(rings.draft!.sections!.map(({ u }) => u)).toEqual([0.002, 0.99]);
    expect(awaitedBack(rings, [at(0.997)])).toBe('at 0 %');
  });

  it('is called by its name while its strokes are in hand', () => {
    const kept = after(
      { type: 'addStroke', stroke: side(-20) },
      { type: 'addStroke', stroke: side(20) },
      { type: 'keep' },
      { type: 'renamePart', id: 'part-1', name: 'Leaf' },
      { type: 'recreate', id: 'part-1' },
    );
    expect([previewWords(kept), shortName(kept), fact(kept)]).toEqual([
      'Leaf, its strokes in hand',
      'Leaf',
      'its strokes in hand',
    ]);
    expect(keptWords(kept)).toBe('Leaf, as it is drawn now');
    expect(droppedWords(kept)).toBe('Leaf is as it was');
  });
});
