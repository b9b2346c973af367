import type { Plane } from '../math/plane.ts';
import type { Quat, Vec3 } from '../math/vec.ts';

export type { Plane } from '../math/plane.ts';

/** mm: a kilometre. Nothing is drawn, moved or read from files that lies farther off along an axis. */
export const FARTHEST = 1e6;

/** Written so that what is not a number is out of reach. */
export const isInReach = (coordinates: readonly number[]): boolean =>
  coordinates.every((value) => Math.abs(value) <= FARTHEST);

/** One report of the pen, on the stroke's plane. */
export interface Sample {
  /** mm along the plane's x axis */
  readonly x: number;
  /** mm along the plane's y axis */
  readonly y: number;
  /** 0–1; 0.5 where the pointer has none */
  readonly pressure: number;
  /** degrees, −90–90 */
  readonly tiltX: number;
  readonly tiltY: number;
  /** ms since the first sample of the stroke */
  readonly time: number;
}

/** How the model was looked at. */
export interface View {
  /** the point that stays in the middle of the screen, mm */
  readonly pivot: Vec3;
  /** camera to world: the camera looks along −z, y is up */
  readonly rotation: Quat;
  /** visible height at the pivot, mm */
  readonly height: number;
  /** vertical opening in degrees; 0 = orthographic */
  readonly fov: number;
}

/** What a person drew: the raw truth from which everything else is derived. */
export interface Stroke {
  readonly samples: readonly Sample[];
  readonly plane: Plane;
  readonly view: View;
  readonly pointer: 'pen' | 'touch' | 'mouse';
  /** lifted near its start, while the closing line was shown: meant as a loop */
  readonly closed: boolean;
}
