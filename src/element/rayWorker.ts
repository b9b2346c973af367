/**
 * Casts rays by workers, as long as somebody wants any: one picture at a time, the latest wish wins. All of them share it (rayJobs.ts); each has a
 * job in hand and one more, so that none waits for the page. What a worker had in hand that is gone, others do; a job that two of them were lost
 * over nobody does any more, and the picture shows triangles there. Workers that do not start are not tried for ever.
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
/** workers that are lost over a job until nobody does it */
const DEADLY = 2;
/** workers that are lost over the jobs of a picture until it is given up */
const MOST_LOST = 6;
/** pictures for which workers did not start until no more are tried */
const TRIES = 3;

const workersHere = (): number => Math.min(Math.max(globalThis.navigator?.hardwareConcurrency ?? 1, 1), MOST);

interface Casting {
  readonly images: ExactImages;
  readonly jobs: RayJobs;
  readonly listener: CastListener;
  readonly asked: ToExact;
  /** workers that were lost over them */
  readonly lostOver: Map<Job, number>;
}

interface Hand {
  readonly worker: Castable;
  /** in the order in which they will be done */
  inHand: Job[];
  /** it said so */
  isStarted: boolean;
}

export class RayWorker implements Caster {
  readonly #start: () => Castable;
  readonly #most: number;
  #hands: Hand[] = [];
  #latest = 0;
  /** null: nothing is wanted, or all of it is there */
  #casting: Casting | null = null;
  /** pictures for which one did not start since one did, the last of them, and why */
  #failures = 0;
  #failedFor = 0;
  #why = '';

  constructor(start = startWorker, most = workersHere()) {
    this.#start = start;
    this.#most = most;
  }

  cast(bodies: readonly ShownBody[], camera: RayCamera, listener: CastListener): CastImages {
    const images = new ExactImages(
      camera,
      bodies.map(({ id }) => id),
    );
    const wanted = bodies.map(({ id, ...body }) => ({ name: id, key: keyOf(body.node), ...body }));
    const asked: ToExact = { type: 'cast', id: ++this.#latest, bodies: wanted, camera };
    this.#casting = { images, listener, asked, jobs: new RayJobs(camera.height), lostOver: new Map() };
    this.#fill(this.#most);
    this.#tell(asked);
    this.#feed();
    return images;
  }

  /** Starts what is missing of so many. */
  #fill(count: number): void {
    try {
      while (this.#hands.length < count && this.#failures < TRIES) this.#hands.push(this.#begin());
    } catch (error) {
      this.#fail(messageOf(error));
    }
    if (this.#hands.length === 0) this.#refuse(this.#why);
  }

  /** One did not start. */
  #fail(why: string): void {
    this.#why = why;
    if (this.#failedFor !== this.#latest) this.#failures++;
    this.#failedFor = this.#latest;
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
    this.#failures = 0;
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
    const hand: Hand = { worker: this.#start(), inHand: [], isStarted: false };
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
    this.#casting?.jobs.giveBack(hand.inHand.slice(1));
    this.#loseOver(hand, why);
    if (this.#hands.length === 0) this.#refuse(why);
    else this.#feed();
  }

  /** What it was doing is what it was lost over; others try that once more. */
  #loseOver({ inHand, isStarted }: Hand, why: string): void {
    const [casting, [job]] = [this.#casting, inHand];
    if (!isStarted) this.#fail(why);
    if (!casting || !job) return;
    const { jobs, images, lostOver, asked } = casting;
    if (!isStarted) {
      jobs.giveBack([job]);
      return;
    }
    const count = (lostOver.get(job) ?? 0) + 1;
    lostOver.set(job, count);
    if (count < DEADLY) jobs.giveBack([job]);
    else images.lose(job);
    const all = [...lostOver.values()].reduce((sum, each) => sum + each, 0);
    if (all >= MOST_LOST || images.isLost) this.#refuse(why);
    else if (this.#hands.length === 0) {
      this.#fill(1);
      this.#tell(asked);
    }
    if (count === DEADLY && this.#casting === casting) this.#news(casting);
  }

  /** There is more of the picture, or all of it. */
  #news({ images, listener }: Casting): void {
    if (images.count === images.whole) this.#casting = null;
    listener.changed();
  }

  #hear(said: FromExact, hand: Hand): void {
    if (!hand.isStarted) this.#failures = 0;
    hand.isStarted = true;
    const casting = this.#casting;
    if (!casting || said.id !== this.#latest) return;
    const { images } = casting;
    switch (said.type) {
      case 'refused':
        this.#refuse(said.message);
        return;
      case 'begun':
        return;
      case 'locating':
        images.located(said.share);
        break;
      default:
        hand.inHand.shift();
        images.hear(said);
        this.#feed();
    }
    this.#news(casting);
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
