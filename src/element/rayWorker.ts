/**
 * Casts rays by workers, as long as somebody wants any: one picture at a time, the latest wish wins. All of them share it (rayJobs.ts); each has a
 * job in hand and one more, so that none waits for the page. What a worker had in hand that is gone, others do.
 */
import type { FromExact, ToExact } from '../field/exactWork.ts';
import type { FieldNode } from '../field/node.ts';
import type { RayCamera } from '../field/rayImage.ts';
import type { Caster, CastImages, CastListener, ShownBody } from './caster.ts';
import { messageOf } from './events.ts';
import { ExactImages } from './exactImages.ts';
import { type Job, RayJobs } from './rayJobs.ts';

/** What of a worker is used. */
export type Castable = Pick<Worker, 'postMessage' | 'terminate' | 'onmessage' | 'onerror'>;

const startWorker = (): Castable =>
  new Worker(new URL('../worker/exact.ts', import.meta.url), { type: 'module' });

/** Each has bricks of its own, 40 MB for the whale. */
const MOST = 6;
const IN_HAND = 2;

const workersHere = (): number => Math.min(Math.max(globalThis.navigator?.hardwareConcurrency ?? 1, 1), MOST);

interface Casting {
  readonly images: ExactImages;
  readonly jobs: RayJobs;
  readonly listener: CastListener;
}

interface Hand {
  readonly worker: Castable;
  /** in the order in which they will be done */
  inHand: Job[];
}

export class RayWorker implements Caster {
  readonly #start: () => Castable;
  readonly #most: number;
  #hands: Hand[] = [];
  #latest = 0;
  /** null: nothing is wanted, or all of it is there */
  #casting: Casting | null = null;

  constructor(start = startWorker, most = workersHere()) {
    this.#start = start;
    this.#most = most;
  }

  cast(bodies: readonly ShownBody[], camera: RayCamera, listener: CastListener): CastImages {
    const images = new ExactImages(
      camera,
      bodies.map(({ id }) => id),
    );
    this.#casting = { images, listener, jobs: new RayJobs(camera.height) };
    const wanted = bodies.map(({ id, ...body }) => ({ name: id, key: keyOf(body.node), ...body }));
    const asked: ToExact = { type: 'cast', id: ++this.#latest, bodies: wanted, camera };
    try {
      while (this.#hands.length < this.#most) this.#hands.push(this.#begin());
    } catch (error) {
      if (this.#hands.length === 0) this.#refuse(messageOf(error));
    }
    this.#tell(asked);
    this.#feed();
    return images;
  }

  /** Bricks are kept. */
  stop(): void {
    if (!this.#casting) return;
    this.#casting = null;
    this.#tell({ type: 'stop', id: ++this.#latest });
  }

  end(): void {
    this.#refuse('given up');
    this.idle();
  }

  idle(): void {
    for (const { worker } of this.#hands) worker.terminate();
    this.#hands = [];
  }

  #tell(message: ToExact): void {
    try {
      for (const hand of this.#hands) {
        hand.inHand = [];
        hand.worker.postMessage(message);
      }
    } catch (error) {
      this.#refuse(messageOf(error));
    }
  }

  /** Hands out what there is to do, one to each, then one more. */
  #feed(): void {
    const casting = this.#casting;
    if (!casting) return;
    const { images, jobs } = casting;
    for (let most = 1; most <= IN_HAND; most++) {
      for (const { worker, inHand } of this.#hands) {
        if (inHand.length >= most) continue;
        const job = jobs.next(images.places);
        if (!job) return;
        inHand.push(job);
        worker.postMessage(this.#asked(job, images));
      }
    }
  }

  #asked(job: Job, images: ExactImages): ToExact {
    const id = this.#latest;
    if (job.type === 'band') return { ...job, id };
    const { type, offset, first, count } = job;
    return { type, id, offset, first, places: images.placesOf(first, count) };
  }

  #begin(): Hand {
    const hand: Hand = { worker: this.#start(), inHand: [] };
    hand.worker.onmessage = ({ data }: MessageEvent<FromExact>) => this.#hear(data, hand);
    hand.worker.onerror = ({ message }) => this.#lose(hand, message || 'no worker starts here');
    return hand;
  }

  /** What could not be fetched, may not be run, or broke down answers nobody. */
  #lose(hand: Hand, why: string): void {
    // it may break down more than once
    if (!this.#hands.includes(hand)) return;
    hand.worker.terminate();
    this.#hands = this.#hands.filter((other) => other !== hand);
    this.#casting?.jobs.giveBack(hand.inHand);
    if (this.#hands.length === 0) this.#refuse(why);
    else this.#feed();
  }

  #hear(said: FromExact, hand: Hand): void {
    const casting = this.#casting;
    if (!casting || said.id !== this.#latest) return;
    const { images, listener } = casting;
    switch (said.type) {
      case 'refused':
        this.#refuse(said.message);
        return;
      case 'locating':
        images.located(said.share);
        break;
      default:
        hand.inHand.shift();
        images.hear(said);
        this.#feed();
    }
    if (images.count === images.whole) this.#casting = null;
    listener.changed();
  }

  #refuse(why: string): void {
    const casting = this.#casting;
    if (!casting) return;
    this.stop();
    casting.listener.refused(why);
  }
}

const keys = new WeakMap<FieldNode, number>();
let lastKey = 0;

/** The same for the same tree, by which workers know it again. */
export function keyOf(node: FieldNode): number {
  const key = keys.get(node) ?? ++lastKey;
  keys.set(node, key);
  return key;
}
