/** The worker that casts rays, as long as somebody wants any: one picture at a time, the latest wish wins. */
import type { Cast, FromExact, ToExact } from '../field/exactWork.ts';

/** What of a worker is used. */
export type Castable = Pick<Worker, 'postMessage' | 'terminate' | 'onmessage' | 'onerror'>;
type Heard = (said: FromExact) => void;

const startWorker = (): Castable =>
  new Worker(new URL('../worker/exact.ts', import.meta.url), { type: 'module' });

export class RayWorker {
  readonly #start: () => Castable;
  #worker: Castable | null = null;
  #latest = 0;
  #heard: Heard = () => {};

  constructor(start = startWorker) {
    this.#start = start;
  }

  cast(wanted: Omit<Cast, 'type' | 'id'>, heard: Heard): void {
    this.#heard = heard;
    const cast: ToExact = { type: 'cast', id: ++this.#latest, ...wanted };
    try {
      this.#worker ??= this.#begin();
      this.#worker.postMessage(cast);
    } catch (error) {
      this.#refuse(error instanceof Error ? error.message : String(error));
    }
  }

  /** What was wanted is given up; bricks are kept. */
  stop(): void {
    this.#heard = () => {};
    this.#worker?.postMessage({ type: 'stop', id: ++this.#latest } satisfies ToExact);
  }

  /** With all that it kept. */
  end(): void {
    this.#refuse('given up');
    this.#heard = () => {};
    this.#worker?.terminate();
    this.#worker = null;
  }

  #begin(): Castable {
    const worker = this.#start();
    worker.onmessage = ({ data }: MessageEvent<FromExact>) => {
      if (data.id === this.#latest) this.#heard(data);
    };
    worker.onerror = ({ message }) => this.#refuse(message || 'no worker starts here');
    return worker;
  }

  #refuse(message: string): void {
    this.#heard({ type: 'refused', id: this.#latest, message });
  }
}
