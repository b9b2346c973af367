/** Sections, backs, bends and strokes in hand: what commands make of them, and what is derived. */
import { describe, expect, it } from 'vitest';
import { buildForm, draftSolids, shapeOf, solids } from '../../src/document/build.ts';
import { apply, type Command, describe as sayCommand } from '../../src/document/command/index.ts';
import {
  DEFAULT_BRUSH,
  type Document,
  EMPTY_DOCUMENT,
  readingOf,
  type SurfacePart,
} from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { parse, serialize } from '../../src/document/serialize.ts';
import { quadsOf, sheetOf } from '../../src/document/sheets.ts';
import { DEFAULT_DETAIL, PLAIN, type SurfaceForm } from '../../src/document/surfacePart.ts';
import { place3 } from '../../src/math/placement.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { topology } from '../../src/mesh/check.ts';
import { bounds, volume } from '../../src/mesh/measure.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { Plane, Stroke } from '../../src/stroke/stroke.ts';
import { circle, strokeAlong } from './strokes.ts';

const after = (commands: readonly Command[], from = EMPTY_DOCUMENT): Document => commands.reduce(apply, from);
const add = (stroke: Stroke): Command => ({ type: 'addStroke', stroke });
const KEEP: Command = { type: 'keep' };
/** Drawn upwards, so that the left one is left. */
const line = (x: number) => strokeAlong((t) => [x, 60 * t - 30]);
const SIDES: readonly Command[] = [add(line(-10)), add(line(10))];
/** Across from one side to the other; below (dip > 0) is towards the viewer. */
const across = (dip: number, way: 1 | -1 = 1, y = 0) =>
  strokeAlong((t) => [way * (20 * t - 10), y - 4 * dip * t * (1 - t)]);
const section = (u: number, stroke = across(6)): Command => ({
  type: 'addSection',
  u,
  drawn: { stroke, half: null },
});
const SIDE: Plane = { origin: [0, 0, 0], x: [0, 0, -1], y: [0, 1, 0] };
const BEND = {
  stroke: strokeAlong((t) => [20 * t * t, 30 - 60 * t], { plane: SIDE }),
  keepsLength: true,
  isOff: false,
} as const;
const bump = { half: 10, stroke: strokeAlong((t) => [10 * t - 5, 9 + 6 * t * (1 - t)]) } as const;
const MOVE: Command = {
  type: 'moveParts',
  ids: ['part-1'],
  by: { rotation: [0.48, 0.6, 0, 0.64], translation: [3, -7, 11] },
};

const partOf = ({ parts }: Document, id = 'part-1') => parts.find((part) => part.id === id) as SurfacePart;
const sectionsOf = (document: Document) => partOf(document).sections.map(({ u }) => u);
const kindAfter = (commands: readonly Command[]) => partOf(after([...commands, KEEP])).kind;
const meshOf = (document: Document): Mesh => solids(document)[0]!.mesh;
const back = (to: 'none' | 'front' | 'drawn'): Command => ({ type: 'setSurface', change: { back: to } });

