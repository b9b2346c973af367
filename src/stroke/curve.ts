import type { Vec2 } from '../math/vec.ts';

/**
 * A filtered stroke, parametrised by arc length: u in [0, 1] runs evenly along the curve.
 * Surfaces know strokes only through this contract.
 */
export interface Curve {
  readonly closed: boolean;
  /** mm */
  readonly length: number;
  /** ascending u at which the tangent jumps; open curves: inside (0, 1); closed: in [0, 1) */
  readonly corners: readonly number[];
  /** mm on the plane; closed curves take any u, open ones clamp */
  point(u: number): Vec2;
  /** unit tangent; at a corner `side` says whether the one arriving (−1) or the one leaving (1, default) */
  tangent(u: number, side?: -1 | 1): Vec2;
  /** pen pressure, 0–1, smoothed */
  pressure(u: number): number;
}
