/** Bodies on the graphics device, ready for rays: kept by their trees, so that another view or place of them brings nothing up. */
import { bindField } from '../field/bind.ts';
import type { FieldNode } from '../field/node.ts';
import { latticed } from '../field/polygonize.ts';
import type { DeviceBody } from '../gpu/raycast/body.ts';
import type { GpuRaycaster, PlacedBody } from '../gpu/raycast/raycaster.ts';
import type { ShownBody } from './caster.ts';
import { messageOf } from './events.ts';
import { keyOf } from './rayWorker.ts';

/** Bodies that the device does not take. */
export class TreesRefused extends Error {
  readonly trees: readonly FieldNode[];

  constructor(why: string, trees: readonly FieldNode[]) {
    super(why);
    this.trees = trees;
  }
}

/** bytes that are kept beyond those of the picture */
const MOST_BYTES = 1 << 27;
/** ms of fitting between two breaths of the page */
const SLICE = 6;

export class DeviceBodies {
  readonly #raycaster: Pick<GpuRaycaster, 'body'>;
  /** oldest first */
  readonly #known = new Map<string, DeviceBody>();
  /** wishes follow each other faster than bodies are made: each is made once */
  readonly #making = new Map<string, Promise<DeviceBody | null>>();
  #isGone = false;

  constructor(raycaster: Pick<GpuRaycaster, 'body'>) {
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
    const names = bodies.map(nameOf);
    for (const [i, shown] of bodies.entries()) {
      const known = await this.#made(shown, wanted);
      if (!known || !wanted()) return null;
      // now the newest
      this.#known.delete(names[i]!);
      this.#known.set(names[i]!, known);
      progress((i + 1) / bodies.length);
    }
    this.#forget(new Set(names));
    return this.known(bodies);
  }

  /** Resolves when nothing is being made any more. */
  async destroy(): Promise<void> {
    this.#isGone = true;
    for (const body of this.#known.values()) body.destroy();
    this.#known.clear();
    await Promise.allSettled(this.#making.values());
  }

  #placed(shown: ShownBody): PlacedBody | null {
    const body = this.#known.get(nameOf(shown));
    return body ? { body, placement: shown.placement } : null;
  }

  /** As it is known, or made; null when that was given up. */
  async #made(shown: ShownBody, wanted: () => boolean): Promise<DeviceBody | null> {
    const name = nameOf(shown);
    for (;;) {
      const known = this.#known.get(name);
      if (known || this.#isGone) return known ?? null;
      let making = this.#making.get(name);
      if (!making) {
        making = this.#make(shown, wanted).finally(() => this.#making.delete(name));
        this.#making.set(name, making);
      }
      const made = await making;
      // somebody else gave it up
      if (made || !wanted()) return made;
    }
  }

  async #make(shown: ShownBody, wanted: () => boolean): Promise<DeviceBody | null> {
    const { node, cells } = shown;
    const lattice = await inSlices(latticed(bindField(node), cells), wanted);
    if (!lattice || this.#isGone) return null;
    const body = await this.#raycaster.body(node, lattice.lattice).catch((error: unknown) => {
      throw new TreesRefused(messageOf(error), [node]);
    });
    if (this.#isGone) {
      body.destroy();
      return null;
    }
    this.#known.set(nameOf(shown), body);
    return body;
  }

  /** What was not looked at for long goes, where there is too much. */
  #forget(needed: ReadonlySet<string>): void {
    const others = [...this.#known].filter(([name]) => !needed.has(name));
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
