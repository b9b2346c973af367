/** Casts rays by a worker, as long as somebody wants any: one picture at a time, the latest wish wins. */
import type { FromExact, ToExact } from '../field/exactWork.ts';
import type { FieldNode } from '../field/node.ts';
import type { RayCamera } from '../field/rayImage.ts';
import type { Caster, CastImages, CastListener, ShownBody } from './caster.ts';
import { messageOf } from './events.ts';
import { ExactImages } from './exactImages.ts';

/** What of a worker is used. */
export type Castable = Pick<Worker, 'postMessage' | 'terminate' | 'onmessage' | 'onerror'>;

const startWorker = (): Castable =>
  new Worker(new URL('../worker/exact.ts', import.meta.url), { type: 'module' });

interface Casting {
  readonly images: ExactImages;
  readonly listener: CastListener;
}

export class RayWorker implements Caster {
  readonly #start: () => Castable;
  #worker: Castable | null = null;
  #latest = 0;
  /** null: nothing is wanted, or all of it is there */
  #casting: Casting | null = null;

  constructor(start = startWorker) {
    this.#start = start;
  }

  cast(bodies: readonly ShownBody[], camera: RayCamera, listener: CastListener): CastImages {
    const ids = bodies.map(({ id }) => id);
    const images = new ExactImages(camera, ids);
    this.#casting = { images, listener };
    const wanted = bodies.map(({ node, placement, cells }) => ({ key: keyOf(node), node, placement, cells }));
    this.#post({ type: 'cast', id: ++this.#latest, bodies: wanted, camera });
    return images;
  }

  /** Bricks are kept. */
  stop(): void {
    if (!this.#casting) return;
    this.#casting = null;
    this.#post({ type: 'stop', id: ++this.#latest });
  }

  end(): void {
    this.#refuse('given up');
    this.#worker?.terminate();
    this.#worker = null;
  }

  #post(message: ToExact): void {
    try {
      this.#worker ??= this.#begin();
      this.#worker.postMessage(message);
    } catch (error) {
      this.#refuse(messageOf(error));
    }
  }

  #begin(): Castable {
    const worker = this.#start();
    worker.onmessage = ({ data }: MessageEvent<FromExact>) => this.#hear(data);
    worker.onerror = ({ message }) => {
      // what could not be fetched, or may not be run, answers nobody
      worker.terminate();
      this.#worker = null;
      this.#refuse(message || 'no worker starts here');
    };
    return worker;
  }

  #hear(said: FromExact): void {
    const casting = this.#casting;
    if (!casting || said.id !== this.#latest) return;
    if (said.type === 'refused') {
      this.#refuse(said.message);
      return;
    }
    const { images, listener } = casting;
    images.hear(said);
    if (images.count === images.whole) this.#casting = null;
    listener.changed();
  }

  #refuse(why: string): void {
    const casting = this.#casting;
    this.#casting = null;
    casting?.listener.refused(why);
  }
}

const keys = new WeakMap<FieldNode, number>();
let lastKey = 0;

/** The same for the same tree, by which the worker knows it again. */
export function keyOf(node: FieldNode): number {
  const key = keys.get(node) ?? ++lastKey;
  keys.set(node, key);
  return key;
}
