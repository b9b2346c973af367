/**
 * The images of one picture on the graphics device: each stays until nobody asks for it any more, so that another style or a file casts none
 * anew. That is 32 bytes a pixel and image, at most 384 MB of five (`MOST_RAYS`), and as much again while a file of another size is made beside the
 * screen, whose images go where there is no room for both (`CastListener.spare`); fewer rooms were tried, and cast what another image had taken the
 * place of once more, in a frame that was late by that.
 */
import { OFFSETS } from '../field/rayEdges.ts';
import type { RayCamera } from '../field/rayImage.ts';
import type { DeviceImage, GpuRaycaster } from '../gpu/raycast/raycaster.ts';
import type { SurfaceImage } from '../scene/index.ts';
import type { CastImages } from './caster.ts';

export class DeviceImages implements CastImages {
  readonly whole = 1 + OFFSETS.length;
  count = 0;
  share = 0;
  evaluationsAPixel: number | null = null;
  milliseconds = 0;
  /** that are there of the first */
  rows = 0;
  readonly #camera: RayCamera;
  /** ids of the items */
  readonly #items: readonly string[];
  readonly #made: DeviceImage[] = [];

  constructor(camera: RayCamera, items: readonly string[]) {
    this.#camera = camera;
    this.#items = items;
  }

  get known(): CastImages['known'] {
    // what rays that were given up have left out is known at the end
    return [0, this.count > 0 ? 1 : this.rows / (this.#camera.height + 1)];
  }

  image(number: number): SurfaceImage {
    const { surface, colours, stride } = this.#made[number]!;
    return { camera: this.camera(number), items: this.#items, surface, colours, stride };
  }

  camera(number: number): RayCamera {
    return number === 0 ? this.#camera : { ...this.#camera, offset: OFFSETS[number - 1]! };
  }

  /** Room for the next one; what the device refuses is told to its error scopes. */
  begin(raycaster: Pick<GpuRaycaster, 'image'>): DeviceImage {
    const { width, height } = this.#camera;
    const image = raycaster.image(width, height);
    this.#made.push(image);
    return image;
  }

  /** There are none, as if none had been. */
  drop(): void {
    this.count = 0;
    this.rows = 0;
    for (const image of this.#made.splice(0)) image.destroy();
  }
}
