import { describe, expect, test } from 'vitest';
import { solids } from '../../src/document/build.ts';
import { isSurface } from '../../src/document/document.ts';
import { boxOfMesh } from '../../src/document/extent.ts';
import { cross3, dot3, rotate3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { project, toWorld } from '../../src/stroke/plane.ts';
import { bendPart, choosing, madeBend } from '../../src/tool/bend.ts';
import { halfCircle } from '../document/strokes.ts';
import { Driver } from './driver.ts';
import { anyRotation, tubes } from './scene.ts';

/** A ball of 30 mm, drawn from the front. */
function ball(): Driver {
  const hand = new Driver();
  hand.commit([
    { type: 'addStroke', stroke: halfCircle(30, -1) },
    { type: 'addStroke', stroke: halfCircle(30, 1) },
    { type: 'keep' },
  ]);
  return hand;
}

const bendsOf = (hand: Driver) => hand.document.parts.filter(isSurface)[0]!.bends;
const upward = [
  [400, 480],
  [420, 300],
  [480, 140],
] as const;

describe('from the side', () => {
  test.each([0, 1, 2, 3])(
    'the line of sight lies in the drawing plane, across the axis, however it was turned, seed %d',
    (seed) => {
      const hand = ball();
      const by = { rotation: anyRotation(seed), translation: [5, -8, 11] as Vec3 };
      hand.commit([{ type: 'moveParts', ids: ['part-1'], by }]);
      bendPart(hand, 'part-1', 0);
      const sight = rotate3(hand.view.rotation, [0, 0, 1]);
      const [axis, normal] = [rotate3(by.rotation, [0, 1, 0]), rotate3(by.rotation, [0, 0, 1])];
      expect(Math.abs(dot3(sight, axis))).toBeLessThan(1e-9);
      expect(Math.abs(dot3(sight, normal))).toBeLessThan(1e-9);
    },
  );

  test('an upright axis stays upright, and laying the tool down brings the camera back', () => {
    const hand = ball();
    const home = hand.view;
    hand.state = bendPart(hand, 'part-1', 0);
    expect(hand.view.rotation).not.toEqual(home.rotation);
    expect(rotate3(hand.view.rotation, [0, 1, 0])[1]).toBeCloseTo(1, 12);
    hand.state.leave?.(hand);
    expect(hand.view).toEqual(home);
  });
});

describe('drawing', () => {
  test('shows the bent part, and lifting is one bend, one undo step', () => {
    const hand = ball();
    const before = hand.document;
    hand.state = bendPart(hand, 'part-1', 0);
    hand.trace(upward);
    expect(hand.state.preview?.(hand)?.parts[0]).toMatchObject({
      bends: [{ keepsLength: true, isOff: false }],
    });
    expect(hand.document).toBe(before);
    hand.up();
    expect(bendsOf(hand)).toHaveLength(1);
    hand.undo();
    expect(hand.document).toBe(before);
  });

  test('again takes the place of that bend; a further one goes on top', () => {
    const hand = ball();
    hand.state = bendPart(hand, 'part-1', 0);
    hand.draw(upward);
    const [first] = bendsOf(hand);
    hand.draw([
      [400, 480],
      [300, 140],
    ]);
    expect(bendsOf(hand)).toHaveLength(1);
    expect(bendsOf(hand)[0]).not.toBe(first);
    hand.state = bendPart(hand, 'part-1', 1);
    hand.draw(upward);
    expect(bendsOf(hand)).toHaveLength(2);
  });

  test('its stroke lies where the pen was, in the part’s own space', () => {
    const hand = ball();
    const by = { rotation: anyRotation(7), translation: [20, 0, 5] as Vec3 };
    hand.commit([{ type: 'moveParts', ids: ['part-1'], by }]);
    hand.state = bendPart(hand, 'part-1', 0);
    hand.draw(upward);
    const { stroke } = bendsOf(hand)[0]!;
    const normal = rotate3(by.rotation, cross3(stroke.plane.x, stroke.plane.y));
    expect(dot3(normal, rotate3(hand.view.rotation, [0, 0, 1]))).toBeCloseTo(1, 9);
    const reach = stroke.samples.map(({ x, y }) => toWorld(stroke.plane, [x, y]));
    expect(reach.every((p) => p.every(Number.isFinite))).toBe(true);
  });

  test('cancelled nothing is bent, and the part stays in hand', () => {
    const hand = ball();
    hand.state = bendPart(hand, 'part-1', 0);
    hand.trace(upward);
    hand.cancel();
    expect(bendsOf(hand)).toHaveLength(0);
    expect(hand.state.bending?.id).toBe('part-1');
  });

  test('from the end of the axis words say why nothing happens', () => {
    const hand = ball();
    hand.state = bendPart(hand, 'part-1', 0);
    hand.view = { ...hand.view, rotation: [-Math.SQRT1_2, 0, 0, Math.SQRT1_2] };
    hand.draw(upward);
    expect(hand.notices.at(-1)).toBe('end-on');
    expect(bendsOf(hand)).toHaveLength(0);
  });
});

describe('which part', () => {
  test('a tap says it; on paper nothing happens', () => {
    const hand = tubes(0);
    hand.state = choosing;
    hand.down(100, 100);
    hand.up();
    expect(hand.notices.at(-1)).toBe('bend-what');
    hand.hit = { point: [0, 0, 6], normal: [0, 0, 1], id: 'part-1' };
    hand.down(400, 300);
    hand.up();
    expect(hand.state.bending).toMatchObject({ id: 'part-1', index: 0, old: null });
    expect(hand.selection).toEqual(['part-1']);
  });

  test('a bend of the list is seen as it was drawn, and drawn anew', () => {
    const hand = ball();
    hand.state = bendPart(hand, 'part-1', 0);
    const side = hand.view.rotation;
    hand.draw(upward);
    hand.state.leave?.(hand);
    hand.state = bendPart(hand, 'part-1', 0);
    expect(Math.abs(hand.view.rotation.reduce((sum, q, i) => sum + q * side[i]!, 0))).toBeCloseTo(1, 9);
    const old = madeBend(hand.state.bending!, hand.document);
    expect(old).toBe(hand.state.bending!.old);
    hand.draw([
      [400, 480],
      [300, 140],
    ]);
    expect(bendsOf(hand)).toHaveLength(1);
    expect(bendsOf(hand)[0]).not.toBe(old);
  });
});

test('of a part that is gone brings the camera back, too', () => {
  const hand = ball();
  const home = hand.view;
  hand.state = bendPart(hand, 'part-1', 0);
  hand.undo();
  hand.down(400, 300);
  expect(hand.state).toBe(choosing);
  expect(hand.view).toEqual(home);
});

describe('how large it is seen', () => {
  const seen = (hand: Driver) => boxOfMesh(solids(hand.document)[0]!.mesh);
  test('as before; smaller only where it would not fit, and then it does', () => {
    for (const height of [500, 200, 90, 20]) {
      const hand = ball();
      hand.view = { ...hand.view, height };
      hand.state = bendPart(hand, 'part-1', 0);
      const { min, max } = seen(hand);
      const needed = (max[1] - min[1]) / 0.8;
      expect(hand.view.height).toBeCloseTo(Math.max(height, needed), 6);
      const ends = [min, max].map((p) => project(hand.view, hand.size, p)![1]);
      for (const y of ends) expect(Math.abs(y - 300)).toBeLessThanOrEqual(0.4 * 600 + 1e-6);
    }
  });
});
