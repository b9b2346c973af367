/**
 * Surfaces as an image that rays were cast for, instead of triangles: what the worker hands over as arrays (field/rayScene.ts), or compute
 * passes leave in buffers of the scene's own device.
 */
import type { RayCamera } from '../field/rayImage.ts';

/** Floats a pixel, in both. */
export const CHANNELS = 4;

export interface SurfaceImage {
  /** how it was looked at: the picture is drawn just so */
  readonly camera: RayCamera;
  /** ids of the items that it stands for, whose triangles are not drawn */
  readonly items: readonly string[];
  /**
   * Four f32 a pixel, rows from the top: unit outward normal in the model, and mm that the surface lies before the plane of the pivot;
   * NOWHERE where there is none. Buffers have the usage COPY_SRC, and rows of `stride` pixels.
   */
  readonly surface: Float32Array | GPUBuffer;
  /** Four f32 a pixel: red green blue (0–1, linear), and 1 + the place among `items`; 0 where there is no surface. */
  readonly colours: Float32Array | GPUBuffer;
  /** Rows, from … to …, 0–1 from the top, in which triangles are to be seen after all; null: none. */
  readonly lost?: readonly [from: number, to: number] | null;
  /** of buffers, pixels from row to row, a multiple of 16; the width where there is none */
  readonly stride?: number;
}