describe('the number of strokes decides', () => {
  it('what a form is, and what it is kept as', () => {
    expect(kindAfter([add(line(0))])).toBe('tube');
    expect(kindAfter(SIDES)).toBe('rotational');
    expect(kindAfter([...SIDES, section(0.5)])).toBe('crossSection');
    expect(kindAfter([...SIDES, section(0.5), section(0.9)])).toBe('bspline');
    expect(kindAfter([add(line(0)), section(0.5)])).toBe('crossSection');
  });

  it('unless a person steps back, and no stroke is lost', () => {
    const patch = after([...SIDES, section(0.2), section(0.7)]);
    for (const form of ['tube', 'rotational', 'crossSection'] as const) {
      const stepped = after([{ type: 'setForm', form }], patch);
      expect(readingOf(stepped)).toBe(form);
      expect(stepped.draft!.sections).toBe(patch.draft!.sections);
      expect(readingOf(after([section(0.5)], stepped))).toBe('bspline');
      expect(readingOf(after([{ type: 'removeSection', index: 0 }], stepped))).toBe(form);
    }
    const tube = after([add(line(0)), section(0.5), { type: 'setForm', form: 'rotational' }]);
    expect(readingOf(tube)).toBe('tube');
  });

  it('what makes a surface of strokes that stay tubes is seen at once; strokes in hand leave the others tubes', () => {
    const on: Command = { type: 'setTubesOnly', on: true };
    const redraw: Command = { type: 'redrawSection', u: 0.5, drawn: bump };
    for (const more of [section(0.5), redraw]) {
      const seen = after([on, add(line(0)), more]);
      expect(readingOf(seen)).toBe('crossSection');
      expect(seen.tubesOnly).toBe(false);
      const inHand = after([add(line(0)), KEEP, on, { type: 'recreate', id: 'part-1' }, more]);
      expect(readingOf(inHand)).toBe('crossSection');
      expect(inHand.tubesOnly).toBe(true);
    }
  });

  it('tubes take nothing that was drawn across several; a single one keeps its own, and all are as fine as was said', () => {
    const detail = { ...DEFAULT_DETAIL, columns: 8 };
    const set: Command = { type: 'setSurface', change: { back: 'front', detail } };
    const stepped: Command = { type: 'setForm', form: 'tube' };
    const pair = after([...SIDES, section(0.5), set, stepped]);
    const kept = after([KEEP], pair);
    for (const id of ['part-1', 'part-2'])
      expect(partOf(kept, id)).toMatchObject({ ...PLAIN, kind: 'tube', detail });
    expect(solids(kept).map(({ mesh }) => mesh)).toEqual(draftSolids(pair).map(({ mesh }) => mesh));
    const single = after([add(line(0)), section(0.5), set, stepped]);
    const tube = after([KEEP], single);
    expect(partOf(tube)).toMatchObject({ kind: 'tube', sections: single.draft!.sections, back: 'front' });
    expect(meshOf(tube)).toEqual(draftSolids(single)[0]!.mesh);
  });

  it('of parts, too', () => {
    const kept = after([...SIDES, KEEP]);
    const one = after([{ ...section(0.5), part: 'part-1' } as Command], kept);
    const two = after([{ ...section(0.2), part: 'part-1' } as Command], one);
    expect([partOf(kept).kind, partOf(one).kind, partOf(two).kind]).toEqual([
      'rotational',
      'crossSection',
      'bspline',
    ]);
    const less = after([{ type: 'setStroke', part: 'part-1', index: 0, stroke: null }], two);
    expect(partOf(less)).toMatchObject({ kind: 'bspline', strokes: [partOf(two).strokes[1]] });
    expect(after([{ type: 'setStroke', part: 'part-1', index: 0, stroke: null }], less)).toBe(less);
  });
});

