/**
 * The images of one picture on the graphics device. Five of them would be 160 bytes a pixel: the first is kept, one more serves for those at other
 * places of the pixels, and what is not there any more when it is asked for is cast once more.
 */
import { OFFSETS } from '../field/rayEdges.ts';
import type { RayCamera } from '../field/rayImage.ts';
import type { DeviceImage, GpuRaycaster, PlacedBody } from '../gpu/raycast/raycaster.ts';
import type { SurfaceImage } from '../scene/index.ts';
import type { CastImages } from './caster.ts';

/** Room for one image, and whose it is now. */
export class Slot {
  #image: DeviceImage | null = null;
  #of: object | null = null;
  #number = 0;
  /** that were begun */
  #rows = 0;

  /** The image of that number of `of`, as far as it was begun; empty where it was another's. */
  image(raycaster: GpuRaycaster, of: object, number: number, { width, height }: RayCamera): DeviceImage {
    if (this.#image?.width !== width || this.#image.height !== height) {
      this.destroy();
      this.#image = raycaster.image(width, height);
    }
    if (this.#of !== of || this.#number !== number) this.#rows = 0;
    this.#of = of;
    this.#number = number;
    return this.#image;
  }

  /** Begins rows more of it, at most to its end. Returns how many rays. */
  go(raycaster: GpuRaycaster, bodies: readonly PlacedBody[], camera: RayCamera, rows: number): number {
    const to = Math.min(camera.height, this.#rows + rows);
    const rays = this.#image ? raycaster.cast(this.#image, bodies, camera, this.#rows, to) : 0;
    this.#rows = to;
    return rays;
  }

  /** Rows that were begun of that image. */
  rowsOf(of: object, number: number): number {
    return this.#of === of && this.#number === number ? this.#rows : 0;
  }

  destroy(): void {
    this.#image?.destroy();
    this.#image = null;
    this.#of = null;
  }
}

export class DeviceImages implements CastImages {
  readonly whole = 1 + OFFSETS.length;
  count = 0;
  share = 0;
  evaluationsAPixel: number | null = null;
  milliseconds = 0;
  /** once they are on the device */
  cast: { readonly raycaster: GpuRaycaster; readonly bodies: readonly PlacedBody[] } | null = null;
  readonly #camera: RayCamera;
  /** ids of the items */
  readonly #items: readonly string[];
  readonly #slots: readonly [first: Slot, other: Slot];
  #asked = 0;
  #heard: () => void = () => {};

  constructor(camera: RayCamera, items: readonly string[], slots: readonly [Slot, Slot]) {
    this.#camera = camera;
    this.#items = items;
    this.#slots = slots;
  }

  get known(): CastImages['known'] {
    return [0, this.count > 0 ? 1 : this.slot(0).rowsOf(this, 0) / (this.#camera.height + 1)];
  }

  image(number: number): SurfaceImage {
    const slot = this.slot(number);
    const camera = this.camera(number);
    const image = this.begun(number);
    // of the first what is there is enough as long as it is being cast
    if (this.cast && (number > 0 || this.count > 0))
      slot.go(this.cast.raycaster, this.cast.bodies, camera, camera.height);
    this.#asked = Math.max(this.#asked, number);
    this.#heard();
    const { surface, colours, stride } = image;
    return { camera, items: this.#items, surface, colours, stride };
  }

  camera(number: number): RayCamera {
    return number === 0 ? this.#camera : { ...this.#camera, offset: OFFSETS[number - 1]! };
  }

  slot(number: number): Slot {
    return this.#slots[Math.min(number, 1)]!;
  }

  /** As far as it is there. */
  begun(number: number): DeviceImage {
    if (!this.cast) throw new Error('no ray was cast yet');
    return this.slot(number).image(this.cast.raycaster, this, number, this.camera(number));
  }

  /** Until somebody asked for the image, or so many ms. */
  asked(number: number, milliseconds: number): Promise<void> {
    return new Promise((resolve) => {
      const timer = setTimeout(resolve, milliseconds);
      this.#heard = () => {
        if (this.#asked < number) return;
        clearTimeout(timer);
        resolve();
      };
      this.#heard();
    });
  }
}
