/**
 * Meshes on the graphics device, from the bricks or the lattice that a worker sends: one after the other, and of those that wait only the latest; but edits
 * follow each other, so that none of them is left out.
 * Meshes that are released give their buffers to those that come.
 */
import type { Located } from '../../field/fieldWork.ts';
import type { GpuMesh } from '../../gpu/polygonize/gpuMesh.ts';
import type { LivePolygonizer } from '../../gpu/polygonize/livePolygonizer.ts';
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
  readonly #live: LivePolygonizer;
  readonly #listener: Listener;
  /** the latest that is not kept */
  #next: Located | null = null;
  /** one that is kept, and edits of it and of what is on the device */
  #edits: Located[] = [];
  #isBusy = false;
  #isGone = false;

  constructor(polygonizer: GpuPolygonizer, live: LivePolygonizer, listener: Listener) {
    this.#polygonizer = polygonizer;
    this.#live = live;
    this.#listener = listener;
  }

  make(of: Located): void {
    if (!of.isKept) this.#next = of;
    else if (isEdit(of)) this.#edits.push(of);
    else this.#edits = [of];
    if (!this.#isBusy) void this.#work();
  }

  /** Nobody is told of anything any more. */
  destroy(): void {
    this.#isGone = true;
    this.#next = null;
    this.#edits = [];
    this.#live.destroy();
    this.#polygonizer.destroy();
  }

  async #work(): Promise<void> {
    this.#isBusy = true;
    for (;;) {
      const edits = this.#edits.splice(0);
      const of = edits.at(-1) ?? this.#next;
      if (!of) break;
      if (edits.length === 0) this.#next = null;
      try {
        const made = await this.#made(of, edits);
        if (this.#isGone) made.release();
        else this.#listener.made(made);
      } catch (error) {
        if (!this.#isGone) this.#listener.failed(of, error);
      }
    }
    this.#isBusy = false;
  }

  async #made(of: Located, edits: readonly Located[]): Promise<MadeOnGpu> {
    const start = performance.now();
    const mesh = await (edits.length > 0 ? this.#edited(edits) : this.#whole(of));
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

  async #whole({ node, bricks, lattice }: Located): Promise<GpuMesh> {
    if (bricks && 'renewed' in bricks) throw new Error('an edit of nothing');
    return this.#polygonizer.whole(node, bricks ?? lattice);
  }

  /** The last of them. */
  async #edited(all: readonly Located[]): Promise<GpuMesh> {
    const [first, ...rest] = all;
    const last = all.at(-1)!;
    const edits = (of: readonly Located[]) =>
      of.flatMap(({ bricks }) => (bricks && 'renewed' in bricks ? [bricks] : []));
    if (!first?.bricks || 'renewed' in first.bricks) return this.#live.edit(last.node, edits(all));
    const whole = await this.#live.whole(first.node, first.bricks);
    if (rest.length === 0) return whole;
    whole.destroy();
    return this.#live.edit(last.node, edits(rest));
  }
}

const isEdit = ({ bricks }: Located): boolean => bricks !== null && 'renewed' in bricks;