describe('sections', () => {
  it('are in order, and one takes the place of another that is there', () => {
    const document = after([...SIDES, section(0.7), section(0.2), section(0.705, across(3)), KEEP]);
    expect(sectionsOf(document)).toEqual([0.2, 0.705]);
    expect(partOf(document).sections[1]!.front!.stroke).toEqual(across(3));
  });

  it('take the place of the nearest one alone, and stand apart from the others', () => {
    const behind = { stroke: across(-3), half: null };
    const two = [section(0.495), section(0.506, across(4)), back('drawn')];
    const both = after([...SIDES, ...two, { type: 'addSection', u: 0.506, side: 'back', drawn: behind }]);
    const { sections } = after([section(0.502, across(8))], both).draft!;
    expect(sections!.map(({ u }) => u)).toEqual([0.495, 0.506]);
    expect(sections![0]).toBe(both.draft!.sections![0]);
    expect(sections![1]).toMatchObject({ front: { stroke: across(8) }, back: behind });
  });

  it('keep the back of the one whose place they take', () => {
    const behind = { stroke: across(-3), half: null };
    const both = after([...SIDES, section(0.5), { type: 'addSection', u: 0.5, side: 'back', drawn: behind }]);
    const [again] = after([section(0.502, across(8))], both).draft!.sections!;
    expect(again!.u).toBe(0.502);
    expect(again!.back).toBe(both.draft!.sections![0]!.back);
  });

  it('get a back where it is nearest', () => {
    const behind = {
      type: 'addSection',
      u: 0.6,
      side: 'back',
      drawn: { stroke: across(-4), half: null },
    } as const;
    const document = after([...SIDES, section(0.2), section(0.7), behind, KEEP]);
    expect(partOf(document).sections.map((each) => each.back !== null)).toEqual([false, true]);
    expect(partOf(document).back).toBe('drawn');
    const alone = after([...SIDES, behind, KEEP]);
    expect(partOf(alone).sections).toMatchObject([{ u: 0.6, front: null }]);
  });

  it('lie on the plane of the strokes, or nothing happens', () => {
    const far: Plane = { origin: [0, 0, 5], x: [1, 0, 0], y: [0, 1, 0] };
    const drawn = after(SIDES);
    expect(after([section(0.5, { ...across(6), plane: far })], drawn)).toBe(drawn);
    const whole = after([section(0.5)], drawn);
    expect(after([{ type: 'setStroke', index: 0, stroke: { ...line(-12), plane: far } }], whole)).toBe(whole);
    expect(after([{ type: 'setStroke', index: 0, stroke: { ...line(-12), closed: true } }], whole)).toBe(
      whole,
    );
  });

  it.each<Command>([section(0.5), { type: 'redrawSection', u: 0.5, drawn: bump }, back('front')])(
    'are nothing to solids and bodies: $type',
    (command) => {
      const solid = after([add(circle(20))]);
      expect(apply(solid, command)).toBe(solid);
      const node = { type: 'shape', shape: { type: 'sphere', radius: 5 } } as const;
      const kept = after([KEEP, { type: 'addBody', node }], solid);
      for (const { id } of kept.parts) {
        const { ids: _, ...rest } = { ids: null, ...command };
        const on = command.type === 'setSurface' ? { ...rest, ids: [id] } : { ...rest, part: id };
        expect(apply(kept, on as Command)).toBe(kept);
        expect(apply(kept, { type: 'bend', id, bend: BEND })).toBe(kept);
        expect(apply(kept, { type: 'recreate', id })).toBe(kept);
      }
    },
  );

  it('go one by one: back, redrawing, all of it', () => {
    const drawn = after([
      ...SIDES,
      section(0.5),
      { type: 'redrawSection', u: 0.5, drawn: bump },
      { type: 'addSection', u: 0.5, side: 'back', drawn: { stroke: across(-2), half: null } },
    ]);
    const less = after([{ type: 'removeSection', index: 0, only: 'back' }], drawn);
    expect(less.draft!.sections![0]!.back).toBeNull();
    const least = after([{ type: 'removeSection', index: 0, only: 'redraw' }], less);
    expect(least.draft!.sections![0]!.redraws).toEqual([]);
    expect(after([{ type: 'removeSection', index: 0, only: 'redraw' }], least)).toBe(least);
    expect(after([{ type: 'removeSection', index: 0, only: 'redraw', redraw: 1 }], less)).toBe(less);
    // whoever says which of those drawn over it does not mean the section, nor its back
    expect(after([{ type: 'removeSection', index: 0, redraw: 0 }], less)).toBe(less);
    expect(after([{ type: 'removeSection', index: 0, only: 'back', redraw: 0 }], drawn)).toBe(drawn);
    const none = after([{ type: 'removeSection', index: 0 }], least);
    expect(readingOf(none)).toBe('rotational');
    expect(none.draft!.sections).toBeUndefined();
  });
});

