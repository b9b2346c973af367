/**
 * A cross section in the frame of its chord (thesis 5.4.2, t(v) = (x(v), z(v))): x runs from −1 at q_l to 1 at q_r, y out of the
 * drawing plane towards the person, both in half chords. Convex (drawn below a chord that runs left to right) is y > 0.
 */
import type { Vec2 } from '../math/vec.ts';

export interface Outline {
  /** v = 1 is v = 0: a front and a back. Open ones run from q_l (v = 0) to q_r (v = 1); of closed ones q_r is at v = ½ */
  readonly closed: boolean;
  /** ascending v at which the tangent jumps: creases along the surface. Open: inside (0, 1); closed: in [0, 1) */
  readonly corners: readonly number[];
  /** v in [0, 1] */
  point(v: number): Vec2;
  /** d point / dv; at a corner `side` says whether the one arriving (−1) or the one leaving (1) */
  derivative(v: number, side: -1 | 1): Vec2;
}
