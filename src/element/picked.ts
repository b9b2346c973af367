/** What is under a pen. */
import type { SkelAt } from '../field/skelAt.ts';
import type { Vec3 } from '../math/vec.ts';

/** A place of the model, and what is there. */
export interface Picked {
  /** of the part */
  readonly id: string;
  /** mm */
  readonly point: Vec3;
  /** unit, outward */
  readonly normal: Vec3;
  /** of a body; null on surfaces of strokes */
  readonly skel: SkelAt | null;
}
