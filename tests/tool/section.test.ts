/** Drawing across: two sides 200 px apart, x = 300 and 500, drawn from y = 100 down to 500; a pixel is a third of a millimetre. */
import { beforeEach, describe, expect, it } from 'vitest';
import { draftSolids } from '../../src/document/build.ts';
import { isSurface, readingOf } from '../../src/document/document.ts';
import { placedStroke } from '../../src/document/placedStroke.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { project, toWorld } from '../../src/stroke/plane.ts';
import { idle } from '../../src/tool/draw.ts';
import type { Mark } from '../../src/tool/marks.ts';
import { sectioning } from '../../src/tool/section.ts';
import type { Pen } from '../../src/tool/tool.ts';
import { Driver } from './driver.ts';

type Point = readonly [x: number, y: number];

const LEFT: readonly Point[] = [
  [300, 100],
  [300, 500],
];
const RIGHT: readonly Point[] = [
  [500, 100],
  [500, 500],
];
/** Bulging downwards, from the left to the right. */
const ACROSS: readonly Point[] = [
  [302, 200],
  [350, 260],
  [400, 280],
  [450, 260],
  [497, 202],
];

let hand: Driver;

beforeEach(() => {
  hand = new Driver();
});

function twoSides(): void {
  hand.draw(LEFT);
  hand.draw(RIGHT);
}

const take = () => {
  hand.state = sectioning;
};

const pixel = (p: Vec3) => project(hand.view, hand.size, p)!;
const marksOf = <K extends Mark['kind']>(kind: K) =>
  (hand.state.marks ?? []).filter((mark): mark is Extract<Mark, { kind: K }> => mark.kind === kind);
const lineOf = (style: string) =>
  marksOf('line')
    .find((line) => line.style === style)!
    .points.map(pixel);
const sections = () => hand.document.draft?.sections ?? [];

describe('the guide', () => {
  beforeEach(() => {
    twoSides();
    take();
  });

  it('shows within 24 px of a side, at that height, and goes beyond', () => {
    for (const [x, y] of [
      [320, 200],
      [280, 200],
      [520, 200],
    ] as const) {
      hand.hover(x, y);
      const [a, b] = lineOf('flat');
      for (const end of [a!, b!]) expect(Math.abs(end[1] - 200)).toBeLessThan(2);
      expect(Math.abs(a![0] - b![0])).toBeCloseTo(200, 0);
    }
    hand.hover(330, 200);
    expect(hand.state.marks).toBeUndefined();
    hand.hover(300, 200);
    hand.hover();
    expect(hand.state.marks).toBeUndefined();
  });

  it('says how far along it is, outside of the other side', () => {
    hand.hover(300, 200);
    const [tag] = marksOf('tag');
    expect(tag!.value).toBeCloseTo(25, 0);
    expect(pixel(tag!.at)[0]).toBeCloseTo(500, 0);
    expect(pixel(tag!.from)[0]).toBeCloseTo(300, 0);
    expect(hand.state.guide!.u).toBeCloseTo(0.25, 2);
  });

  it('is full below the line, hollow above it', () => {
    hand.hover(300, 200);
    // y runs down
    const below = (points: ReturnType<typeof lineOf>) => points.map(([, y]) => y - 200);
    expect(Math.min(...below(lineOf('full')))).toBeGreaterThan(-1e-6);
    expect(Math.max(...below(lineOf('hollow')))).toBeLessThan(1e-6);
    expect(Math.max(...below(lineOf('full')))).toBeGreaterThan(10);
  });

  it('lets the unfinished form step back until its stroke is past the middle', () => {
    hand.hover(300, 200);
    expect(hand.state.faint).toBe(true);
    hand.down(300, 200);
    hand.move(380, 230);
    expect(hand.state.faint).toBe(true);
    expect(hand.state.preview!(hand)).toBeNull();
    hand.move(420, 230);
    expect(hand.state.faint).toBeUndefined();
    expect(hand.state.preview!(hand)?.draft?.sections).toHaveLength(1);
  });

  it('shows where one touches, before anything is drawn', () => {
    hand.down(302, 200);
    expect(marksOf('ring')).toHaveLength(1);
    expect(hand.state.guide!.u).toBeCloseTo(0.25, 2);
    hand.up();
    expect(hand.state.name).toBe('section.guide');
    expect(sections()).toHaveLength(0);
  });
});

