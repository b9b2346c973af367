/**
 * Meshes on the graphics device, from the bricks or the lattice that a worker sends: one after the other, and of those that wait only the latest.
 * Meshes that are released give their buffers to those that come.
 */
import type { Located } from '../../field/fieldWork.ts';
import type { GpuPolygonizer } from '../../gpu/polygonize/polygonizer.ts';
import type { DeviceMesh } from '../../scene/deviceMesh.ts';

export interface MadeOnGpu {
  readonly of: Located;
  readonly mesh: DeviceMesh;
  readonly vertices: number;
  readonly triangles: number;
  /** what the device asked of skels where it found the bricks itself, else 0 */
  readonly work: number;
  /** on the page */
  readonly milliseconds: number;
  /** Once, when nothing draws it any more. */
  release(): void;
}

/** Who hears what came of bricks. Whoever is told of a mesh releases it. */
export interface Listener {
  made(made: MadeOnGpu): void;
  /** also when the device is lost */
  failed(of: Located, error: unknown): void;
}

export class FieldOnGpu {
  readonly #polygonizer: GpuPolygonizer;
  readonly #listener: Listener;
  #next: Located | null = null;
  #isBusy = false;
  #isGone = false;

  constructor(polygonizer: GpuPolygonizer, listener: Listener) {
    this.#polygonizer = polygonizer;
    this.#listener = listener;
  }

  make(of: Located): void {
    this.#next = of;
    if (!this.#isBusy) void this.#work();
  }

  /** Nobody is told of anything any more. */
  destroy(): void {
    this.#isGone = true;
    this.#next = null;
    this.#polygonizer.destroy();
  }

  async #work(): Promise<void> {
    this.#isBusy = true;
    while (this.#next) {
      const of = this.#next;
      this.#next = null;
      try {
        const made = await this.#made(of);
        if (this.#isGone) made.release();
        else this.#listener.made(made);
      } catch (error) {
        if (!this.#isGone) this.#listener.failed(of, error);
      }
    }
    this.#isBusy = false;
  }

  async #made(of: Located): Promise<MadeOnGpu> {
    const start = performance.now();
    const mesh = await this.#polygonizer.whole(of.node, of.bricks ?? of.lattice);
    const { vertices, triangles, work } = await mesh.needed();
    const { positions, normals, colours, indices, draw } = mesh;
    return {
      of,
      mesh: { positions, normals, colours, indices, draw, box: of.box },
      vertices,
      triangles,
      work,
      milliseconds: performance.now() - start,
      release: () => mesh.destroy(),
    };
  }
}