describe('redrawing', () => {
  it('makes round forms and tubes surfaces of that section, closed all round', () => {
    for (const strokes of [SIDES, [add(line(0))]]) {
      const document = after([
        ...strokes,
        KEEP,
        { type: 'redrawSection', part: 'part-1', u: 0.4, drawn: bump },
      ]);
      const { kind, back, sections } = partOf(document);
      expect({ kind, back, sections }).toEqual({
        kind: 'crossSection',
        back: 'front',
        sections: [{ u: 0.4, front: null, back: null, redraws: [bump] }],
      });
    }
  });

  const PAIR = [...SIDES, section(0.2), section(0.6)] as const;
  const redraw = { type: 'redrawSection', u: 0.4, drawn: bump } as const;

  it('of one section of several is that one’s; the others wait', () => {
    const stepped = after([...PAIR, { type: 'setForm', form: 'crossSection' }]);
    const [first, second] = stepped.draft!.sections!;
    const sections = [first, { ...second, redraws: [bump] }];
    // nearer to the first, which is not seen
    const inHand = after([{ ...redraw, u: 0.25 }], stepped);
    expect(readingOf(inHand)).toBe('crossSection');
    expect(inHand.draft!.sections).toEqual(sections);
    const kept = after([KEEP, { ...redraw, u: 0.25, part: 'part-1' }], stepped);
    expect(partOf(kept)).toMatchObject({ kind: 'crossSection', sections });
  });

  it('of a round form that a person stepped back to is one more section, and none is lost', () => {
    for (const form of ['rotational', 'tube'] as const) {
      const stepped = after([...PAIR, { type: 'setForm', form }]);
      const [first, second] = stepped.draft!.sections!;
      const inHand = after([redraw], stepped);
      expect(readingOf(inHand)).toBe('bspline');
      expect(inHand.draft!.back).toBe('front');
      const round = { u: 0.4, front: null, back: null, redraws: [bump] };
      expect(inHand.draft!.sections).toEqual([first, round, second]);
      const there = after([{ ...redraw, u: 0.6 }], stepped);
      expect(there.draft!.sections).toEqual([first, { ...second, redraws: [bump] }]);
    }
  });

  it('here only: the surface stays as it was at its ends', () => {
    const before = after([...SIDES, KEEP]);
    const document = after(
      [{ type: 'redrawSection', part: 'part-1', u: 0.5, drawn: bump, local: true }],
      before,
    );
    expect(partOf(document)).toMatchObject({ kind: 'bspline', back: 'front' });
    expect(sectionsOf(document)).toEqual([0, 0.5, 1]);
    const { min, max } = bounds(meshOf(document));
    // the bump is 1.5 above 9 in its middle
    expect(max[2]).toBeGreaterThan(10.3);
    expect(min[2]).toBeCloseTo(-10, 1);
    const mesh = meshOf(document);
    const atEnds = range(mesh).filter(([, y]) => Math.abs(y) > 29.9);
    for (const [x, , z] of atEnds) expect(Math.hypot(x, z)).toBeLessThan(10.01);
    expect(topology(mesh)).toMatchObject({ watertight: true, finite: true });
    const again = after(
      [{ type: 'redrawSection', part: 'part-1', u: 0.25, drawn: bump, local: true }],
      document,
    );
    expect(sectionsOf(again)).toEqual([0, 0.25, 0.5, 1]);
    expect(partOf(again).sections[1]).toMatchObject({ follows: true, redraws: [bump] });
  });
});