describe('a stroke across', () => {
  beforeEach(() => {
    twoSides();
    take();
  });

  it('is a section of what is drawn there, one undo step', () => {
    hand.draw(ACROSS);
    expect(readingOf(hand.document)).toBe('crossSection');
    const [section] = sections();
    expect(section!.u).toBeCloseTo(0.25, 2);
    expect(section!.front!.half).toBeNull();
    const { samples, plane } = section!.front!.stroke;
    const middle = samples[Math.floor(samples.length / 2)]!;
    const seen = pixel(toWorld(plane, [middle.x, middle.y]));
    expect(Math.abs(seen[1] - 280)).toBeLessThan(6);
    hand.undo();
    expect(readingOf(hand.document)).toBe('rotational');
  });

  it('may be drawn from the right to the left', () => {
    hand.draw([...ACROSS].reverse());
    // where it begins
    expect(sections()[0]!.u).toBeCloseTo((202 - 100) / 400, 3);
  });

  it('marks both ends while the other one snaps', () => {
    hand.trace(ACROSS.slice(0, 4));
    expect(marksOf('dot').map(({ held }) => held ?? false)).toEqual([true, false]);
    hand.move(490, 200);
    expect(marksOf('dot').map(({ held }) => held ?? false)).toEqual([true, true]);
    expect(marksOf('label')).toHaveLength(0);
  });

  it('that ends outside of the form is none: the guide stays', () => {
    hand.draw([...ACROSS, [560, 200]]);
    expect(sections()).toHaveLength(0);
    expect(hand.state.name).toBe('section.guide');
    expect(hand.state.guide!.u).toBeCloseTo(0.25, 2);
    // from where it is shown one may still begin, inside of the form
    hand.draw([
      [350, 210],
      [480, 210],
    ]);
    expect(sections()[0]!.u).toBeCloseTo(0.25, 2);
  });

  it('that does not come past the middle is none', () => {
    hand.draw([
      [302, 200],
      [380, 240],
    ]);
    expect(sections()).toHaveLength(0);
  });

  it('is cancelled as any other, and the guide stays', () => {
    hand.trace(ACROSS);
    hand.cancel();
    expect(hand.state.name).toBe('section.guide');
    expect(sections()).toHaveLength(0);
    expect(hand.state.cancel()).toBe(hand.state);
  });

  it('that begins away from both sides says where to begin', () => {
    hand.down(400, 300);
    expect(hand.notices).toEqual(['off-sides']);
    expect(hand.state.wet).toBeUndefined();
  });

  it('twice makes a patch, in order', () => {
    hand.draw(ACROSS.map(([x, y]) => [x, y + 200] as const));
    hand.draw(ACROSS);
    expect(readingOf(hand.document)).toBe('bspline');
    expect(sections().map(({ u }) => Math.round(100 * u))).toEqual([25, 75]);
  });

  it('makes a surface again of what was stepped back from', () => {
    for (const command of [
      { type: 'setForm', form: 'tube' },
      { type: 'setTubesOnly', on: true },
    ] as const) {
      hand.commit([command]);
      const before = hand.document;
      hand.draw(ACROSS);
      expect(readingOf(hand.document)).toBe('crossSection');
      expect(hand.document.tubesOnly).toBe(false);
      hand.undo();
      expect(hand.document).toBe(before);
      hand.draw(ACROSS);
    }
  });
});

