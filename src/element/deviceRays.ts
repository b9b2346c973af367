/**
 * Casts rays on the graphics device that the scene draws on, where the images stay: nothing is read back and nothing copied but into the
 * scene's own textures. Bands of rows that take the device no longer than a part of a frame follow each other, each after the one
 * before is done, so that frames in between are not late and nothing more is cast of what nobody waits for. Rays through other places of the
 * pixels are cast for all of them: finding edges would take a device longer than four more rays.
 */
import type { RayCamera } from '../field/rayImage.ts';
import {
  type DeviceImage,
  type GpuRaycaster,
  gpuRaycaster,
  type PlacedBody,
} from '../gpu/raycast/raycaster.ts';
import { taken } from '../gpu/taken.ts';
import type { Scene, SurfaceImage } from '../scene/index.ts';
import { TEST, WITH_GRADIENT } from '../skeleton/work.ts';
import type { View } from '../stroke/stroke.ts';
import { type Caster, type CastImages, type CastListener, MOST_RAYS, type ShownBody } from './caster.ts';
import { DeviceBodies } from './deviceBodies.ts';
import { DeviceImages } from './deviceImages.ts';
import { messageOf } from './events.ts';
import { Pace } from './pace.ts';

/** ms of rays between two frames */
const BAND = 8;
/** pixels along a side for a ray where something moves: what still looks like the surface */
const COARSER = [1, 2, 4] as const;
/** rays a pixel: what the next picture or band has at least, though the last one was paper */
const SPARSE = 0.25;
const MIDDLE = [0.5, 0.5] as const;

interface Casting {
  readonly images: DeviceImages;
  readonly listener: CastListener;
}

/** What is there once all pipelines are. */
interface Ready {
  readonly raycaster: GpuRaycaster;
  readonly bodies: DeviceBodies;
}

export class DeviceRays implements Caster {
  readonly #device: GPUDevice;
  #live: DeviceImage | null = null;
  readonly #pace = new Pace();
  #loading: Promise<Ready> | null = null;
  #ready: Ready | null = null;
  /** null: nothing is wanted, or all of it is there */
  #casting: Casting | null = null;
  /** the same of the last band */
  #density = 1;
  /** rays a pixel of the last live image: bodies do not fill it, or cover each other */
  #share = 1;
  /** a live image is being timed */
  #isTimed = false;
  #isGone = false;

  constructor(device: GPUDevice) {
    this.#device = device;
  }

  cast(bodies: readonly ShownBody[], camera: RayCamera, listener: CastListener): CastImages {
    const ids = bodies.map(({ id }) => id);
    const casting = { images: new DeviceImages(camera, ids), listener };
    this.#casting = casting;
    void this.#run(casting, bodies, camera).catch((error: unknown) => {
      if (this.#casting === casting) this.#refuse(messageOf(error));
    });
    return casting.images;
  }

  live(
    bodies: readonly ShownBody[],
    view: View,
    pixels: Scene['pixels'],
    milliseconds: number,
  ): SurfaceImage | null {
    const placed = this.#ready?.bodies.known(bodies);
    const takes =
      this.#pace.milliseconds(Math.max(this.#share, SPARSE) * pixels.width * pixels.height) ?? Infinity;
    const fits = (side: number) => pixels.width * pixels.height <= MOST_RAYS * side * side;
    const coarser = COARSER.find((side) => takes <= milliseconds * side * side && fits(side));
    if (!placed || coarser === undefined || !this.#ready) return null;
    const { raycaster } = this.#ready;
    const side = (length: number) => Math.max(1, Math.round(length / coarser));
    const camera = { view, width: side(pixels.width), height: side(pixels.height), offset: MIDDLE };
    const { width, height } = camera;
    if (this.#live?.width !== width || this.#live.height !== height) {
      this.#live?.destroy();
      this.#live = raycaster.image(width, height);
    }
    const { surface, colours, stride } = this.#live;
    const rays = raycaster.cast(this.#live, placed, camera);
    this.#share = rays / (camera.width * camera.height);
    this.#time(rays);
    return { camera, items: bodies.map(({ id }) => id), surface, colours, stride };
  }

  /** Bodies are kept. */
  stop(): void {
    this.#casting = null;
  }

  /** Pictures that somebody looks at stay. */
  idle(): void {
    this.#live?.destroy();
    this.#live = null;
  }

  end(): void {
    this.#isGone = true;
    this.#refuse('given up');
    this.idle();
    void this.#loading?.then(
      async ({ raycaster, bodies }) => {
        await bodies.destroy();
        raycaster.destroy();
      },
      () => {},
    );
  }

  async #run(casting: Casting, shown: readonly ShownBody[], camera: RayCamera): Promise<void> {
    const { images, listener } = casting;
    const wanted = () => this.#casting === casting;
    const { raycaster, bodies } = await this.#load();
    const placed = await bodies.ready(shown, wanted, (share) => {
      images.share = share;
      listener.changed();
    });
    if (!wanted()) return;
    if (!placed) throw new Error('its bodies are gone');
    const start = performance.now();
    for (let number = 0; number < images.whole; number++) {
      const image = await this.#whole(casting, number, raycaster, placed);
      if (!image) return;
      if (number === 0) {
        images.milliseconds = performance.now() - start;
        const { terms } = await image.work();
        if (!wanted()) return;
        images.evaluationsAPixel = ((WITH_GRADIENT + TEST) * terms) / (camera.width * camera.height);
      }
      images.count = number + 1;
      listener.changed();
    }
    if (wanted()) this.#casting = null;
  }

  /** All rows of an image, band by band; null when it was given up. */
  async #whole(
    casting: Casting,
    number: number,
    raycaster: GpuRaycaster,
    bodies: readonly PlacedBody[],
  ): Promise<DeviceImage | null> {
    const { images, listener } = casting;
    const camera = images.camera(number);
    const { width, height } = camera;
    if (this.#casting !== casting) return null;
    const image = await taken(this.#device, 'an image', () => images.begin(raycaster));
    for (let row = 0; row < height; ) {
      if (this.#casting !== casting) return null;
      const rows = Math.ceil(this.#pace.rays(BAND) / (width * Math.max(this.#density, SPARSE)));
      const end = Math.min(row + rows, height);
      const start = performance.now();
      const rays = await taken(this.#device, 'rays', () => raycaster.cast(image, bodies, camera, row, end));
      await this.#device.queue.onSubmittedWorkDone();
      this.#pace.hear(rays, performance.now() - start);
      this.#density = rays / (width * (end - row));
      row = end;
      if (this.#casting !== casting) return null;
      if (number > 0) continue;
      images.rows = row;
      images.share = images.known[1];
      listener.changed();
    }
    return image;
  }

  #load(): Promise<Ready> {
    this.#loading ??= gpuRaycaster(this.#device).then((raycaster) => {
      const ready = { raycaster, bodies: new DeviceBodies(raycaster) };
      if (!this.#isGone) this.#ready = ready;
      return ready;
    });
    return this.#loading;
  }

  #time(rays: number): void {
    if (this.#isTimed) return;
    this.#isTimed = true;
    const start = performance.now();
    const done = () => {
      this.#isTimed = false;
    };
    void this.#device.queue.onSubmittedWorkDone().then(() => {
      this.#pace.hear(rays, performance.now() - start);
      done();
    }, done);
  }

  #refuse(why: string): void {
    const casting = this.#casting;
    this.#casting = null;
    casting?.images.drop();
    casting?.listener.refused(why);
  }
}
