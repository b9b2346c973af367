/**
 * The life of the scene of one element: fetched when there is a page to draw on, shown, lost with its device and made
 * anew, given back when the element goes. What fails with WebGPU is tried with WebGL2, and so is what WebGPU loses
 * again and again; only where that fails too is there no picture.
 */
import type { createScene, Scene } from '../scene/index.ts';
import { messageOf } from './events.ts';

export type BackendChoice = 'auto' | 'webgl2';

export interface SceneOwner {
  /** the canvas that the next scene draws on; after `freshCanvas` another one */
  canvas(): HTMLCanvasElement;
  /** A canvas that had one context, or lost it with its device, gives no other one. */
  freshCanvas(): void;
  readonly backend: BackendChoice;
  /** lines for a picture, where time is no matter */
  readonly fine: boolean;
  /** a scene is there */
  show(scene: Scene): void;
  /** the device was lost: the scene goes, another one comes */
  lose(reason: string): void;
  /** neither back end works */
  withoutScene(error: unknown): void;
}

interface SceneModule {
  readonly createScene: typeof createScene;
}

/** So many losses … */
const LOSSES = 3;
/** … within so many ms, and the back end is not tried again. */
const WITHIN = 60_000;
/** ms: after a loss the browser may need a moment until it hands out graphics again. */
const PAUSES = [0, 500, 1500] as const;

interface Wish {
  readonly backend: BackendChoice;
  /** why not WebGPU, in words */
  readonly because?: string;
}

export class SceneLife {
  /** counts renewals: what was begun before one must not arrive after it */
  #life = 0;
  /** when devices were lost, ms */
  #losses: readonly number[] = [];
  /** what WebGPU was given up for; null: it may be asked for */
  #gaveUp: string | null = null;
  readonly #used = new WeakSet<HTMLCanvasElement>();
  readonly #owner: SceneOwner;
  readonly #load: () => Promise<SceneModule>;

  constructor(owner: SceneOwner, load: () => Promise<SceneModule> = () => import('../scene/index.ts')) {
    this.#owner = owner;
    this.#load = load;
  }

  /** A scene, from the beginning; also once more where there was none. */
  async open(): Promise<void> {
    this.#life++;
    this.#losses = [];
    this.#gaveUp = null;
    await this.#try([0]);
  }

  /** What was begun is not wanted any more. */
  close(): void {
    this.#life++;
  }

  get #wish(): Wish {
    if (this.#gaveUp !== null) return { backend: 'webgl2', because: this.#gaveUp };
    return { backend: this.#owner.backend };
  }

  /** Makes a scene, with a pause before each try. */
  async #try(pauses: readonly number[]): Promise<void> {
    const life = this.#life;
    let failure: unknown;
    for (const pause of pauses) {
      if (pause > 0) await new Promise((done) => setTimeout(done, pause));
      if (this.#life !== life) return;
      failure = await this.#make(life);
      if (this.#life !== life || failure === null) return;
    }
    this.#owner.withoutScene(failure);
  }

  /** One try, with WebGL2 after WebGPU. Returns what went wrong, null when nothing did. */
  async #make(life: number): Promise<unknown> {
    const wish = this.#wish;
    try {
      const { createScene } = await this.#load();
      if (this.#life !== life) return null;
      const scene = await createScene(this.#canvas(), { ...wish, fine: this.#owner.fine });
      if (this.#life !== life) scene.dispose();
      else this.#show(scene);
      return null;
    } catch (error) {
      const last = wish.backend === 'webgl2' || (error as Error | null)?.name === 'NoGraphicsError';
      if (this.#life !== life || last) return error;
      console.warn('WebGPU failed, WebGL2 is next.', error);
      this.#gaveUp = `WebGPU failed: ${messageOf(error)}`;
      return this.#make(life);
    }
  }

  #canvas(): HTMLCanvasElement {
    if (this.#used.has(this.#owner.canvas())) this.#owner.freshCanvas();
    const canvas = this.#owner.canvas();
    this.#used.add(canvas);
    return canvas;
  }

  #show(scene: Scene): void {
    const life = this.#life;
    this.#owner.show(scene);
    void scene.lost.then((reason) => {
      if (this.#life === life) void this.#renew(reason, scene);
    });
  }

  /** The strokes are the truth and none of them is on the device: a new scene shows them again, also in mid-stroke. */
  async #renew(reason: string, { backend, useless }: Scene): Promise<void> {
    this.#life++;
    const now = performance.now();
    this.#losses = [...this.#losses.filter((then) => now - then < WITHIN), now];
    const hopeless = useless || this.#losses.length >= LOSSES;
    const verdict = useless
      ? `${backend} failed: ${reason}`
      : `${backend} was lost ${LOSSES} times: ${reason}`;
    this.#owner.lose(reason);
    if (hopeless && backend === 'WebGL2') {
      this.#owner.withoutScene(new Error(verdict));
      return;
    }
    if (hopeless) {
      this.#losses = [];
      this.#gaveUp = verdict;
    }
    await this.#try(PAUSES);
  }
}
