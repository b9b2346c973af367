import { describe, expect, it } from 'vitest';
import { solids } from '../../src/document/build.ts';
import { boxOfGroup, middleOfParts, seenParts } from '../../src/document/extent.ts';
import { newHistory } from '../../src/document/history.ts';
import { type Placement, place3 } from '../../src/math/placement.ts';
import { cross3, dot3, length3, rotate3, scale3, sub3 } from '../../src/math/tuple.ts';
import type { Vec2, Vec3 } from '../../src/math/vec.ts';
import { bounds } from '../../src/mesh/measure.ts';
import { project } from '../../src/stroke/plane.ts';
import { footOf } from '../../src/tool/foot.ts';
import { AXIS, grip, type Handle, penBeside } from '../../src/tool/move.ts';
import { selecting } from '../../src/tool/select.ts';
import { figure, solidOf } from '../document/figure.ts';
import { random } from '../fixtures/random.ts';
import { Driver } from './driver.ts';
import { anyRotation, balls, exactBall, RADIUS, towardsViewer, tubes } from './scene.ts';

const SEEDS = [1, 2, 3, 4, 5, 6];

function take(hand: Driver, handle: Handle, at: Vec2 = [400, 300]): void {
  hand.state = grip(handle, selecting);
  hand.down(...at);
}

const carriedBy = (hand: Driver): Placement => hand.state.carried!.by;
const middleOf = (hand: Driver): Vec3 => middleOfParts(seenParts(hand.document, hand.selection))!;
const shown = (hand: Driver, p: Vec3): Vec2 => project(hand.view, hand.size, p)!;

function expectNear(a: readonly number[], b: readonly number[], digits = 9): void {
  a.forEach((value, i) => {
    expect(value).toBeCloseTo(b[i]!, digits);
  });
}

describe.each([0, 30])('in the view plane, opening %i°', (fov) => {
  it.each(SEEDS)('parts go as far as the pen goes, from wherever one looks (seed %i)', (seed) => {
    const hand = balls([12, -7, 20]);
    const next = random(seed);
    hand.view = { ...hand.view, rotation: anyRotation(seed), fov };
    hand.select(['part-2']);
    const middle = middleOf(hand);
    const way: Vec2 = [200 * (next() - 0.5), 200 * (next() - 0.5)];
    take(hand, 'view', [333, 222]);
    hand.move(333 + way[0], 222 + way[1]);
    const from = shown(hand, middle);
    const to = shown(hand, place3(carriedBy(hand), middle));
    expectNear([to[0] - from[0], to[1] - from[1]], way);
    const { translation } = carriedBy(hand);
    expect(dot3(translation, towardsViewer(hand.view.rotation))).toBeCloseTo(0, 9);
  });
});

describe('along an axis', () => {
  it.each(SEEDS)(
    'parts stay on it, and the pen beside it moves them as its shadow would (seed %i)',
    (seed) => {
      const hand = balls([5, 5, 20]);
      hand.view = { ...hand.view, rotation: anyRotation(seed) };
      hand.select(['part-2']);
      const middle = middleOf(hand);
      const next = random(seed);
      for (const handle of ['x', 'y', 'z'] as const) {
        if (Math.abs(dot3(AXIS[handle], towardsViewer(hand.view.rotation))) > 0.98) continue;
        take(hand, handle);
        const way: Vec2 = [150 * (next() - 0.5), 150 * (next() - 0.5)];
        hand.move(400 + way[0], 300 + way[1]);
        const { translation } = carriedBy(hand);
        expect(length3(cross3(translation, AXIS[handle]))).toBeCloseTo(0, 9);
        const from = shown(hand, middle);
        const to = shown(hand, place3(carriedBy(hand), middle));
        const end = shown(hand, [0, 1, 2].map((k) => middle[k]! + AXIS[handle][k]!) as unknown as Vec3);
        const beside = [to[0] - from[0] - way[0], to[1] - from[1] - way[1]] as const;
        expect(beside[0] * (end[0] - from[0]) + beside[1] * (end[1] - from[1])).toBeCloseTo(0, 6);
        hand.cancel();
      }
    },
  );

  it('that points at the viewer they do not run away', () => {
    const hand = balls();
    hand.select(['part-2']);
    take(hand, 'z');
    hand.move(700, 20);
    expect(carriedBy(hand).translation).toEqual([0, 0, 0]);
  });
});

