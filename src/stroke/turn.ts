/**
 * How far a path turns at a place, and how much of that is a jump.
 *
 * Theory: let an arm leave the place forwards and one backwards, both of length a. Their directions differ by
 * θ = J + a κ on a path of curvature κ whose tangent jumps by J there, while each arm's far half differs from its near
 * half by a κ / 2. So J = θ − (both inner turns): 0 on any arc, θ at a corner, whatever the curvature beside it.
 */

import { atan2 } from '../math/trig.ts';
import { cross2, dot2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';

export interface Turn {
  /** radians, positive to the left */
  readonly turn: number;
  /** the part of it that happens in the place itself, radians */
  readonly jump: number;
}

/** From the directions of the near and far halves of both arms and of the whole arms, all in drawing direction. */
export function turnOf(
  arriving: { readonly far: Vec2; readonly near: Vec2; readonly whole: Vec2 },
  leaving: { readonly near: Vec2; readonly far: Vec2; readonly whole: Vec2 },
): Turn {
  const turn = angle(arriving.whole, leaving.whole);
  const inner = angle(arriving.far, arriving.near) + angle(leaving.near, leaving.far);
  return { turn, jump: turn - inner };
}

/** The same from five points: two arms' ends, their middles and the place between. */
export function turnAtPoint(points: readonly [Vec2, Vec2, Vec2, Vec2, Vec2]): Turn {
  const [a, b, c, d, e] = points;
  return turnOf(
    { far: sub2(b, a), near: sub2(c, b), whole: sub2(c, a) },
    { near: sub2(d, c), far: sub2(e, d), whole: sub2(e, c) },
  );
}

/** From direction p to direction q, −π…π. */
export function angle(p: Vec2, q: Vec2): number {
  return atan2(cross2(p, q), dot2(p, q));
}

/**
 * Is it a corner: turned by more than `least` (radians), enough of it on the spot? The share asked for falls with the turn,
 * from two thirds at 45° to a third at 120°: the jump of an arc is 0 with an error that the tremble decides and not the
 * turn, and missed samples bevel a sharp corner, which takes part of its jump. Shares of a half or of 0.55 lose more
 * corners and find more false ones.
 */
export function isSharp({ turn, jump }: Turn, least: number): boolean {
  const size = Math.abs(turn);
  return size > least && jump * Math.sign(turn) >= 0.45 + 0.1 * size;
}
