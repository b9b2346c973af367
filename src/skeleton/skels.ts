/** The data of skels: what documents and commands hold. Lengths in mm. */
import type { Vec2, Vec3 } from '../math/vec.ts';

export interface PointSkel {
  readonly type: 'point';
  readonly at: Vec3;
  readonly weight: number;
}

export interface SegmentSkel {
  readonly type: 'segment';
  readonly a: Vec3;
  readonly b: Vec3;
  /** w(t) = Σ weights[k] t^k, t in mm from a; degree 0–3 */
  readonly weights: readonly number[];
}

/** A region of a plane: loops[0] counter-clockwise, holes clockwise, in the frame (origin; u, v), which `bind` makes orthonormal. */
export interface PolygonSkel {
  readonly type: 'polygon';
  readonly origin: Vec3;
  readonly u: Vec3;
  readonly v: Vec3;
  readonly loops: readonly (readonly Vec2[])[];
  readonly weight: number;
}

export type Skel = PointSkel | SegmentSkel | PolygonSkel;
