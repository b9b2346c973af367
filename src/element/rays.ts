/**
 * Who casts rays: the graphics device, where it is no processor in disguise and knows bounds for all bodies that are shown; else workers,
 * who also take over what the device could not do.
 */
import type { FieldNode } from '../field/node.ts';
import type { RayCamera } from '../field/rayImage.ts';
import { castsOnDevice } from '../gpu/raycast/castsOnDevice.ts';
import type { Scene, SurfaceImage } from '../scene/index.ts';
import type { View } from '../stroke/stroke.ts';
import type { Caster, CastImages, CastListener, ShownBody } from './caster.ts';
import { DeviceRays } from './deviceRays.ts';
import { RayWorker } from './rayWorker.ts';

/** `device`: software adapters too, and live whatever it takes, for tests; they take longer than workers. */
export type RayChoice = 'auto' | 'device' | 'worker';

type OnDevice = (device: GPUDevice, told: (why: string) => void) => Caster;

export class Rays implements Caster {
  choice: RayChoice = 'auto';
  /** the device casts less than it was asked for, others do; once a device */
  onRefused: (why: string) => void = () => {};
  readonly #workers: Caster;
  readonly #onDevice: OnDevice;
  #device: Caster | null = null;
  #isSoftware = false;
  /** trees that the device could not cast, though it should */
  #refused = new WeakSet<FieldNode>();

  constructor(
    workers: Caster = new RayWorker(),
    onDevice: OnDevice = (device, told) => new DeviceRays(device, told),
  ) {
    this.#workers = workers;
    this.#onDevice = onDevice;
  }

  /** Where pictures are drawn from now on. */
  use({ device, description }: Pick<Scene, 'device' | 'description'>): void {
    const before = this.#device;
    this.#device = device && this.#onDevice(device, (why) => this.onRefused(why));
    before?.end();
    this.#isSoftware = description?.software ?? false;
    this.#refused = new WeakSet();
  }

  cast(bodies: readonly ShownBody[], camera: RayCamera, listener: CastListener): CastImages {
    const device = this.#deviceFor(bodies);
    if (!device) return this.#workers.cast(bodies, camera, listener);
    const images = new Casting();
    images.of = device.cast(bodies, camera, {
      changed: () => listener.changed(),
      spare: () => listener.spare?.() ?? false,
      refused: (why, trees = []) => {
        // it is gone, and so is the picture
        if (this.#device !== device) {
          listener.refused(why);
          return;
        }
        for (const node of trees) this.#refused.add(node);
        images.of = this.#workers.cast(bodies, camera, listener);
      },
    });
    return images;
  }

  live(
    bodies: readonly ShownBody[],
    view: View,
    pixels: Scene['pixels'],
    milliseconds: number,
  ): SurfaceImage | null {
    const most = this.choice === 'device' ? Infinity : milliseconds;
    return this.#deviceFor(bodies)?.live?.(bodies, view, pixels, most) ?? null;
  }

  stop(): void {
    this.#device?.stop();
    this.#workers.stop();
  }

  idle(): void {
    this.#device?.idle?.();
    this.#workers.idle?.();
  }

  end(): void {
    const device = this.#device;
    this.#device = null;
    device?.end();
    this.#workers.end();
  }

  #deviceFor(bodies: readonly ShownBody[]): Caster | null {
    const isWanted = this.choice === 'device' || (this.choice === 'auto' && !this.#isSoftware);
    const can = ({ node }: ShownBody) => !this.#refused.has(node) && canCast(node);
    return isWanted && bodies.every(can) ? this.#device : null;
  }
}

const known = new WeakMap<FieldNode, boolean>();

/** What has no field is the workers' to tell. */
function canCast(node: FieldNode): boolean {
  const before = known.get(node);
  if (before !== undefined) return before;
  let can = false;
  try {
    can = castsOnDevice(node);
  } catch {}
  known.set(node, can);
  return can;
}

/** The images of whoever casts them now. */
class Casting implements CastImages {
  of!: CastImages;

  get count() {
    return this.of.count;
  }
  get whole() {
    return this.of.whole;
  }
  get known() {
    return this.of.known;
  }
  get lost() {
    return this.of.lost ?? null;
  }
  get share() {
    return this.of.share;
  }
  get evaluationsAPixel() {
    return this.of.evaluationsAPixel;
  }
  get milliseconds() {
    return this.of.milliseconds;
  }
  image(number: number): SurfaceImage {
    return this.of.image(number);
  }
  drop(): void {
    this.of.drop?.();
  }
}