describe('a back that is drawn', () => {
  beforeEach(() => {
    twoSides();
    hand.commit([{ type: 'setSurface', change: { back: 'drawn' } }]);
    take();
    hand.draw(ACROSS);
  });

  it('is the next stroke near the section that has none yet, at its very place', () => {
    hand.hover(300, 230);
    expect(hand.state.guide).toEqual({ u: sections()[0]!.u, side: 'back' });
    expect(marksOf('label').map(({ word }) => word)).toEqual(['back']);
    hand.draw(ACROSS.map(([x]) => [x, 190] as const));
    expect(sections()).toHaveLength(1);
    expect(sections()[0]!.back).not.toBeNull();
    hand.undo();
    expect(sections()[0]!.back).toBeNull();
  });

  it('is not what is drawn elsewhere: that is a section of its own, as its guide says', () => {
    hand.hover(300, 400);
    expect(hand.state.guide).toMatchObject({ side: 'front' });
    expect(hand.state.guide!.u).toBeGreaterThan(sections()[0]!.u + 0.3);
    hand.draw(ACROSS.map(([x, y]) => [x, y + 200] as const));
    expect(sections().map(({ front, back }) => [front !== null, back !== null])).toEqual([
      [true, false],
      [true, false],
    ]);
    // either is still there to be given one
    hand.draw(ACROSS.map(([x]) => [x, 190] as const));
    expect(sections().map(({ back }) => back !== null)).toEqual([true, false]);
  });

  it('is followed by further sections', () => {
    hand.draw(ACROSS.map(([x]) => [x, 190] as const));
    hand.draw(ACROSS.map(([x, y]) => [x, y + 200] as const));
    expect(sections().map(({ back }) => back !== null)).toEqual([true, false]);
  });
});

describe('without an unfinished form', () => {
  const parts = () => hand.document.parts;

  it('says what is missing', () => {
    take();
    hand.down(300, 200);
    expect(hand.notices).toEqual(['no-sides']);
  });

  it('sections go to the selected part, else to the last one with two sides', () => {
    twoSides();
    hand.commit([{ type: 'keep' }]);
    hand.state = idle;
    for (const line of [LEFT, RIGHT]) hand.draw(line.map(([x, y]) => [x + 250, y] as const));
    hand.commit([{ type: 'keep' }]);
    take();
    hand.draw(ACROSS);
    expect(parts().map(({ kind }) => kind)).toEqual(['rotational', 'rotational']);
    hand.select([parts()[0]!.id]);
    hand.draw(ACROSS);
    expect(parts().map(({ kind }) => kind)).toEqual(['crossSection', 'rotational']);
  });

  it('they are drawn where the part was moved to, and kept in its own space', () => {
    twoSides();
    hand.commit([
      { type: 'keep' },
      { type: 'moveParts', ids: ['part-1'], by: { rotation: [0, 0, 0.6, 0.8], translation: [10, 4, 0] } },
    ]);
    const [before] = parts();
    take();
    if (!before || !isSurface(before)) throw new Error('no surface');
    const { plane } = placedStroke(before.strokes[0]!, before.placement);
    const seen = ([x, y]: Point): Point => {
      // where the pixel of the first view lies now
      const p = pixel(toWorld(plane, [(x - 400) / 3, (300 - y) / 3]));
      return [p[0], p[1]];
    };
    hand.draw(ACROSS.map(seen));
    const [part] = parts();
    if (part?.kind !== 'crossSection') throw new Error(`it is ${part?.kind}`);
    expect(part.sections[0]!.u).toBeCloseTo(0.25, 2);
    const { stroke } = part.sections[0]!.front!;
    expect(stroke.plane).toEqual(part.strokes[0]!.plane);
    const deepest = Math.min(...stroke.samples.map(({ y }) => y));
    expect(deepest).toBeCloseTo((300 - 280) / 3, 0);
  });

  it('bends and a plane on edge stand in the way', () => {
    twoSides();
    hand.commit([{ type: 'keep' }]);
    const [part] = parts();
    if (!part || !isSurface(part)) throw new Error('no surface');
    take();
    hand.view = { ...hand.view, rotation: [0, Math.SQRT1_2, 0, Math.SQRT1_2] };
    hand.down(400, 200);
    hand.view = { ...hand.view, rotation: [0, 0, 0, 1] };
    const bend = { stroke: part.strokes[0]!, keepsLength: true, isOff: false };
    hand.commit([{ type: 'bend', id: part.id, bend }]);
    hand.down(300, 200);
    expect(hand.notices).toEqual(['edge-on', 'bent']);
  });
});

