import { beforeEach, describe, expect, it } from 'vitest';
import { draftIsWhole, solids } from '../../src/document/build.ts';
import { type Document, readingOf } from '../../src/document/document.ts';
import { Driver } from './driver.ts';

let hand: Driver;
beforeEach(() => {
  hand = new Driver();
});

const LEFT = [
  [350, 200],
  [350, 400],
] as const;
const RIGHT = [
  [450, 200],
  [450, 400],
] as const;
const ringAt = (x: number, y: number, radius: number) =>
  Array.from({ length: 41 }, (_, i) => {
    const angle = (i / 40) * 2 * Math.PI;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)] as const;
  });
const RING = ringAt(400, 300, 80);

/** Groups in each component of the only part. */
const componentsOf = ({ parts }: Document) =>
  parts.length === 1 && parts[0]!.kind === 'solid'
    ? parts[0]!.components.map(({ groups }) => groups.length)
    : [];

describe('draw', () => {
  it('goes from idle to pointing to drawing and back', () => {
    expect(hand.state.name).toBe('draw.idle');
    hand.down(400, 300);
    expect(hand.state.name).toBe('draw.pointing');
    hand.move(440, 300);
    expect(hand.state.name).toBe('draw.drawing');
    hand.up();
    expect(hand.state.name).toBe('draw.idle');
  });

  it('stores raw samples in millimetres on the plane through the pivot that faces the camera', () => {
    hand.draw(LEFT);
    const stroke = hand.document.draft!.strokes[0]!;
    // 600 px are 200 mm; the middle of the picture is the pivot.
    expect(stroke.samples[0]!.x).toBeCloseTo(-50 / 3, 9);
    expect(stroke.samples[0]!.y).toBeCloseTo(100 / 3, 9);
    expect(stroke.plane.origin).toEqual([0, 0, 0]);
    expect(stroke.pointer).toBe('pen');
    expect(stroke.samples[1]!.time - stroke.samples[0]!.time).toBe(8);
  });

  it('makes one stroke a tube and two a rotational surface, and the third begins the next form', () => {
    hand.draw(LEFT);
    expect(readingOf(hand.document)).toBe('tube');
    hand.draw(RIGHT);
    expect(readingOf(hand.document)).toBe('rotational');
    hand.draw([
      [300, 100],
      [500, 100],
    ]);
    expect(hand.document.parts).toHaveLength(1);
    expect(hand.document.draft!.strokes).toHaveLength(1);
  });

  it('makes keeping and the new stroke two undo steps', () => {
    hand.draw(LEFT);
    hand.draw(RIGHT);
    hand.draw([
      [300, 100],
      [500, 100],
    ]);
    hand.undo();
    expect(hand.document.parts).toHaveLength(1);
    expect(hand.document.draft).toBeNull();
    hand.undo();
    expect(hand.document.parts).toHaveLength(0);
    expect(hand.document.draft!.strokes).toHaveLength(2);
  });

  it('puts all strokes of a form on the plane of its first, also after the view has turned', () => {
    hand.draw(LEFT);
    const half = Math.sin(Math.PI / 12);
    hand.view = { ...hand.view, rotation: [0, half, 0, Math.sqrt(1 - half * half)] };
    hand.draw(RIGHT);
    const [a, b] = hand.document.draft!.strokes;
    expect(b!.plane).toEqual(a!.plane);
  });

  it('refuses to draw on a plane seen from its edge, and says so', () => {
    hand.draw(LEFT);
    const half = Math.sin(Math.PI / 4);
    hand.view = { ...hand.view, rotation: [0, half, 0, half] };
    hand.draw(RIGHT);
    expect(hand.notices).toEqual(['edge-on']);
    expect(hand.document.draft!.strokes).toHaveLength(1);
  });

  it('lays a stroke that starts on a surface at the depth of that point', () => {
    hand.hit = { point: [3, 4, 25], normal: [0, 0, 1], id: 'part-1' };
    hand.draw(LEFT);
    expect(hand.document.draft!.strokes[0]!.plane.origin[2]).toBeCloseTo(25, 9);
  });

  it('closes a stroke that is lifted near its start, and not one that is pulled away', () => {
    hand.trace(RING.slice(0, 40));
    expect(hand.state.wet?.closing).toBe(true);
    hand.up();
    expect(hand.document.draft!.strokes[0]!.closed).toBe(true);
    hand.trace([...RING, [520, 300]]);
    expect(hand.state.wet?.closing).toBe(false);
  });

  it('does not pair an open with a closed stroke: the first is kept', () => {
    hand.draw(RING);
    hand.draw(LEFT);
    expect(hand.document.parts.map(({ kind }) => kind)).toEqual(['solid']);
    expect(hand.document.draft!.strokes[0]!.closed).toBe(false);
  });

  it('never keeps what nobody could see: two strokes in one place go on as two tubes', () => {
    hand.draw(LEFT);
    hand.draw(LEFT);
    expect(readingOf(hand.document)).toBe('rotational');
    hand.draw(RIGHT);
    expect(hand.document.parts.map(({ kind }) => kind)).toEqual(['tube', 'tube']);
    expect(solids(hand.document).every(({ mesh }) => mesh.indices.length > 0)).toBe(true);
    expect(hand.document.draft!.strokes).toHaveLength(1);
    expect(hand.document.tubesOnly).toBe(false);
  });

  it('takes a dot for no stroke, says why, and offers a point', () => {
    hand.draw([
      [400, 300],
      [403, 301],
    ]);
    expect(hand.document.draft).toBeNull();
    expect(hand.notices).toEqual(['too-short']);
    hand.commit(hand.offer);
    expect(readingOf(hand.document)).toBe('solid');
    expect(hand.document.draft!.form).toBe('point');
    expect(draftIsWhole(hand.document)).toBe(true);
  });

  it('makes a point of a tap that did not move at all, beside the form before', () => {
    hand.draw(LEFT);
    hand.down(500, 300);
    hand.move(500, 300);
    hand.up();
    hand.commit(hand.offer);
    expect(hand.document.parts.map(({ kind }) => kind)).toEqual(['tube']);
    expect(draftIsWhole(hand.document)).toBe(true);
  });

  it('draws the other side of a tube in hand, even while new strokes stay tubes', () => {
    hand.draw(LEFT);
    hand.commit([{ type: 'keep' }, { type: 'setTubesOnly', on: true }, { type: 'recreate', id: 'part-1' }]);
    hand.hit = { point: [3, 4, 25], normal: [0, 0, 1], id: 'part-1' };
    hand.draw(RIGHT);
    expect(readingOf(hand.document)).toBe('rotational');
  });

  describe('silhouettes', () => {
    it('are solids while they are closed, and tubes again when pulled away', () => {
      hand.trace(RING.slice(0, 40));
      expect(readingOf(hand.state.preview!(hand)!)).toBe('solid');
      hand.move(520, 300);
      expect(readingOf(hand.state.preview!(hand)!)).toBe('tube');
      hand.cancel();
      expect(hand.document.draft).toBeNull();
    });

    it('stay tubes while every stroke is one', () => {
      hand.commit([{ type: 'setTubesOnly', on: true }]);
      hand.draw(RING);
      expect(readingOf(hand.document)).toBe('tube');
    });

    it('have holes: what is closed inside, on the plane of the first, whatever it starts on', () => {
      hand.draw(RING);
      hand.hit = { point: [0, 0, 20], normal: [0, 0, 1], id: 'part-1' };
      hand.draw(ringAt(400, 300, 30));
      const { strokes } = hand.document.draft!;
      expect(hand.document.parts).toHaveLength(0);
      expect(strokes.map(({ closed }) => closed)).toEqual([true, true]);
      expect(strokes[1]!.plane).toEqual(strokes[0]!.plane);
      hand.undo();
      expect(hand.document.draft!.strokes).toHaveLength(1);
    });

    it.each([
      ['an open stroke inside', LEFT.map(([x, y]) => [x + 50, y] as const)],
      ['a closed one across', ringAt(460, 300, 60)],
    ])('are kept by %s, which begins the next form where it starts', (_, points) => {
      hand.draw(RING);
      const { nextId } = hand.document;
      hand.hit = { point: [0, 0, 20], normal: [0, 0, 1], id: `part-${nextId}` };
      hand.draw(points);
      const { parts, draft } = hand.document;
      expect(parts.map(({ id }) => id)).toEqual([`part-${nextId}`]);
      expect(draft!.strokes).toHaveLength(1);
      expect(draft!.strokes[0]!.plane.origin[2]).toBeCloseTo(20, 9);
      expect(draft!.joins).toEqual({ solid: `part-${nextId}`, component: `component-${nextId + 1}` });
    });

    it('join the component that they start on', () => {
      hand.draw(RING);
      hand.commit([{ type: 'keep' }]);
      const [body] = hand.document.parts;
      hand.hit = { point: [0, 0, 20], normal: [0, 0, 1], id: body!.id, skel: { path: 'skels[0]', share: 1 } };
      hand.draw(ringAt(450, 300, 60));
      hand.commit([{ type: 'setForm', joins: { solid: body!.id, component: null } }, { type: 'keep' }]);
      expect(componentsOf(hand.document)).toEqual([1, 1]);
      hand.hit = { ...hand.hit, skel: { path: 'parts[1].skels[2]', share: 1 } };
      hand.draw(ringAt(500, 300, 40));
      hand.commit([{ type: 'keep' }]);
      expect(componentsOf(hand.document)).toEqual([1, 2]);
    });

    it('that nothing can be made of go on as tubes: nothing drawn is lost', () => {
      // there and back on one line: it encloses nothing
      hand.draw([
        [300, 300],
        [500, 300],
        [300, 300],
      ]);
      expect(hand.document.draft!.strokes[0]!.closed).toBe(true);
      expect(draftIsWhole(hand.document)).toBe(false);
      hand.draw(LEFT);
      expect(hand.document.parts.map(({ kind }) => kind)).toEqual(['tube']);
    });
  });

  it.each(['pointing', 'drawing'])('cancels while %s without a trace', (moment) => {
    hand.draw(LEFT);
    const before = hand.document;
    hand.down(450, 200);
    if (moment === 'drawing') hand.move(450, 400);
    expect(hand.state.name).toBe(`draw.${moment}`);
    hand.cancel();
    expect(hand.state.name).toBe('draw.idle');
    expect(hand.document).toBe(before);
  });

  it('shows a tube from 12 px on and a rotational surface from half the first stroke on', () => {
    hand.down(350, 200);
    hand.move(350, 208);
    expect(hand.state.preview?.(hand)).toBeNull();
    hand.move(350, 400);
    expect(readingOf(hand.state.preview!(hand)!)).toBe('tube');
    hand.up();
    hand.trace([
      [450, 200],
      [450, 290],
    ]);
    expect(hand.state.preview?.(hand)).toBeNull();
    hand.move(450, 320);
    expect(readingOf(hand.state.preview!(hand)!)).toBe('rotational');
    expect(hand.document.draft!.strokes).toHaveLength(1);
  });
});
