import type { SkelAt } from '../field/skelAt.ts';
import type { Vec3 } from '../math/vec.ts';
import type { View } from '../stroke/stroke.ts';

/** A point of the model under the pen. */
export interface Hit {
  readonly point: Vec3;
  /** of the surface there: unit, outward */
  readonly normal: Vec3;
  /** of the part or of the unfinished form */
  readonly id: string;
  /** of bodies and solids: whose surface it is, where that is known */
  readonly skel?: SkelAt | null;
}

/** How a tool sees the picture. Positions are CSS pixels from the upper left of the canvas, y down. */
export interface Viewport {
  readonly size: { readonly width: number; readonly height: number };
  readonly view: View;
  /** What the camera is on its way to; at rest the view. */
  readonly goal: View;
  /** The parts of the picture, 0–1, that controls cover at its sides while a tool has a card; where there are none it is missing. */
  room?(): {
    readonly left: number;
    readonly top: number;
    readonly right: number;
    readonly bottom: number;
  };
  /** What is nearest under the pen; `except` are ids that it looks through. */
  pick(x: number, y: number, except?: readonly string[]): Hit | null;
}
