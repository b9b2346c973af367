/**
 * The life of the scene of one element: fetched when there is a page to draw on, shown, lost with its device and made
 * anew, given back when the element goes. There is always a picture: what fails with WebGPU is tried with WebGL2.
 */
import type { Scene } from '../scene/index.ts';

export type BackendChoice = 'auto' | 'webgl2';

export interface SceneOwner {
  /** the canvas that the next scene draws on; after `freshCanvas` another one */
  canvas(): HTMLCanvasElement;
  /** A canvas that had one context, or lost it with its device, gives no other one. */
  freshCanvas(): void;
  readonly backend: BackendChoice;
  /** most texels lines are found in; undefined: what the scene can afford */
  readonly lineTexels: number | undefined;
  /** a scene is there */
  show(scene: Scene): void;
  /** the device was lost: the scene goes, another one comes */
  lose(reason: string): void;
  /** neither back end works */
  withoutScene(error: unknown): void;
}

export class SceneLife {
  /** counts renewals: what was begun before one must not arrive after it */
  #life = 0;
  readonly #owner: SceneOwner;

  constructor(owner: SceneOwner) {
    this.#owner = owner;
  }

  async open(backend: BackendChoice = this.#owner.backend): Promise<void> {
    const life = this.#life;
    const owner = this.#owner;
    try {
      const { createScene } = await import('../scene/index.ts');
      if (this.#life !== life) return;
      const { lineTexels } = owner;
      const options = lineTexels === undefined ? { backend } : { backend, lineTexels };
      const scene = await createScene(owner.canvas(), options);
      if (this.#life !== life) scene.dispose();
      else this.#show(scene);
    } catch (error) {
      if (this.#life === life) await this.#failed(error, backend);
    }
  }

  /** What was begun is not wanted any more. */
  close(): void {
    this.#life++;
  }

  #show(scene: Scene): void {
    const life = this.#life;
    this.#owner.show(scene);
    void scene.lost.then((reason) => {
      if (this.#life === life) void this.#renew(reason);
    });
  }

  async #failed(error: unknown, tried: BackendChoice): Promise<void> {
    console.error(error);
    if (tried === 'webgl2') {
      this.#owner.withoutScene(error);
      return;
    }
    this.#owner.freshCanvas();
    await this.open('webgl2');
  }

  /** The strokes are the truth and none of them is on the device: a new scene shows them again, also in mid-stroke. */
  async #renew(reason: string): Promise<void> {
    this.#life++;
    this.#owner.lose(reason);
    this.#owner.freshCanvas();
    await this.open();
  }
}
