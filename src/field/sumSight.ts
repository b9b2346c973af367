/** A sum as a ray sees it from a point on: the near terms by their bounds, the polynomial of the others exactly, in the frame of the leaf. */
import { AHEAD, clearAhead } from '../skeleton/ahead.ts';
import { Ball } from '../skeleton/ball.ts';
import { evaluateTaylor, type Taylor } from '../skeleton/taylor.ts';
import { TEST, WITH_GRADIENT } from '../skeleton/work.ts';
import { clearAlong, rangeAlong } from './cubeSight.ts';
import type { LeafFrame } from './leafFrame.ts';
import type { Near, Ray, Tally } from './near.ts';
import type { NearList } from './nearList.ts';
import { RayAhead } from './rayAhead.ts';

const ball = new Ball();

export class SumSight {
  readonly #frame: LeafFrame | null;
  readonly #tally: Tally;
  readonly #along = new RayAhead(new Float64Array(AHEAD));
  readonly #at = new Float64Array(3);
  #ray: Ray = [1, 0, 0];

  constructor(frame: LeafFrame | null, tally: Tally) {
    this.#frame = frame;
    this.#tally = tally;
  }

  /** Near.look */
  look(
    { terms, far: { centre, taylor } }: NearList,
    ray: Ray,
    x: number,
    y: number,
    z: number,
    reach: number,
  ): number {
    const frame = this.#frame;
    const along = this.#along;
    const { ahead } = along;
    this.#ray = ray;
    this.#at[0] = x;
    this.#at[1] = y;
    this.#at[2] = z;
    frame?.enter(x, y, z);
    const px = frame ? frame.x : x;
    const py = frame ? frame.y : y;
    const pz = frame ? frame.z : z;
    const [dx, dy, dz] = frame ? frame.along(ray) : ray;
    const scale = frame?.scale ?? 1;
    along.stretch = frame ? Math.sqrt(dx * dx + dy * dy + dz * dz) : 1;
    along.reach = reach;
    clearAhead(ahead);
    evaluateTaylor(taylor, px - centre[0], py - centre[1], pz - centre[2], ahead);
    ball.set(px, py, pz, reach * along.stretch);
    for (let i = 0; i < terms.length; i++) terms[i]!.field.ahead(ball, terms[i]!.factor, ahead);
    this.#tally.work += (WITH_GRADIENT + TEST) * terms.length;
    along.value = scale * ahead[0]!;
    along.slope = scale * (ahead[1]! * dx + ahead[2]! * dy + ahead[3]! * dz);
    along.curve = scale * curve(taylor, dx, dy, dz);
    along.scale = scale;
    return along.value;
  }

  clear(near: Near): number {
    const along = this.#along;
    return along.known > 0 ? along.clear() : clearAlong(rangeOf(near), this.#at, this.#ray, along.reach);
  }

  reached(clear: number): number {
    const along = this.#along;
    return along.known > 0 ? along.reached(clear) : Infinity;
  }

  around({ far: { taylor } }: NearList): number {
    const along = this.#along;
    if (!(along.known > 0)) return 0;
    const { ahead, scale } = along;
    const stretch = this.#frame?.reach(1) ?? 1;
    // the ray was told of what it meets, in its own direction
    along.reach *= along.stretch / stretch;
    along.stretch = stretch;
    const slope = Math.sqrt(ahead[1]! * ahead[1]! + ahead[2]! * ahead[2]! + ahead[3]! * ahead[3]!);
    return along.around(scale * stretch * slope, scale * stretch * stretch * most(taylor));
  }

  range(near: Near, t: number, out: Float64Array): void {
    const along = this.#along;
    if (t <= along.known) along.range(t, out);
    else rangeAlong(rangeOf(near), this.#at, this.#ray, t, out);
  }
}

const rangeOf = (near: Near) => (x: number, y: number, z: number, half: number, out: Float64Array) => {
  const { low, high } = near.within(x, y, z, half, 0);
  out[0] = low;
  out[1] = high;
};

/** The same to any side, at most. */
function most(c: Taylor): number {
  const square = (i: number) => c[i]! * c[i]!;
  return Math.sqrt(square(4) + square(5) + square(6) + 0.5 * (square(7) + square(8) + square(9)));
}

/** Half the second derivative of a polynomial. */
function curve(c: Taylor, x: number, y: number, z: number): number {
  return c[4]! * x * x + c[5]! * y * y + c[6]! * z * z + c[7]! * x * y + c[8]! * y * z + c[9]! * z * x;
}
