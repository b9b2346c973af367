/** Bodies on the graphics device, ready for rays: kept by their trees, so that another view or place of them brings nothing up. */
import { bindField } from '../field/bind.ts';
import { latticed } from '../field/polygonize.ts';
import type { DeviceBody } from '../gpu/raycast/body.ts';
import type { GpuRaycaster, PlacedBody } from '../gpu/raycast/raycaster.ts';
import type { ShownBody } from './caster.ts';
import { keyOf } from './rayWorker.ts';

/** bytes that are kept beyond those of the picture */
const MOST_BYTES = 1 << 27;
/** ms of fitting between two breaths of the page */
const SLICE = 6;

export class DeviceBodies {
  readonly #raycaster: GpuRaycaster;
  /** oldest first */
  readonly #known = new Map<string, DeviceBody>();

  constructor(raycaster: GpuRaycaster) {
    this.#raycaster = raycaster;
  }

  /** Those that are there already, all of them or null. */
  known(bodies: readonly ShownBody[]): readonly PlacedBody[] | null {
    const placed = bodies.map((shown) => this.#placed(shown));
    return placed.every((each) => each !== null) ? placed : null;
  }

  /** Brings up what is not there; null when that was given up. */
  async ready(
    bodies: readonly ShownBody[],
    wanted: () => boolean,
    progress: (share: number) => void,
  ): Promise<readonly PlacedBody[] | null> {
    for (const [i, { node, cells }] of bodies.entries()) {
      const name = nameOf(bodies[i]!);
      const known = this.#known.get(name) ?? (await this.#made(node, cells, wanted));
      if (!known) return null;
      // now the newest
      this.#known.delete(name);
      this.#known.set(name, known);
      if (!wanted()) return null;
      progress((i + 1) / bodies.length);
    }
    this.#forget(new Set(bodies.map(nameOf)).size);
    return this.known(bodies);
  }

  destroy(): void {
    for (const body of this.#known.values()) body.destroy();
    this.#known.clear();
  }

  #placed(shown: ShownBody): PlacedBody | null {
    const body = this.#known.get(nameOf(shown));
    return body ? { body, placement: shown.placement } : null;
  }

  async #made(node: ShownBody['node'], cells: number, wanted: () => boolean): Promise<DeviceBody | null> {
    const lattice = await inSlices(latticed(bindField(node), cells), wanted);
    return lattice && this.#raycaster.body(node, lattice.lattice);
  }

  /** What was not looked at for long goes, where there is too much. */
  #forget(needed: number): void {
    const others = [...this.#known].slice(0, -needed);
    let bytes = others.reduce((sum, [, body]) => sum + body.bytes, 0);
    for (const [name, body] of others) {
      if (bytes <= MOST_BYTES) return;
      bytes -= body.bytes;
      body.destroy();
      this.#known.delete(name);
    }
  }
}

const nameOf = ({ node, cells }: ShownBody): string => `${keyOf(node)} ${cells}`;

/** Runs steps to their end as long as they are wanted, and lets the page breathe; null when they were given up. */
async function inSlices<T>(work: Generator<number, T>, wanted: () => boolean): Promise<T | null> {
  let until = performance.now() + SLICE;
  for (;;) {
    const { done, value } = work.next();
    if (done) return value;
    if (performance.now() < until) continue;
    await new Promise((resolve) => setTimeout(resolve));
    if (!wanted()) return null;
    until = performance.now() + SLICE;
  }
}