describe('with Draw', () => {
  beforeEach(twoSides);

  it('a stroke from one side to the other is a section', () => {
    hand.trace(ACROSS.slice(0, 3));
    expect(marksOf('tag')).toHaveLength(1);
    expect(hand.state.preview!(hand)).toBeNull();
    hand.move(497, 202);
    expect(hand.state.preview!(hand)?.draft?.sections).toHaveLength(1);
    hand.up();
    expect(readingOf(hand.document)).toBe('crossSection');
    expect(hand.document.parts).toHaveLength(0);
  });

  it('one that ends elsewhere begins the next form', () => {
    hand.draw([
      [302, 200],
      [240, 200],
      [200, 260],
    ]);
    expect(hand.document.parts.map(({ kind }) => kind)).toEqual(['rotational']);
    expect(hand.document.draft!.strokes).toHaveLength(1);
  });

  it('one that starts outside keeps the form, wherever it ends', () => {
    hand.draw([
      [200, 200],
      [497, 200],
    ]);
    expect(hand.document.parts).toHaveLength(1);
    expect(sections()).toHaveLength(0);
  });

  it('tubes stay tubes', () => {
    hand.commit([{ type: 'setForm', form: 'tube' }]);
    hand.draw(ACROSS);
    expect(hand.document.parts.map(({ kind }) => kind)).toEqual(['tube', 'tube']);
  });
});

it('what the guide shows is what the surface is made with: its u moves with the sides of the pair', () => {
  hand.draw([
    [300, 100],
    [300, 500],
  ]);
  // the other way round, and only half as long
  hand.draw([
    [500, 400],
    [500, 200],
  ]);
  take();
  hand.hover(300, 200);
  const [a, b] = lineOf('flat');
  const right = a![0] > b![0] ? a! : b!;
  // a quarter of the way down on both
  expect(right[1]).toBeCloseTo(250, -1);
});

describe('what the guide says comes true', () => {
  const turn = (points: readonly Point[], quarter: boolean) =>
    points.map(([x, y]): Point => (quarter ? [400 + (y - 300), 300 - (x - 400)] : [x, y]));

  for (const quarter of [false, true])
    for (const first of [LEFT, [...LEFT].reverse(), RIGHT, [...RIGHT].reverse()])
      it(`full comes towards the person, hollow goes away (${first.join(' to ')}, ${quarter ? 'lying' : 'upright'})`, () => {
        for (const side of ['full', 'hollow'] as const) {
          hand = new Driver();
          hand.draw(turn(first, quarter));
          hand.draw(turn(first[0]![0] === 300 ? RIGHT : LEFT, quarter));
          take();
          hand.hover(...turn([[300, 300]], quarter)[0]!);
          hand.draw(lineOf(side).map(([x, y]): Point => [x, y]));
          expect(sections()).toHaveLength(1);
          const [solid] = draftSolids(hand.document);
          const zs = [...solid!.mesh.positions].filter((_, i) => i % 3 === 2);
          const [least, most] = [Math.min(...zs), Math.max(...zs)];
          const deep = 0.44 * (100 / 3);
          expect(side === 'full' ? most : -least).toBeGreaterThan(0.9 * deep);
          expect(side === 'full' ? -least : most).toBeLessThan(0.05 * deep);
        }
      });
});

