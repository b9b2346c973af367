/** What bounds on a skel's field need to know of it: once, and from the centre of a ball. Kernel units. */
import type { Dimension } from '../kernel/change.ts';
import type { Ball } from './ball.ts';

export interface Extent {
  readonly dimension: Dimension;
  /** length or area, as often as it is gone round; 1 for points */
  readonly size: number;
  readonly turns: number;
  /** a bound on |w| */
  readonly most: number;
  /** 1 or −1 where w has one sign, else 0 */
  readonly sign: number;
  /** the largest |w| over the least, Infinity where that is not known */
  readonly evenness: number;
}

/** A skel seen from the centre of a ball; kernel units. Mutable: filled again for each ball. */
export class Sight {
  /** of the skel, not more than it is */
  distance = 0.5;
  /** whether the whole ball is where singular kernels are not clamped: off the line of a segment, off the plane of a plate */
  isClear = true;
  /** of values: what sums over edges leave of the field elsewhere */
  slack = 0.5;
}

/** What each kind of skel brings: fills the sight of it from a ball. */
export type See = (ball: Ball, sight: Sight) => void;
