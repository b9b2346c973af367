/** Who casts rays for the element: workers (rayWorker.ts), or a graphics device whose images stay on it (deviceRays.ts); rays.ts chooses. */
import type { FieldNode } from '../field/node.ts';
import type { RayCamera } from '../field/rayImage.ts';
import type { Placement } from '../math/placement.ts';
import type { Scene, SurfaceImage } from '../scene/index.ts';
import type { View } from '../stroke/stroke.ts';

/** A body, and the item of the scene that is its mesh. */
export interface ShownBody {
  readonly id: string;
  readonly node: FieldNode;
  readonly placement: Placement;
  /** of its lattice, along the longest side */
  readonly cells: number;
}

/** rays a picture: larger ones have a ray for several pixels */
export const MOST_RAYS = 2.4e6;

/** of a pixel: where its first ray is */
export const MIDDLE = [0.5, 0.5] as const;

/** What has been found for one picture so far. */
export interface CastImages {
  /** images that are whole, and how many there will be */
  readonly count: number;
  readonly whole: number;
  /** rows of the first that are there, from … to …, 0–1 from the top */
  readonly known: readonly [from: number, to: number];
  /** rows of all that nobody could cast, all between the first and the last of these, in the same way: triangles are seen there */
  readonly lost?: readonly [from: number, to: number] | null;
  /** 0–1 of what is being done until the first is whole */
  readonly share: number;
  /** of the first image, in values of one skel; null until it is whole */
  readonly evaluationsAPixel: number | null;
  /** that the first image took */
  readonly milliseconds: number;
  /** The first, 0, is through the middle of the pixels, and there in part before it is whole. */
  image(number: number): SurfaceImage;
  /** Nobody asks for images any more: what they lie on is given back. */
  drop?(): void;
}

export interface CastListener {
  /** there is more */
  changed(): void;
  /** there is no room for it: images that can be cast again are given back; false: there are none */
  spare?(): boolean;
  /** there will be nothing more, in words; `trees`: whose fault that is, where it is known, and will be the next time, too */
  refused(why: string, trees?: readonly FieldNode[]): void;
}

export interface Caster {
  /** What was wanted before is given up, and nothing more is told of it. */
  cast(bodies: readonly ShownBody[], camera: RayCamera, listener: CastListener): CastImages;
  /**
   * An image within so many ms, with as many rays as they allow, beside what is wanted; null: it takes longer. It holds until the next.
   */
  live?(
    bodies: readonly ShownBody[],
    view: View,
    pixels: Scene['pixels'],
    milliseconds: number,
  ): SurfaceImage | null;
  /** Nothing is wanted for now. */
  stop(): void;
  /** Nothing was wanted for long: what can be made again goes. */
  idle?(): void;
  /** Nothing is kept either; what was wanted is refused. */
  end(): void;
}
