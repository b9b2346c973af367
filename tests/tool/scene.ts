/** Kept parts for tests of tools, and a sphere that is exactly round to slide on. */
import type { Command } from '../../src/document/command/index.ts';
import { dot3, length3, rotate3, scale3 } from '../../src/math/tuple.ts';
import type { Quat, Vec3 } from '../../src/math/vec.ts';
import { rayAt } from '../../src/stroke/plane.ts';
import type { Viewport } from '../../src/tool/viewport.ts';
import { halfCircle, line } from '../document/strokes.ts';
import { random } from '../fixtures/random.ts';
import { Driver } from './driver.ts';

const KEEP: Command = { type: 'keep' };

/** mm */
export const RADIUS = 30;

/** part-1 is a ball around the origin, part-2 a ball of 8 mm whose middle is `at`. */
export function balls(at: Vec3 = [0, 0, RADIUS]): Driver {
  const hand = new Driver();
  const ball = (radius: number): Command[] => [
    { type: 'addStroke', stroke: halfCircle(radius, -1) },
    { type: 'addStroke', stroke: halfCircle(radius, 1) },
    KEEP,
  ];
  const by = { rotation: [0, 0, 0, 1], translation: at } as const;
  hand.commit([...ball(RADIUS), ...ball(8), { type: 'moveParts', ids: ['part-2'], by }]);
  return hand;
}

/** Upright tubes, a part each, in mm from the middle. */
export function tubes(...xs: readonly number[]): Driver {
  const hand = new Driver();
  hand.commit(xs.flatMap((x): Command[] => [{ type: 'addStroke', stroke: line(x) }, KEEP]));
  return hand;
}

/** What is under the pen of part-1, if that is exactly a ball; nothing else is there. */
export function exactBall(hand: Driver): Viewport['pick'] {
  return (x, y) => {
    const { origin, direction } = rayAt(hand.view, hand.size, x, y);
    const half = dot3(origin, direction);
    const root = half * half - dot3(origin, origin) + RADIUS * RADIUS;
    if (root < 0) return null;
    const t = -half - Math.sqrt(root);
    const p: Vec3 = [0, 1, 2].map((k) => origin[k]! + t * direction[k]!) as unknown as Vec3;
    // Rays start far away, which costs digits: back onto the ball.
    const normal = scale3(p, 1 / length3(p));
    return { point: scale3(normal, RADIUS), normal, id: 'part-1' };
  };
}

/** Any way to look at the middle. */
export function anyRotation(seed: number): Quat {
  const next = random(seed);
  const raw = [next() - 0.5, next() - 0.5, next() - 0.5, next() - 0.5] as const;
  const length = Math.hypot(...raw);
  return [raw[0] / length, raw[1] / length, raw[2] / length, raw[3] / length];
}

export const towardsViewer = (rotation: Quat): Vec3 => rotate3(rotation, [0, 0, 1]);