describe('strokes in hand', () => {
  const PATCH = [...SIDES, section(0.2), section(0.7), back('front'), KEEP, MOVE] as const;
  const kept = after([...PATCH, { type: 'bend', id: 'part-1', bend: BEND }]);
  const hand = after([{ type: 'recreate', id: 'part-1' }], kept);

  it('are where the part is, which is not seen twice', () => {
    expect(readingOf(hand)).toBe('bspline');
    expect(solids(hand)).toEqual([]);
    const own = buildForm('bspline', { ...partOf(kept), bends: [] }, DEFAULT_BRUSH)!;
    const placed = range(own).map((p) => place3(partOf(kept).placement, p));
    expectNear(range(draftSolids(hand)[0]!.mesh), placed, 1e-4);
  });

  it('come back to an equal part, and leave all as it was', () => {
    expect(after([KEEP], hand)).toEqual(kept);
    expect(after([{ type: 'drop' }], hand)).toEqual(kept);
    const { document } = parse(serialize({ ...EMPTY_DRAWING, document: hand }), 'x');
    expect(after([KEEP], document)).toEqual(kept);
  });

  it('are changed in their place, and a file can hold it', () => {
    const plane = hand.draft!.strokes[0]!.plane;
    const more = after(
      [section(0.9, { ...across(2), plane }), { type: 'setBrush', change: { radius: 9 } }, KEEP],
      hand,
    );
    expect(sectionsOf(more)).toEqual([0.2, 0.7, 0.9]);
    expect(more.brush).toEqual(kept.brush);
    expect(partOf(more)).toMatchObject({ brush: { radius: 9 }, bends: partOf(kept).bends, name: 'Patch 1' });
    expect(parse(serialize({ ...EMPTY_DRAWING, document: more }), 'x').document).toEqual(more);
  });

  const THERE: readonly Command[] = [
    MOVE,
    { type: 'scaleParts', ids: ['part-1'], factor: 1.5, about: [4, 5, 6] },
    { type: 'mirrorParts', ids: ['part-1'], about: [1, 2, 3], normal: [0.48, 0.6, 0.64] },
  ];
  it.each(THERE)('go where their part goes, with what was drawn and the bends: $type', (there) => {
    const plane = hand.draft!.strokes[0]!.plane;
    const more = [
      section(0.9, { ...across(2), plane }),
      { type: 'setBrush', change: { radius: 9 } },
    ] as const;
    const wanted = after([...more, KEEP, there], hand);
    const found = after([...more, there, KEEP], hand);
    expectNear(range(meshOf(found)), range(meshOf(wanted)), 1e-4);
    expect(partOf(found).bends).toEqual(partOf(wanted).bends);
    expect(after([there, KEEP], hand)).toEqual(after([there], kept));
    expect(after([there, { type: 'drop' }], hand)).toEqual(after([there], kept));
  });

  it('are of the kind the part was, whatever strokes become now', () => {
    const tubes = after([...SIDES, KEEP, { type: 'setTubesOnly', on: true }]);
    expect(readingOf(after([{ type: 'recreate', id: 'part-1' }], tubes))).toBe('rotational');
    expect(after([{ type: 'recreate', id: 'part-1' }, KEEP], tubes)).toEqual(tubes);
    const ring = after([{ ...add(circle(20)), form: 'tube' } as Command, KEEP]);
    expect(after([{ type: 'recreate', id: 'part-1' }, KEEP], ring)).toEqual(ring);
  });

  it('take what is set of their part, and give it back', () => {
    const inHand = after([...SIDES, section(0.5), KEEP, { type: 'recreate', id: 'part-1' }]);
    const ids = ['part-1'];
    const set = after(
      [
        { type: 'setPartBrush', ids, change: { colour: '#ff0000', finish: { ambient: 0.5 } } },
        { type: 'setSurface', ids, change: { back: 'front', detail: { columns: 8 } } },
      ],
      inHand,
    );
    expect(draftSolids(set)[0]!.colour).toBe('#ff0000');
    expect(topology(draftSolids(set)[0]!.mesh).watertight).toBe(true);
    const kept = after([KEEP], set);
    const { brush, back: behind, detail } = partOf(kept);
    expect([brush.colour, brush.finish.ambient, behind, detail.columns]).toEqual([
      '#ff0000',
      0.5,
      'front',
      8,
    ]);
    expect(kept.brush).toBe(DEFAULT_BRUSH);
  });

  it('go with their part, and the brush comes back', () => {
    const colour = '#123456';
    const red = after(
      [
        { type: 'setBrush', change: { colour } },
        { type: 'recreate', id: 'part-1' },
      ],
      kept,
    );
    expect(red.brush.colour).not.toBe(colour);
    for (const gone of [
      { type: 'removeParts', ids: ['part-1'] },
      { type: 'removeLast' },
      { type: 'removeAll' },
    ] as const)
      expect(apply(red, gone)).toMatchObject({ parts: [], draft: null, brush: { colour } });
  });

  it('may become a solid in the place of the part', () => {
    const tube = after([add(line(0)), KEEP, { type: 'recreate', id: 'part-1' }]);
    const solid = after([{ type: 'setForm', form: 'line' }, KEEP], tube);
    expect(solid.parts).toMatchObject([{ id: 'part-1', kind: 'solid', name: 'Tube 1' }]);
  });

  it('as several tubes are the part and others beside it', () => {
    const two = after([{ type: 'setForm', form: 'tube' }, KEEP], hand);
    expect(two.parts.map(({ id, kind }) => [id, kind])).toEqual([
      ['part-1', 'tube'],
      ['part-2', 'tube'],
    ]);
    expect(two.nextId).toBe(3);
  });
});

