/** The bodies that are being edited, by their names, each at its finest. Those that were not asked for longest go where all together are too large. */
import { LiveMesh } from '../field/liveMesh.ts';
import { Lately } from './lately.ts';

interface Kept {
  readonly cells: number;
  readonly mesh: LiveMesh;
}

/** bricks, some 10 kB each: three or four bodies of 128 cells */
const MOST = 10_000;

export class LiveMeshes {
  readonly #most: number;
  readonly #kept = new Lately<Kept>();

  constructor(most: number = MOST) {
    this.#most = most;
  }

  get names(): readonly string[] {
    return this.#kept.names;
  }

  /** Of that body in so many cells; null: it is not there. */
  known(name: string, cells: number): LiveMesh | null {
    const kept = this.#kept.known(name);
    return kept?.cells === cells ? kept.mesh : null;
  }

  /** The same, or a new one in its place. */
  at(name: string, cells: number): LiveMesh {
    const mesh = this.known(name, cells) ?? new LiveMesh(cells);
    this.#kept.put(name, { cells, mesh });
    return mesh;
  }

  /** Lets go of what is too much; the one asked for last stays while it is not too large by itself. */
  trim(): void {
    this.#kept.trim(this.#most, ({ mesh }) => mesh.size);
  }
}