describe('over a surface', () => {
  it.each(SEEDS)('the foot stays on a sphere and the part looks out of it as before (seed %i)', (seed) => {
    const next = random(seed);
    const rotation = anyRotation(seed);
    const hand = balls(scale3(towardsViewer(rotation), RADIUS));
    hand.view = { ...hand.view, rotation, fov: seed % 2 ? 0 : 30 };
    hand.surface = exactBall(hand);
    hand.select(['part-2']);
    const foot = footOf(hand, hand.selection, middleOf(hand))!;
    take(hand, 'surface', [480, 380]);
    for (let i = 0; i < 20; i++) {
      const way: Vec2 = [100 * (next() - 0.5), 100 * (next() - 0.5)];
      hand.move(480 + way[0], 380 + way[1]);
      const by = carriedBy(hand);
      const point = place3(by, foot.point);
      expect(Math.abs(length3(point) - RADIUS)).toBeLessThan(1e-9);
      expectNear(rotate3(by.rotation, foot.normal), scale3(point, 1 / RADIUS));
      const from = shown(hand, foot.point);
      const to = shown(hand, point);
      expectNear([to[0] - from[0], to[1] - from[1]], way, 6);
    }
  });

  it('beside it the foot goes on in the view plane through where it last lay, and comes back onto it', () => {
    const hand = balls();
    hand.surface = exactBall(hand);
    hand.select(['part-2']);
    const foot = footOf(hand, hand.selection, middleOf(hand))!;
    take(hand, 'surface');
    hand.move(400 + 80, 300);
    const last = carriedBy(hand);
    hand.move(400 + 300, 300 + 50);
    const beside = carriedBy(hand);
    expect(beside.rotation).toEqual(last.rotation);
    expect(place3(beside, foot.point)[2]).toBeCloseTo(place3(last, foot.point)[2], 9);
    expectNear(shown(hand, place3(beside, foot.point)), [700, 350], 6);
    hand.move(400 - 40, 300);
    expect(length3(place3(carriedBy(hand), foot.point))).toBeCloseTo(RADIUS, 9);
  });

  it('stands on the nearest point of the others, also where what is seen behind it lies elsewhere', () => {
    // On top of the ball: behind its middle is paper.
    const hand = balls([0, RADIUS + 6, 0]);
    hand.surface = exactBall(hand);
    hand.select(['part-2']);
    const foot = footOf(hand, hand.selection, middleOf(hand))!;
    // The ball is a mesh of 64 × 64: half a millimetre from round, at most.
    expectNear(foot.point, [0, RADIUS, 0], 0);
    expect(foot.normal[1]).toBeGreaterThan(0.99);
  });

  it('moves in the view plane when there is nothing else', () => {
    const hand = tubes(0);
    hand.select(['part-1']);
    take(hand, 'surface');
    hand.move(430, 300);
    expectNear(carriedBy(hand).translation, [10, 0, 0]);
  });
});

describe('a drag', () => {
  it('is shown while it lasts and one undo step when it ends', () => {
    const hand = tubes(0, 20);
    hand.select(['part-1']);
    const before = hand.document;
    take(hand, 'view');
    for (const x of [420, 440, 460]) hand.move(x, 300);
    expect(hand.document).toBe(before);
    const min = (document: typeof before) => bounds(solids(document)[0]!.mesh).min[0];
    expect(min(hand.state.preview!(hand)!)).toBeCloseTo(min(before) + 20, 4);
    hand.up();
    expect(hand.state).toBe(selecting);
    expect(hand.document.parts[0]!.placement.translation[0]).toBeCloseTo(20, 9);
    expect(hand.document.parts[1]).toBe(before.parts[1]);
    hand.undo();
    expect(hand.document).toBe(before);
  });

  it('that is cancelled, or comes to nothing, leaves no trace', () => {
    const hand = tubes(0);
    hand.select(['part-1']);
    const { history } = hand;
    take(hand, 'view');
    hand.up();
    take(hand, 'view');
    hand.move(600, 100);
    hand.cancel();
    expect(hand.state).toBe(selecting);
    expect(hand.history).toBe(history);
  });

  it('leaves hidden parts where they are, and takes nothing when all are hidden', () => {
    const hand = tubes(0, 20);
    hand.commit([{ type: 'showParts', ids: ['part-2'], visible: false }]);
    hand.select(['part-1', 'part-2']);
    take(hand, 'view');
    expect(hand.state.carried!.ids).toEqual(['part-1']);
    hand.cancel();
    hand.select(['part-2']);
    take(hand, 'view');
    expect(hand.state).toBe(selecting);
  });
});

