/**
 * A front and a back as one closed outline: the front on v 0 … ½, the back on ½ … 1.
 *
 * A mirrored front encloses what lies between it and its mirror image, whichever of the two is before the other: the front
 * is |y|, at least a thousandth of the half chord. So hollow fronts are not turned inside out, lobes of fronts that cross the
 * chord hang together by a web, and a straight front makes a plate: all of them solids, which y and −y alone are not.
 * A back that is drawn may cross the front: then they change places (uncrossed.ts).
 */
import { dot2, length2, scale2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import { type Outline, roundHalf } from './outline.ts';
import { uncrossed } from './uncrossed.ts';

/** half the thickness of plates and webs, in half chords */
const PLATE = 1e-3;
/** cos 30°: fronts and backs that meet at a smaller angle run smoothly into each other */
const SMOOTH = 0.866;
/** places at which a front is looked at for crossings of the chord */
const LOOKS = 256;
/** v nearer to a crossing than this are on it */
const AT = 1e-6;

/** Closed. A back that is drawn runs from q_l to q_r too. Corners at the ends only where the two meet at an angle. */
export function joined(front: Outline, drawn: Outline | 'mirror'): Outline {
  const back = drawn !== 'mirror' && isMirrored(front, drawn) ? 'mirror' : drawn;
  const over = back === 'mirror' ? raised(front) : front;
  const under = back === 'mirror' ? mirrored(over) : back;
  const seam = (end: 0 | 1): Vec2 | null => {
    const across = over.derivative(end, end === 0 ? 1 : -1);
    const [x, y] = under.derivative(end, end === 0 ? 1 : -1);
    return smooth(across, [-x, -y]);
  };
  const seams = [seam(0), seam(1)] as const;
  return uncrossed({
    closed: true,
    corners: [
      ...(seams[0] ? [] : [0]),
      ...over.corners.map((v) => v / 2),
      ...(seams[1] ? [] : [0.5]),
      ...under.corners.map((v) => 1 - v / 2).sort((a, b) => a - b),
    ],
    point: (v) => {
      const w = v - Math.floor(v);
      return w <= 0.5 ? over.point(2 * w) : under.point(2 * (1 - w));
    },
    derivative: (v, side) => {
      const w = v - Math.floor(v);
      const atSeam = w === 0 ? seams[0] : w === 0.5 ? seams[1] : null;
      if (atSeam) return scale2(atSeam, 2);
      const isFront = w === 0 ? side === 1 : w < 0.5 || (w === 0.5 && side === -1);
      return isFront
        ? scale2(over.derivative(2 * w, side), 2)
        : scale2(under.derivative(w === 0 ? 0 : 2 * (1 - w), side === 1 ? -1 : 1), -2);
    },
  });
}

/** A back is the mirror image of a front that crosses the chord: as they are they go round an eight, which has no inside. */
function isMirrored(front: Outline, back: Outline): boolean {
  const vs = Array.from({ length: LOOKS }, (_, i) => i / LOOKS);
  const heights = vs.map((v) => front.point(v)[1]);
  if (!(Math.max(...heights) > PLATE && Math.min(...heights) < -PLATE)) return false;
  return vs.every((v) => {
    const [[x, y], [bx, by]] = [front.point(v), back.point(v)];
    return Math.abs(x - bx) < PLATE && Math.abs(y + by) < PLATE;
  });
}

/** The circle of rotational surfaces. */
export const round: Outline = joined(roundHalf, 'mirror');

/** The mean of two derivatives in nearly one direction; null where there is a corner. */
function smooth(a: Vec2, b: Vec2): Vec2 | null {
  const [p, q] = [length2(a), length2(b)];
  if (!(p > 0 && q > 0)) return null;
  if (!(dot2(a, b) > SMOOTH * p * q)) return null;
  const sum: Vec2 = [a[0] / p + b[0] / q, a[1] / p + b[1] / q];
  return scale2(sum, (p + q) / 2 / length2(sum));
}

function mirrored({ corners, point, derivative }: Outline): Outline {
  const flip = ([x, y]: Vec2): Vec2 => [x, -y];
  return {
    closed: false,
    corners,
    point: (v) => flip(point(v)),
    derivative: (v, side) => flip(derivative(v, side)),
  };
}

/** |y|, never thinner than a plate; corners where the front goes through the chord. */
function raised(front: Outline): Outline {
  const floor = (v: number): number => 4 * PLATE * v * (1 - v);
  const found = crossings(front, floor).filter((at) => front.corners.every((v) => Math.abs(v - at.v) > AT));
  const signOf = (v: number, side: -1 | 1): number => {
    const crossing = found.find((at) => Math.abs(at.v - v) < AT);
    if (crossing) return side === 1 ? -crossing.before : crossing.before;
    const [, y] = front.point(v);
    return Math.abs(y) < floor(v) ? 0 : y < 0 ? -1 : 1;
  };
  return {
    closed: false,
    corners: [...front.corners, ...found.map(({ v }) => v)].sort((a, b) => a - b),
    point: (v) => {
      const [x, y] = front.point(v);
      return [x, Math.max(Math.abs(y), floor(v))];
    },
    derivative: (v, side) => {
      const [dx, dy] = front.derivative(v, side);
      // at the ends y is 0, whichever side it comes from
      const sign = v <= 0 || v >= 1 ? endSign(dy, v) : signOf(v, side);
      return [dx, sign === 0 ? 4 * PLATE * (1 - 2 * v) : sign * dy];
    },
  };
}

/** The sign that y has just inside of an end. */
function endSign(dy: number, v: number): number {
  if (Math.abs(dy) < 4 * PLATE) return 0;
  return dy > 0 === v <= 0 ? 1 : -1;
}

/** v at which a front goes from one side of the chord to the other, and the sign it had before. */
function crossings(front: Outline, floor: (v: number) => number): { v: number; before: number }[] {
  const found: { v: number; before: number }[] = [];
  let before = 0;
  let from = 0;
  for (let i = 1; i < LOOKS; i++) {
    const v = i / LOOKS;
    const [, y] = front.point(v);
    if (Math.abs(y) <= floor(v)) continue;
    const sign = Math.sign(y);
    if (before === -sign) found.push({ v: bisected(front, from, v, before), before });
    before = sign;
    from = v;
  }
  return found;
}

function bisected(front: Outline, from: number, to: number, before: number): number {
  let [low, high] = [from, to];
  for (let step = 0; step < 40; step++) {
    const middle = (low + high) / 2;
    if (front.point(middle)[1] * before > 0) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}
