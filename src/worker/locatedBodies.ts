/**
 * What is located of the bodies that rays were cast onto, by the parts they are: of one that is edited only what the edit reaches is located
 * anew (field/liveField.ts), and one that is moved, or seen from elsewhere, not at all. What was not in the picture for longest goes where all
 * is too much.
 *
 * LiveField is as fast as plain locating within a third (whale: 110 against 80 ms), so that there is one way only.
 */
import type { ExactBody } from '../field/exactWork.ts';
import { LiveField, type LiveStep } from '../field/liveField.ts';

type Asked = Pick<ExactBody, 'name' | 'key' | 'node' | 'cells'>;

interface Kept {
  readonly cells: number;
  readonly field: LiveField;
  readonly located: { readonly key: number; readonly step: LiveStep } | null;
}

/** active bricks that are kept beyond those of the picture, some 10 kB each, by each worker */
const MOST = 4000;

export class LocatedBodies {
  readonly #most: number;
  /** the one asked for last comes last */
  readonly #kept = new Map<string, Kept>();

  constructor(most: number = MOST) {
    this.#most = most;
  }

  get names(): readonly string[] {
    return [...this.#kept.keys()];
  }

  /** It is soon located, and given up it would have to be located anew. */
  isEdit({ name, key, node, cells }: Asked): boolean {
    const kept = this.#kept.get(name);
    if (kept?.cells !== cells || !kept.located) return false;
    return kept.located.key !== key && kept.field.isEdit(node);
  }

  /** Given up half-way it begins anew the next time. FieldError for what has no field. */
  *locating(asked: Asked): Generator<number, LiveStep> {
    const { name, key, node, cells } = asked;
    const known = this.#known(asked);
    if (known) return known;
    const before = this.#kept.get(name);
    const field = before?.cells === cells ? before.field : new LiveField(cells);
    this.#put(name, { cells, field, located: null });
    const step = yield* field.locating(node);
    this.#put(name, { cells, field, located: { key, step } });
    return step;
  }

  /** Lets go of what is too much and not among these. */
  trim(names: readonly string[]): void {
    const others = this.names.filter((name) => !names.includes(name));
    let bricks = 0;
    for (const name of others.toReversed()) {
      bricks += this.#kept.get(name)!.located?.step.bricks.active.length ?? 0;
      if (bricks > this.#most) this.#kept.delete(name);
    }
  }

  /** The same tree, also as another part. */
  #known({ key, cells }: Asked): LiveStep | null {
    for (const [name, kept] of this.#kept) {
      if (kept.located?.key !== key || kept.cells !== cells) continue;
      this.#put(name, kept);
      return kept.located.step;
    }
    return null;
  }

  #put(name: string, kept: Kept): void {
    this.#kept.delete(name);
    this.#kept.set(name, kept);
  }
}
