/** What bends walk along: the axis l(u) of a sheet as a side view shows it (bendAxis.ts says which way of walking it is). */
import type { Vec2 } from '../math/vec.ts';

export interface Axis {
  /** mm of way, above 0 */
  readonly length: number;
  /** where the way is at 0 and at `length`, mm in the side view */
  readonly ends: readonly [Vec2, Vec2];
  /** T_l is the same everywhere */
  readonly straight: boolean;
  /** the way closes on itself */
  readonly closed: boolean;
  /** ascending u between which all is smooth */
  readonly breaks: readonly number[];
  /** `side`: at a break, the directions before (−1) or after (1) it */
  at(u: number, side: -1 | 1): AxisPoint;
}

/** Each is computed when asked for: of spines bent one on another hardly more than one is needed at a time. */
export interface AxisPoint {
  /** mm walked, 0 … length */
  walked(): number;
  /** its derivative by u; negative where the way turns back */
  speed(): number;
  /** the point of the axis to which the section belongs, mm, and its derivative by u */
  point(): Vec2;
  rate(): Vec2;
  /** T_l, unit */
  direction(): Vec2;
}