describe('keys', () => {
  it.each(SEEDS)('go by whole millimetres to the right and up, or along the axis (seed %i)', (seed) => {
    const hand = balls([3, 4, 25]);
    hand.view = { ...hand.view, rotation: anyRotation(seed), fov: seed % 2 ? 0 : 30 };
    hand.select(['part-2']);
    const middle = middleOf(hand);
    for (const handle of ['view', 'x', 'y', 'z'] as const) {
      const axis = handle === 'view' ? null : AXIS[handle];
      if (axis && Math.abs(dot3(axis, towardsViewer(hand.view.rotation))) > 0.95) continue;
      take(hand, handle, penBeside(hand, handle, middle, 0, 0)!);
      hand.move(...penBeside(hand, handle, middle, 3, 2)!);
      const expected = axis ? scale3(axis, 5) : rotate3(hand.view.rotation, [3, 2, 0]);
      expectNear(sub3(carriedBy(hand).translation, expected), [0, 0, 0], 6);
      hand.cancel();
    }
  });
});

describe('the ring', () => {
  const held = (seed: number) => {
    const hand = balls([12, -7, 20]);
    hand.view = { ...hand.view, rotation: anyRotation(seed) };
    hand.select(['part-2']);
    return { hand, middle: middleOf(hand), at: shown(hand, middleOf(hand)) };
  };
  const around = ([x, y]: Vec2, degrees: number, px: number): Vec2 => {
    const angle = (degrees * Math.PI) / 180;
    return [x + px * Math.cos(angle), y - px * Math.sin(angle)];
  };

  it.each(SEEDS)('turns parts as far as the pen goes around their middle, which stays (seed %i)', (seed) => {
    const { hand, middle, at } = held(seed);
    take(hand, 'turn', around(at, 20, 150));
    hand.move(...around(at, 77, 90));
    const by = carriedBy(hand);
    expectNear(place3(by, middle), middle);
    // What lies beside the middle, as one looks, goes around it by as much.
    const right = rotate3(hand.view.rotation, [10, 0, 0]);
    const to = shown(hand, place3(by, [middle[0] + right[0], middle[1] + right[1], middle[2] + right[2]]));
    expectNear(to, around(at, 57, 30));
    expect(hand.state.carried!.degrees).toBeCloseTo(57, 9);
    hand.up();
    expect(hand.document.parts[0]!.placement.rotation).toEqual([0, 0, 0, 1]);
    hand.undo();
    expect(hand.document.parts[1]!.placement.rotation).toEqual([0, 0, 0, 1]);
  });

  it.each(SEEDS)(
    'tips parts about the screen’s own axes, and what is near goes with the pen (seed %i)',
    (seed) => {
      for (const [handle, dx, dy] of [
        ['turnX', 0, 60],
        ['turnY', 60, 0],
      ] as const) {
        const { hand, middle, at } = held(seed);
        take(hand, handle, at);
        hand.move(at[0] + dx, at[1] + dy);
        const by = carriedBy(hand);
        expectNear(place3(by, middle), middle);
        expect(hand.state.carried).toMatchObject({ degrees: 30, about: handle === 'turnX' ? 'x' : 'y' });
        // 10 mm before the middle, as one looks: half of that to the side, or down
        const ahead = rotate3(hand.view.rotation, [0, 0, 10]);
        const to = place3(by, [middle[0] + ahead[0], middle[1] + ahead[1], middle[2] + ahead[2]]);
        const wanted = rotate3(hand.view.rotation, [dx > 0 ? 5 : 0, dy > 0 ? -5 : 0, 10 * Math.sqrt(0.75)]);
        expectNear(to, [middle[0] + wanted[0], middle[1] + wanted[1], middle[2] + wanted[2]]);
      }
    },
  );

  it('turns in steps of 15° with Shift, and grows in tenths', () => {
    const { hand, at } = held(3);
    const adds = (place: Vec2) => {
      const pen = { x: place[0], y: place[1], pressure: 0.5, tiltX: 0, tiltY: 0, time: 0, adds: true };
      hand.state = hand.state.move!([{ ...pen, pointer: 'pen' }], hand) ?? hand.state;
    };
    take(hand, 'turn', around(at, 0, 100));
    adds(around(at, 52, 100));
    expect(hand.state.carried!.degrees).toBe(45);
    adds(around(at, 5, 100));
    expect(carriedBy(hand)).toEqual({ rotation: [0, 0, 0, 1], translation: [0, 0, 0] });
    hand.cancel();
    take(hand, 'scale', around(at, 0, 100));
    adds(around(at, 30, 133));
    expect(hand.state.carried!.factor).toBeCloseTo(1.3, 9);
  });

  it.each(SEEDS)('makes parts as much larger as the pen comes away, about their middle (seed %i)', (seed) => {
    const { hand, middle, at } = held(seed);
    const size = () => {
      const { min, max } = bounds(solids(hand.document)[1]!.mesh);
      return max[0] - min[0];
    };
    const before = size();
    take(hand, 'scale', around(at, 20, 100));
    hand.move(...around(at, 50, 170));
    hand.up();
    expectNear(middleOf(hand), middle, 6);
    expect(size() / before).toBeCloseTo(1.7, 3);
    hand.undo();
    expect(size()).toBe(before);
  });

  it('that is let go where it was taken does nothing', () => {
    for (const handle of ['turn', 'scale'] as const) {
      const { hand, at } = held(1);
      const { past } = hand.history;
      take(hand, handle, around(at, 0, 100));
      hand.move(...around(at, 40, 130));
      hand.move(...around(at, 0, 100));
      hand.up();
      expect(hand.history.past).toBe(past);
    }
  });

  it('is turned by degrees and scaled by hundredths with keys', () => {
    for (const handle of ['turn', 'scale'] as const) {
      const { hand, middle } = held(2);
      take(hand, handle, penBeside(hand, handle, middle, 0, 0)!);
      hand.move(...penBeside(hand, handle, middle, 0, 7)!);
      const { degrees, factor } = hand.state.carried!;
      expect(handle === 'turn' ? degrees : factor).toBeCloseTo(handle === 'turn' ? 7 : 1.07, 9);
    }
  });
});

describe('groups of a solid', () => {
  it('are moved with the plane of their strokes, turned and scaled, and the others stay', () => {
    const hand = new Driver();
    hand.history = newHistory(figure());
    const ear = () => solidOf(hand.document).groups[2]!;
    const others = () => solidOf(hand.document).groups.filter((group) => group !== ear());
    hand.select([ear().id]);
    const before = others();
    const middle = middleOf(hand);
    expectNear(middle, [-14, 52, 0]);
    take(hand, 'view', [300, 200]);
    hand.move(330, 230);
    hand.up();
    expectNear(middleOf(hand), [-4, 42, 0]);
    take(hand, 'turn', shown(hand, [10, 42, 0]));
    hand.move(...shown(hand, [-4, 60, 0]));
    hand.up();
    expectNear(ear().strokes[0]!.plane.x, [0, 1, 0]);
    take(hand, 'scale', shown(hand, [6, 42, 0]));
    hand.move(...shown(hand, [16, 42, 0]));
    hand.up();
    expectNear(middleOf(hand), [-4, 42, 0]);
    expect(boxOfGroup(ear()).max[1] - boxOfGroup(ear()).min[1]).toBeCloseTo(96, 9);
    expect(others()).toEqual(before);
  });
});
