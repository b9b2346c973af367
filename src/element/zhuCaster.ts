/** Casts Zhu et al.'s rays (field/zhuMarch.ts) by a worker in place of ours, and tells how both did. */
import { OFFSETS } from '../field/rayEdges.ts';
import type { RayCamera } from '../field/rayImage.ts';
import type { Compared, Comparison } from '../field/zhuImage.ts';
import type { FromZhu, ToZhu } from '../field/zhuWork.ts';
import type { SurfaceImage } from '../scene/index.ts';
import type { Caster, CastImages, CastListener, ShownBody } from './caster.ts';
import { messageOf } from './events.ts';
import type { Castable } from './rayWorker.ts';

const startWorker = (): Castable =>
  new Worker(new URL('../worker/zhu.ts', import.meta.url), { type: 'module' });

/** All images come at once. */
class ZhuImages implements CastImages {
  readonly known = [0, 0] as const;
  share = 0;
  milliseconds = 0;
  compared: Compared | null = null;
  readonly #camera: RayCamera;
  readonly #items: readonly string[];

  constructor(camera: RayCamera, items: readonly string[]) {
    this.#camera = camera;
    this.#items = items;
  }

  get count(): number {
    return this.compared?.images.length ?? 0;
  }

  get whole(): number {
    return this.compared?.images.length ?? 1;
  }

  get evaluationsAPixel(): number | null {
    return this.compared?.comparison.zhu.evaluationsPerPixel ?? null;
  }

  image(number: number): SurfaceImage {
    const { surface, colours } = this.compared!.images[number]!;
    const offset = number === 0 ? this.#camera.offset : OFFSETS[number - 1]!;
    return { camera: { ...this.#camera, offset }, items: this.#items, surface, colours };
  }
}

export class ZhuCaster implements Caster {
  /** of the last picture; null: there is none yet */
  comparison: Comparison | null = null;
  readonly #start: () => Castable;
  #worker: Castable | null = null;
  #listener: CastListener | null = null;

  constructor(start = startWorker) {
    this.#start = start;
  }

  cast(shown: readonly ShownBody[], camera: RayCamera, listener: CastListener): CastImages {
    this.stop();
    this.comparison = null;
    const ids = shown.map(({ id }) => id);
    const images = new ZhuImages(camera, ids);
    this.#listener = listener;
    const bodies = shown.map(({ node, placement, cells }) => ({ node, placement, cells }));
    try {
      this.#worker = this.#begin(images);
      this.#worker.postMessage({ bodies, camera } satisfies ToZhu);
    } catch (error) {
      this.#refuse(messageOf(error));
    }
    return images;
  }

  /** Nothing is kept. */
  stop(): void {
    this.#listener = null;
    this.#worker?.terminate();
    this.#worker = null;
  }

  end(): void {
    this.#refuse('given up');
  }

  #begin(images: ZhuImages): Castable {
    const worker = this.#start();
    worker.onmessage = ({ data }: MessageEvent<FromZhu>) => {
      if (worker === this.#worker) this.#hear(images, data);
    };
    worker.onerror = ({ message }) => {
      if (worker === this.#worker) this.#refuse(message || 'no worker starts here');
    };
    return worker;
  }

  #hear(images: ZhuImages, said: FromZhu): void {
    const listener = this.#listener;
    switch (said.type) {
      case 'refused':
        this.#refuse(said.message);
        return;
      case 'progress':
        images.share = said.share;
        break;
      case 'compared':
        images.compared = said;
        images.milliseconds = said.milliseconds;
        this.comparison = said.comparison;
        this.stop();
    }
    listener?.changed();
  }

  #refuse(why: string): void {
    const listener = this.#listener;
    this.stop();
    listener?.refused(why);
  }
}
