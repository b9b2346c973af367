/**
 * Casts rays on the graphics device that the scene draws on, where the images stay: nothing is read back and nothing copied but into the
 * scene's own textures. Bands of rows that take the device no longer than a part of a frame follow each other, each after the one
 * before is done, so that frames in between are not late and nothing more is cast of what nobody waits for. Rays through other places of the
 * pixels are cast for all of them: finding edges would take a device longer than four more rays.
 */
import { OFFSETS } from '../field/rayEdges.ts';
import type { RayCamera } from '../field/rayImage.ts';
import { type GpuRaycaster, gpuRaycaster } from '../gpu/raycast/raycaster.ts';
import { taken } from '../gpu/taken.ts';
import type { Scene, SurfaceImage } from '../scene/index.ts';
import { TEST, WITH_GRADIENT } from '../skeleton/work.ts';
import type { View } from '../stroke/stroke.ts';
import { type Caster, type CastImages, type CastListener, MOST_RAYS, type ShownBody } from './caster.ts';
import { DeviceBodies } from './deviceBodies.ts';
import { DeviceImages, Slot } from './deviceImages.ts';
import { messageOf } from './events.ts';
import { Pace } from './pace.ts';

/** ms of rays between two frames */
const BAND = 8;
/** pixels along a side for a ray where something moves: what still looks like the surface */
const COARSER = [1, 2, 4] as const;
/** ms until an image that nobody draws makes room for the next */
const UNSEEN = 100;
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
  readonly #slots = [new Slot(), new Slot()] as const;
  readonly #live = new Slot();
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
    const casting = { images: new DeviceImages(camera, ids, this.#slots), listener };
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
    // each is another's: all of it is cast
    const { surface, colours, stride } = this.#live.image(raycaster, {}, 0, camera);
    const rays = this.#live.go(raycaster, placed, camera, camera.height);
    this.#share = rays / (camera.width * camera.height);
    this.#time(rays);
    return { camera, items: bodies.map(({ id }) => id), surface, colours, stride };
  }

  /** Bodies are kept. */
  stop(): void {
    this.#casting = null;
  }

  /** Images go, which are cast once more where they are asked for. */
  idle(): void {
    for (const slot of [...this.#slots, this.#live]) slot.destroy();
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
    images.cast = { raycaster, bodies: placed };
    for (let number = 0; number < images.whole; number++) {
      if (!(await this.#whole(casting, number))) return;
      if (number === 0) {
        images.milliseconds = performance.now() - start;
        const { terms } = await images.begun(0).work();
        if (!wanted()) return;
        images.evaluationsAPixel = ((WITH_GRADIENT + TEST) * terms) / (camera.width * camera.height);
      }
      images.count = number + 1;
      listener.changed();
      if (number > 0 && number < OFFSETS.length) await images.asked(number, UNSEEN);
    }
    if (wanted()) this.#casting = null;
  }

  /** All rows of an image, band by band; false when it was given up. */
  async #whole(casting: Casting, number: number): Promise<boolean> {
    const { images, listener } = casting;
    const camera = images.camera(number);
    const slot = images.slot(number);
    for (;;) {
      const { cast } = images;
      if (this.#casting !== casting || !cast) return false;
      // another image may have taken the room in between: then this one begins anew
      const { height } = images.begun(number);
      if (slot.rowsOf(images, number) >= height) return true;
      const rows = Math.ceil(this.#pace.rays(BAND) / (camera.width * Math.max(this.#density, SPARSE)));
      const before = slot.rowsOf(images, number);
      const start = performance.now();
      const rays = await taken(this.#device, 'rays', () =>
        slot.go(cast.raycaster, cast.bodies, camera, rows),
      );
      await this.#device.queue.onSubmittedWorkDone();
      this.#pace.hear(rays, performance.now() - start);
      this.#density = rays / (camera.width * Math.min(rows, height - before));
      if (this.#casting === casting && number === 0) {
        images.share = images.known[1];
        listener.changed();
      }
    }
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
    casting?.listener.refused(why);
  }
}
