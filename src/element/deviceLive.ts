/**
 * Images of what moves, cast by the graphics device within a frame: as finely as there is time for by what those before took. Room for them is asked
 * for beside the frames, which show meshes until it is there: what a device has no memory for looks like an empty picture.
 */
import type { DeviceBody } from '../gpu/raycast/body.ts';
import type { DeviceImage, GpuRaycaster, PlacedBody } from '../gpu/raycast/raycaster.ts';
import { taken } from '../gpu/taken.ts';
import type { Scene, SurfaceImage } from '../scene/index.ts';
import type { View } from '../stroke/stroke.ts';
import { MIDDLE, MOST_RAYS } from './caster.ts';
import { messageOf } from './events.ts';
import { type Pace, SPARSE } from './pace.ts';

/** pixels along a side for a ray: what still looks like the surface */
const COARSER = [1, 2, 4] as const;

/** What is to be seen. */
export interface Moving {
  readonly bodies: readonly PlacedBody[];
  /** ids of the items */
  readonly items: readonly string[];
  readonly view: View;
  readonly pixels: Scene['pixels'];
}

type Casts = Pick<GpuRaycaster, 'image' | 'cast'>;

export class DeviceLive {
  readonly #device: GPUDevice;
  readonly #pace: Pace;
  readonly #refused: (why: string) => void;
  /** by their sizes, oldest first; null: asked for */
  readonly #rooms = new Map<string, DeviceImage | null>();
  /** rays a pixel of the last one: bodies do not fill it, or cover each other */
  #share = 1;
  #isTimed = false;
  /** bodies with rays that were given up */
  readonly #holed = new WeakSet<DeviceBody>();
  #isRefused = false;

  /** `refused` is told once, and then there is nothing more until all have rested. */
  constructor(device: GPUDevice, pace: Pace, refused: (why: string) => void) {
    this.#device = device;
    this.#pace = pace;
    this.#refused = refused;
  }

  /** Begun, and drawn after what was begun before; null: it takes longer, or there is no room, or not yet. */
  image(raycaster: Casts, moving: Moving, milliseconds: number): SurfaceImage | null {
    const { bodies, items, view, pixels } = moving;
    const coarser = this.#isRefused ? undefined : this.#coarser(pixels, milliseconds);
    if (coarser === undefined || bodies.some(({ body }) => this.#holed.has(body))) return null;
    const side = (length: number) => Math.max(1, Math.round(length / coarser));
    const camera = { view, width: side(pixels.width), height: side(pixels.height), offset: MIDDLE };
    const room = this.#room(raycaster, camera.width, camera.height);
    if (!room) return null;
    let rays: number | null = null;
    const cast = () => {
      rays = raycaster.cast(room, bodies, camera);
    };
    void taken(this.#device, 'rays', cast).catch((error: unknown) => this.#refuse(messageOf(error)));
    if (rays === null) return null;
    this.#share = rays / (camera.width * camera.height);
    void this.#time(room, rays, bodies);
    const { surface, colours, stride } = room;
    return { camera, items, surface, colours, stride };
  }

  /** No room is kept, and what was refused is asked for again. */
  idle(): void {
    this.#isRefused = false;
    for (const room of this.#rooms.values()) room?.destroy();
    this.#rooms.clear();
  }

  #coarser({ width, height }: Scene['pixels'], milliseconds: number) {
    const takes = this.#pace.milliseconds(Math.max(this.#share, SPARSE) * width * height) ?? Infinity;
    const fits = (side: number) => width * height <= MOST_RAYS * side * side;
    return COARSER.find((side) => takes <= milliseconds * side * side && fits(side));
  }

  /** As it is there already; else it is asked for. */
  #room(raycaster: Casts, width: number, height: number): DeviceImage | null {
    const size = `${width} × ${height}`;
    const known = this.#rooms.get(size);
    if (known !== undefined) return known;
    for (const [old, room] of this.#rooms) {
      if (this.#rooms.size < COARSER.length) break;
      room?.destroy();
      this.#rooms.delete(old);
    }
    this.#rooms.set(size, null);
    void this.#ask(raycaster, width, height, size);
    return null;
  }

  async #ask(raycaster: Casts, width: number, height: number, size: string): Promise<void> {
    let made: DeviceImage | null = null;
    try {
      await taken(this.#device, 'an image', () => {
        made = raycaster.image(width, height);
      });
      // nobody waits for it any more, or somebody has it
      if (this.#rooms.get(size) !== null) throw new Error('given up');
      this.#rooms.set(size, made);
    } catch (error) {
      const room = made as DeviceImage | null;
      room?.destroy();
      if (this.#rooms.get(size) === null) this.#refuse(messageOf(error));
    }
  }

  /** How long it took, and whether it has holes: then meshes are seen of these bodies from now on, whoever of them it was. */
  async #time(room: DeviceImage, rays: number, bodies: readonly PlacedBody[]): Promise<void> {
    if (this.#isTimed) return;
    this.#isTimed = true;
    const start = performance.now();
    try {
      const { lost } = await room.work();
      this.#pace.hear(rays, performance.now() - start);
      if (lost > 0) for (const { body } of bodies) this.#holed.add(body);
    } catch {
      // the device is gone, and so are its pictures
    }
    this.#isTimed = false;
  }

  #refuse(why: string): void {
    if (this.#isRefused) return;
    this.idle();
    this.#isRefused = true;
    this.#refused(why);
  }
}