describe('across a tube', () => {
  const OVER: readonly Point[] = [
    [272, 200],
    [300, 230],
    [328, 200],
  ];

  beforeEach(() => {
    // 10 mm are 30 px
    hand.commit([{ type: 'setBrush', change: { radius: 10 } }]);
    hand.draw(LEFT);
  });

  it('the guide lies square to its stroke, as wide as it is, at its edges and over it', () => {
    take();
    for (const x of [270, 295, 330]) {
      hand.hover(x, 200);
      const [a, b] = lineOf('flat');
      expect([a![0], b![0]].sort((p, q) => p - q).map(Math.round)).toEqual([270, 330]);
      expect(a![1]).toBeCloseTo(b![1], 6);
      expect(hand.state.guide!.u).toBeCloseTo(0.25, 2);
    }
  });

  it('a stroke is its section, a second one makes a patch; each is one undo step', () => {
    take();
    hand.draw(OVER);
    expect(readingOf(hand.document)).toBe('crossSection');
    hand.draw(OVER.map(([x, y]) => [x, y + 200] as const));
    expect(readingOf(hand.document)).toBe('bspline');
    expect(sections().map(({ u }) => Math.round(100 * u))).toEqual([25, 75]);
    expect(draftSolids(hand.document)[0]!.mesh.positions.every(Number.isFinite)).toBe(true);
    hand.undo();
    hand.undo();
    expect(readingOf(hand.document)).toBe('tube');
  });

  it('what runs along the tube is none', () => {
    take();
    hand.draw([
      [298, 200],
      [303, 300],
    ]);
    expect(sections()).toHaveLength(0);
  });

  it('a kept one is drawn across, too', () => {
    hand.commit([{ type: 'keep' }]);
    take();
    hand.draw(OVER);
    expect(hand.document.parts.map(({ kind }) => kind)).toEqual(['crossSection']);
  });

  it('that is narrower in the picture than 12 px says to zoom in, also on what was drawn; beside it, where to begin', () => {
    take();
    hand.view = { ...hand.view, height: 1200 };
    for (const x of [382, 383, 440]) {
      hand.hover(x, 300);
      expect(hand.state.marks).toBeUndefined();
      hand.down(x, 300);
      expect(hand.state.name).toBe('section.idle');
    }
    expect(hand.notices).toEqual(['too-narrow', 'too-narrow', 'off-sides']);
  });

  it('with Draw the second stroke is the other side, as ever', () => {
    hand.state = idle;
    hand.draw(OVER);
    expect(sections()).toHaveLength(0);
    expect(hand.document.draft!.strokes).toHaveLength(2);
  });

  it('closed strokes that are tubes have it all round', () => {
    hand.commit([{ type: 'drop' }]);
    const ring = Array.from({ length: 73 }, (_, i): Point => {
      const angle = (i * Math.PI) / 36;
      return [400 + 150 * Math.sin(angle), 300 - 150 * Math.cos(angle)];
    });
    hand.draw(ring);
    hand.commit([{ type: 'setForm', form: 'tube' }]);
    take();
    hand.draw([
      [522, 300],
      [550, 320],
      [578, 300],
    ]);
    expect(readingOf(hand.document)).toBe('crossSection');
    expect(sections()).toHaveLength(1);
  });
});