describe('what is derived', () => {
  const form = (change: Partial<SurfaceForm>): SurfaceForm => ({
    ...PLAIN,
    strokes: [line(-10), line(10)],
    ...change,
  });
  const drawn = (stroke: Stroke) => ({ stroke, half: null });
  const one = (stroke: Stroke) => [{ u: 0.5, front: drawn(stroke), back: null, redraws: [] }];
  const mesh = (change: Partial<SurfaceForm>, kind: SurfacePart['kind'] = 'crossSection') =>
    buildForm(kind, form(change), DEFAULT_BRUSH)!;

  it('is flat from a straight section', () => {
    const { min, max } = bounds(mesh({ sections: one(across(0)) }));
    expect(Math.max(Math.abs(min[2]), Math.abs(max[2]))).toBeLessThan(1e-9);
  });

  it('comes out to the viewer from a section below the chord, in whichever direction it was drawn', () => {
    const full = bounds(mesh({ sections: one(across(6)) }));
    expect(full.max[2]).toBeCloseTo(6, 1);
    expect(full.min[2]).toBeGreaterThan(-0.01);
    expectNear(
      range(mesh({ sections: one(across(6, -1)) })),
      range(mesh({ sections: one(across(6)) })),
      1e-3,
    );
    expect(bounds(mesh({ sections: one(across(-6)) })).min[2]).toBeCloseTo(-6, 1);
  });

  it('is closed by a back, its own or the front’s', () => {
    const sections = one(across(6));
    const mirrored = mesh({ sections, back: 'front' });
    expect(topology(mirrored)).toMatchObject({ watertight: true });
    // a parabola of height 6 over a chord of 20, twice, 60 long
    expect(volume(mirrored) / (2 * (2 / 3) * 6 * 20 * 60)).toBeCloseTo(1, 1);
    const own = [{ ...sections[0]!, back: drawn(across(-2)) }];
    const whole = mesh({ sections: own, back: 'drawn' });
    expect(topology(whole)).toMatchObject({ watertight: true });
    expect(bounds(whole).min[2]).toBeCloseTo(-2, 1);
    expect(topology(mesh({ sections })).watertight).toBe(false);
  });

  it('is larger by as much as its section is higher', () => {
    const of = (dip: number) => volume(mesh({ sections: one(across(dip)), back: 'front' }));
    expect(of(9) / of(6)).toBeCloseTo(1.5, 3);
  });

  it('keeps half chords: a section on its own plane is as large as it was drawn', () => {
    const front = { half: 10, stroke: strokeAlong((t) => [20 * t - 10, 4 * 5 * t * (1 - t)]) };
    const { max } = bounds(mesh({ sections: [{ u: 0.5, front, back: null, redraws: [] }] }));
    expect(max[2]).toBeCloseTo(5, 1);
  });

  it('follows bends, but for those that are off', () => {
    const straight = mesh({}, 'rotational');
    const bent = mesh({ bends: [BEND] }, 'rotational');
    expect(bounds(bent).min[2]).toBeLessThan(bounds(straight).min[2] - 10);
    expect(mesh({ bends: [{ ...BEND, isOff: true }] }, 'rotational')).toEqual(straight);
  });

  it('is as fine as it says, or as the caller says', () => {
    const detail = { rows: 8, columns: 6, u: 1, v: 2 };
    expect(quadsOf(detail)).toEqual({ u: 16, v: 24 });
    expect(quadsOf(DEFAULT_DETAIL)).toEqual({ u: 64, v: 64 });
    const sections = [...one(across(6)), { u: 0.9, front: drawn(across(2)), back: null, redraws: [] }];
    const of = (change: Partial<SurfaceForm>, resolution: { u: number; v: number } | null = null) =>
      buildForm('bspline', form({ sections, ...change }), DEFAULT_BRUSH, resolution)!.indices.length / 6;
    expect(of({ detail: { ...detail, u: 2 } })).toBeGreaterThan(1.9 * of({ detail }));
    expect(of({ detail }, { u: 60, v: 90 })).toBeGreaterThanOrEqual(60 * 90);
    // no more than there is room for
    expect(quadsOf({ rows: 256, columns: 256, u: 5, v: 5 })).toEqual({ u: 512, v: 512 });
  });

  it('is finer or coarser by a step from where each surface is, as far as it goes', () => {
    const detail = (u: number, v: number, ids: readonly string[]): Command => ({
      type: 'setSurface',
      ids,
      change: { detail: { u, v } },
    });
    const two = after([...SIDES, KEEP, add(line(40)), KEEP]);
    const apart = after([detail(1, 4, ['part-1']), detail(5, 0, ['part-2'])], two);
    const ids = ['part-1', 'part-2'];
    const by = (finer: number): Command => ({ type: 'setSurface', ids, change: { detail: { finer } } });
    const found = (document: Document) =>
      ids.map((id) => [partOf(document, id).detail.u, partOf(document, id).detail.v]);
    expect(found(after([by(1)], apart))).toEqual([
      [2, 5],
      [5, 1],
    ]);
    expect(found(after([by(-1)], apart))).toEqual([
      [0, 3],
      [4, 0],
    ]);
    const finest = after([by(5)], apart);
    expect(after([by(1)], finest)).toBe(finest);
  });

  it('is found again by reference: a part that is moved, named or coloured is not made anew', () => {
    const document = after([...SIDES, section(0.2), section(0.7), KEEP]);
    const shape = shapeOf(partOf(document));
    const moved = after(
      [MOVE, { type: 'setPartBrush', ids: ['part-1'], change: { colour: '#112233' } }],
      document,
    );
    expect(shapeOf(partOf(moved))).toBe(shape);
    const sheet = sheetOf('bspline', partOf(document), DEFAULT_BRUSH);
    expect(sheetOf('bspline', partOf(moved), partOf(moved).brush)).toBe(sheet);
  });
});

