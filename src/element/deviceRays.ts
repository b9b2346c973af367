/**
 * Casts rays on the graphics device that the scene draws on, where the images stay: nothing is read back and nothing copied but into the
 * scene's own textures. Bands of rows that take the device no longer than a part of a frame follow each other, each after the one
 * before is done, so that frames in between are not late and nothing more is cast of what nobody waits for. Rays through other places of the
 * pixels are cast for all of them: finding edges would take a device longer than four more rays.
 *
 * A ray that was given up is a hole in the picture: how many there were is read back with each image, and where there was one the whole picture is
 * left to who knows no limit; which pixels they were no image says.
 *
 * What the device has no room for beside the images of the screen is tried once more without them; as many rays are then asked of it again only
 * when all have rested.
 */
import type { FieldNode } from '../field/node.ts';
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
import type { Caster, CastImages, CastListener, ShownBody } from './caster.ts';
import { blamed } from './deviceBlame.ts';
import { DeviceBodies, TreesRefused } from './deviceBodies.ts';
import { DeviceImages } from './deviceImages.ts';
import { DeviceLive } from './deviceLive.ts';
import { messageOf } from './events.ts';
import { Pace, SPARSE } from './pace.ts';

/** ms of rays between two frames */
const BAND = 8;

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
  readonly #told: (why: string) => void;
  readonly #load: typeof gpuRaycaster;
  readonly #pace = new Pace();
  readonly #live: DeviceLive;
  #loading: Promise<Ready> | null = null;
  #ready: Ready | null = null;
  /** null: nothing is wanted, or all of it is there */
  #casting: Casting | null = null;
  /** rays a pixel of the last band: bodies do not fill it, or cover each other */
  #density = 1;
  #isGone = false;
  #hasTold = false;
  /** rays of a picture that no body was to blame for: as many are too many until all have rested */
  #tooMany = Infinity;

  /** `told`: once, why the device casts less than it was asked for. */
  constructor(device: GPUDevice, told: (why: string) => void = () => {}, load = gpuRaycaster) {
    this.#device = device;
    this.#told = told;
    this.#load = load;
    this.#live = new DeviceLive(device, this.#pace, (why) => this.#tell(why));
  }

  cast(bodies: readonly ShownBody[], camera: RayCamera, listener: CastListener): CastImages {
    const ids = bodies.map(({ id }) => id);
    const casting = { images: new DeviceImages(camera, ids), listener };
    this.#casting = casting;
    void this.#run(casting, bodies, camera).catch((error: unknown) => {
      if (this.#casting !== casting) return;
      this.#refuse(messageOf(error), error instanceof TreesRefused ? error.trees : []);
      this.#tell(messageOf(error));
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
    if (!placed || !this.#ready) return null;
    const items = bodies.map(({ id }) => id);
    return this.#live.image(this.#ready.raycaster, { bodies: placed, items, view, pixels }, milliseconds);
  }

  /** Bodies are kept. */
  stop(): void {
    this.#casting = null;
  }

  /** Pictures that somebody looks at stay; what was too much then need not be any more. */
  idle(): void {
    this.#tooMany = Infinity;
    this.#live.idle();
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
    if (camera.width * camera.height >= this.#tooMany) throw new Error('as many rays were refused before');
    const { raycaster, bodies } = await this.#loaded();
    const placed = await bodies.ready(shown, wanted, (share) => {
      images.share = share;
      listener.changed();
    });
    if (!wanted()) return;
    if (!placed) throw new Error('its bodies are gone');
    const all = () => this.#all(casting, raycaster, placed);
    const blame = async (error: unknown): Promise<never> => {
      images.drop();
      const isBlamed = await blamed(this.#device, raycaster, placed, camera);
      const trees = shown.filter((_, i) => isBlamed[i]).map(({ node }) => node);
      if (trees.length === 0) this.#tooMany = Math.min(this.#tooMany, camera.width * camera.height);
      throw new TreesRefused(messageOf(error), trees);
    };
    await all().catch((error: unknown) => {
      images.drop();
      return wanted() && listener.spare?.() ? all().catch(blame) : blame(error);
    });
    if (wanted()) this.#casting = null;
  }

  /** All images, one after the other, as long as they are wanted. */
  async #all(casting: Casting, raycaster: GpuRaycaster, placed: readonly PlacedBody[]): Promise<void> {
    const { images, listener } = casting;
    const wanted = () => this.#casting === casting;
    const { width, height } = images.camera(0);
    const start = performance.now();
    for (let number = 0; number < images.whole; number++) {
      const image = await this.#whole(casting, number, raycaster, placed);
      if (!image) return;
      const { terms, lost } = await image.work();
      if (!wanted()) return;
      if (lost > 0) {
        this.#refuse(`${lost} rays were given up`);
        return;
      }
      if (number === 0) {
        images.milliseconds = performance.now() - start;
        images.evaluationsAPixel = ((WITH_GRADIENT + TEST) * terms) / (width * height);
      }
      images.count = number + 1;
      listener.changed();
    }
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
    const asked = performance.now();
    const image = await taken(this.#device, 'an image', () => images.begin(raycaster));
    await this.#device.queue.onSubmittedWorkDone();
    this.#pace.answered(performance.now() - asked);
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

  #loaded(): Promise<Ready> {
    this.#loading ??= this.#load(this.#device).then((raycaster) => {
      const ready = { raycaster, bodies: new DeviceBodies(raycaster) };
      if (!this.#isGone) this.#ready = ready;
      return ready;
    });
    return this.#loading;
  }

  #tell(why: string): void {
    if (this.#hasTold || this.#isGone) return;
    this.#hasTold = true;
    // devices go on with where in their own code it was
    this.#told(why.split('\n', 1)[0]!.trim());
  }

  #refuse(why: string, trees: readonly FieldNode[] = []): void {
    const casting = this.#casting;
    this.#casting = null;
    casting?.images.drop();
    casting?.listener.refused(why, trees);
  }
}