describe('a finger', () => {
  const finger = (x: number, y: number, time: number): Pen => ({
    ...{ x, y, time, pressure: 0.5, tiltX: 0, tiltY: 0 },
    pointer: 'touch',
  });
  const touch = (x: number, y: number) => {
    hand.state = hand.state.down!(finger(x, y, 0), hand)!;
  };
  const go = (from: Point, to: Point, since: number) => {
    for (let i = 1; i <= 20; i++) {
      const [x, y] = [0, 1].map((k) => from[k]! + ((to[k]! - from[k]!) * i) / 20) as [number, number];
      hand.state = hand.state.move!([finger(x, y, since + 8 * i)], hand)!;
    }
  };

  beforeEach(() => {
    twoSides();
    take();
  });

  it('that rested slides the guide along the side, and draws where it leaves it', () => {
    touch(302, 200);
    go([302, 200], [302, 300], 400);
    expect(hand.state.name).toBe('section.sliding');
    expect(hand.state.guide!.u).toBeCloseTo(0.5, 2);
    expect(sections()).toHaveLength(0);
    go([302, 300], [496, 300], 600);
    hand.up();
    expect(sections()[0]!.u).toBeCloseTo(0.5, 2);
    // from the side on: nothing of the stroke was taken for sliding
    const [first] = sections()[0]!.front!.stroke.samples;
    expect(400 + 3 * first!.x).toBeLessThan(310);
  });

  it('that lifts, or is joined by a second one, leaves the guide where it is', () => {
    touch(302, 200);
    go([302, 200], [302, 300], 400);
    for (const next of [hand.state.up!(hand), hand.state.cancel()]) {
      expect(next!.name).toBe('section.guide');
      expect(next!.guide!.u).toBeCloseTo(0.5, 2);
    }
  });

  it('that rested and goes across draws there, from where it touched', () => {
    touch(302, 200);
    go([302, 200], [400, 290], 400);
    expect(hand.state.name).toBe('section.drawing');
    go([400, 290], [497, 202], 600);
    hand.up();
    expect(sections()[0]!.u).toBeCloseTo(0.25, 2);
  });

  it('that goes on at once draws, along the side too: round sections begin so', () => {
    touch(302, 200);
    go([302, 200], [302, 300], 0);
    expect(hand.state.name).toBe('section.drawing');
    expect(hand.state.guide!.u).toBeCloseTo(0.25, 2);
  });

  it('slides along the middle of a tube, whichever edge it is nearer to, and draws where it goes across', () => {
    hand.commit([{ type: 'drop' }]);
    hand.state = idle;
    hand.commit([{ type: 'setBrush', change: { radius: 10 } }]);
    hand.draw(LEFT);
    take();
    touch(301, 200);
    go([301, 200], [297, 250], 400);
    expect(hand.state.name).toBe('section.sliding');
    go([297, 250], [303, 300], 600);
    expect(hand.state.name).toBe('section.sliding');
    expect(hand.state.guide!.u).toBeCloseTo(0.5, 2);
    hand.up();
    touch(272, 200);
    go([272, 200], [271, 400], 400);
    expect(hand.state.name).toBe('section.sliding');
    go([271, 400], [330, 402], 600);
    hand.up();
    expect(sections().map(({ u }) => Math.round(100 * u))).toEqual([75]);
  });

  describe('on a thin form', () => {
    /** 43 px wide, or two sides 30 px apart */
    const tube = () => {
      hand.commit([{ type: 'drop' }, { type: 'setBrush', change: { radius: 43 / 6 } }]);
      hand.state = idle;
      hand.draw(LEFT);
      take();
    };
    const pair = () => {
      hand.commit([{ type: 'drop' }]);
      hand.state = idle;
      hand.draw(LEFT.map(([x, y]) => [x - 15, y] as const));
      hand.draw(LEFT.map(([x, y]) => [x + 15, y] as const));
      take();
    };
    const arc = (from: number, to: number, depth: number) => (t: number) =>
      [from + t * (to - from), 200 + depth * Math.sin(Math.PI * t)] as const;
    const along = (way: (t: number) => Point, since: number) => {
      for (let i = 1; i <= 20; i++) {
        const [x, y] = way(i / 20);
        hand.state = hand.state.move!([finger(x, y, since + 8 * i)], hand)!;
      }
    };
    const forms = [
      ['a tube', tube, 279, 321],
      ['two sides', pair, 286, 314],
    ] as const;

    for (const [name, make, left, right] of forms)
      for (const [from, to] of [
        [left, right],
        [right, left],
      ] as const)
        for (const share of [0, 0.3, 0.5, 0.9])
          it(`a finger that rested draws across ${name} from ${from} to ${to}, ${share} of the width deep`, () => {
            make();
            touch(from, 200);
            along(arc(from, to, share * (right - left)), 500);
            hand.up();
            expect(sections().map(({ u }) => Math.round(100 * u))).toEqual([25]);
            const [first] = sections()[0]!.front!.stroke.samples;
            expect(Math.abs(400 + 3 * first!.x - from)).toBeLessThan(4);
          });

    for (const [name, make, left, right] of forms)
      it(`${name}: slides along, trembling, and draws across where it got to`, () => {
        make();
        touch(left, 200);
        along((t) => [left + 3 * Math.sin(40 * t), 200 + 200 * t], 500);
        expect(hand.state.name).toBe('section.sliding');
        go([left, 400], [right, 404], 900);
        hand.up();
        expect(sections().map(({ u }) => Math.round(100 * u))).toEqual([75]);
      });
  });
});