describe('copies', () => {
  const behind = {
    type: 'addSection',
    u: 0.4,
    side: 'back',
    drawn: { stroke: across(-2), half: null },
  } as const;
  const kinds: readonly (readonly [string, readonly Command[]])[] = [
    ['a section without a back, hollow', [...SIDES, section(0.5, across(-6)), KEEP]],
    ['a back of its own', [...SIDES, section(0.5, skew(6)), behind, KEEP]],
    [
      'a tube that was redrawn',
      [add(line(5)), KEEP, { type: 'redrawSection', part: 'part-1', u: 0.4, drawn: bump }],
    ],
    ['a patch', [...SIDES, section(0.1, skew(6)), section(0.8, across(-3)), KEEP]],
    ['a bent one', [...SIDES, section(0.5), KEEP, { type: 'bend', id: 'part-1', bend: BEND }]],
    [
      'a ring',
      [
        { ...add(circle(30)), form: 'rotational' } as Command,
        add(circle(20)),
        section(
          0,
          strokeAlong((t) => [30 - 10 * t, -8 * t * (1 - t) * (1 + t)]),
        ),
        KEEP,
      ],
    ],
  ];
  const mirror = { about: [1, 2, 3], normal: [0.48, 0.6, 0.64] } as const;
  const over = (p: Vec3): Vec3 => {
    const far = p.reduce((sum, x, i) => sum + (x - mirror.about[i]!) * mirror.normal[i]!, 0);
    return p.map((x, i) => x - 2 * far * mirror.normal[i]!) as unknown as Vec3;
  };

  it.each(kinds)('are as a mirror shows them: %s', (_, commands) => {
    const document = after([...commands, MOVE]);
    const mirrored = after([{ type: 'mirrorParts', ids: ['part-1'], ...mirror }], document);
    expectSamePlaces(range(meshOf(mirrored)), range(meshOf(document)).map(over), 2e-3);
    expect(parse(serialize({ ...EMPTY_DRAWING, document: mirrored }), 'x').document).toEqual(mirrored);
  });

  it.each(kinds)('are larger: %s', (_, commands) => {
    const document = after([...commands, MOVE]);
    const scaled = after([{ type: 'scaleParts', ids: ['part-1'], factor: 2, about: [0, 0, 0] }], document);
    const doubled = range(meshOf(document)).map(([x, y, z]): Vec3 => [2 * x, 2 * y, 2 * z]);
    expectNear(range(meshOf(scaled)), doubled, 1e-3);
  });

  it('share strokes, sections and bends with the original', () => {
    const document = after([...kinds[4]![1], { type: 'duplicateParts', ids: ['part-1'], offset: [9, 0, 0] }]);
    const [one, two] = document.parts as [SurfacePart, SurfacePart];
    expect(two.sections).toBe(one.sections);
    expect(two.bends).toBe(one.bends);
    const pasted = after([{ type: 'paste', parts: [one], offset: [0, 0, 0] }], document);
    expect(partOf(pasted, 'part-3')).toEqual({ ...one, id: 'part-3', name: 'Section 3' });
  });
});

/** No two points of it alike: its mirror image is another. */
function skew(dip: number): Stroke {
  return strokeAlong((t) => [20 * t - 10, -4 * dip * t * (1 - t) * (0.5 + t)]);
}

function range({ positions }: Mesh): Vec3[] {
  return Array.from(
    { length: positions.length / 3 },
    (_, i): Vec3 => [positions[3 * i]!, positions[3 * i + 1]!, positions[3 * i + 2]!],
  );
}

function expectNear(found: readonly Vec3[], wanted: readonly Vec3[], within: number): void {
  expect(found.length).toBe(wanted.length);
  const most = Math.max(...found.map((p, i) => Math.hypot(...p.map((x, k) => x - wanted[i]![k]!))));
  expect(most).toBeLessThan(within);
}

/** In whichever order. */
function expectSamePlaces(found: readonly Vec3[], wanted: readonly Vec3[], within: number): void {
  const away = (p: Vec3, among: readonly Vec3[]) =>
    Math.min(...among.map((q) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2])));
  for (let i = 0; i < found.length; i += 97) expect(away(found[i]!, wanted)).toBeLessThan(within);
  for (let i = 0; i < wanted.length; i += 97) expect(away(wanted[i]!, found)).toBeLessThan(within);
}

it('says which section was redrawn: the one there is, wherever it was drawn', () => {
  const once = after([
    { type: 'addStroke', stroke: line(-10) },
    { type: 'addStroke', stroke: line(10) },
    { type: 'redrawSection', u: 0.61, drawn: bump },
  ]);
  const [first] = once.draft!.sections!;
  expect(sayCommand(once, { type: 'redrawSection', u: 0.55, drawn: bump })).toBe(
    `section at ${Math.round(100 * first!.u)} % redrawn`,
  );
});

describe('sections of a ring', () => {
  const ring = strokeAlong((t) => [40 * Math.sin(2 * Math.PI * t), 40 * Math.cos(2 * Math.PI * t)], {
    closed: true,
  });
  const drawn = (depth: number) => ({
    stroke: strokeAlong((t) => [36 + 8 * t, depth * t * (1 - t)], { plane: ring.plane }),
    half: null,
  });

  it.each([
    [0, 0.995],
    [0.995, 0],
  ])('are one place across the seam: %f, then %f', (first, second) => {
    const tube = after([
      { type: 'addStroke', stroke: ring },
      { type: 'setForm', form: 'tube' },
    ]);
    const once = after([{ type: 'addSection', u: first, drawn: drawn(4) }], tube);
    const twice = after([{ type: 'addSection', u: second, drawn: drawn(9) }], once);
    expect(twice.draft!.sections!.map(({ u }) => u)).toEqual([second]);
    const over = { stroke: strokeAlong((t) => [4 * t - 2, 8 + t], { plane: ring.plane }), half: 6 };
    const redrawn = after([{ type: 'redrawSection', u: first, drawn: over }], twice);
    expect(redrawn.draft!.sections!.map(({ redraws }) => redraws.length)).toEqual([1]);
    const far = after([{ type: 'addSection', u: 0.02, drawn: drawn(9) }], once);
    expect(far.draft!.sections).toHaveLength(2);
  });

  it.each([0.2, 0.004])('here only at %f fades to both sides of it, and no step is at the seam', (u) => {
    const over = { stroke: strokeAlong((t) => [4 * t - 2, 8 + t], { plane: ring.plane }), half: 6 };
    const local = after([
      { type: 'addStroke', stroke: ring },
      { type: 'setForm', form: 'tube' },
      { type: 'addSection', u: 0.5, drawn: drawn(4) },
      { type: 'redrawSection', u, drawn: over, local: true },
    ]);
    const sections = local.draft!.sections!;
    expect(sections).toHaveLength(2);
    const [lit, other] = sections;
    expect(lit).toMatchObject({ u, follows: true, redraws: [over] });
    expect(other).toMatchObject({ u: u + 0.5, redraws: [] });
    const replaced = after([{ type: 'addSection', u: 0, drawn: drawn(9) }], local);
    const places = replaced.draft!.sections!.map((section) => section.u);
    for (const [i, place] of places.entries())
      for (const next of places.slice(i + 1)) {
        const apart = Math.abs(next - place);
        expect(Math.min(apart, 1 - apart)).toBeGreaterThanOrEqual(0.01);
      }
  });

  it.each([0, 0.3, 0.999])('here only, at %f: bulges there, and is round on the other side', (u) => {
    const bump = { stroke: strokeAlong((t) => [4 * t - 2, 8 + t], { plane: ring.plane }), half: 6 };
    const redrawn = after([
      { type: 'addStroke', stroke: ring },
      { type: 'setForm', form: 'tube' },
      { type: 'redrawSection', u, drawn: bump, local: true },
    ]);
    expect(redrawn.draft!.sections).toHaveLength(2);
    const { mesh } = draftSolids(redrawn)[0]!;
    expect(topology(mesh)).toMatchObject({ watertight: true, genus: 1, finite: true });
    // how thick the tube is near a place of the ring
    const thickness = (place: number): number =>
      Math.max(
        ...range(mesh)
          .filter(([x, y]) => {
            const turn = Math.atan2(x, y) / (2 * Math.PI) - place;
            return Math.abs(turn - Math.round(turn)) < 0.01;
          })
          .map(([x, y, z]) => Math.hypot(Math.hypot(x, y) - 40, z)),
      );
    expect(thickness(u)).toBeGreaterThan(8);
    expect(thickness(u + 0.5)).toBeLessThan(6.1);
  });
});
