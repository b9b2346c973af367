/**
 * What is located of the bodies that rays were cast onto, by the parts they are: of one that is edited only what the edit reaches is located
 * anew (field/liveField.ts), and one that is moved, or seen from elsewhere, not at all. Parts of the same tree share what is located; the first
 * of them that is edited begins anew, because an edit changes bricks where they are, and leaves it to the others.
 * What was not in the picture for longest goes where all is too much.
 *
 * LiveField is as fast as plain locating within a third (whale: 110 against 80 ms), so that there is one way only.
 */
import type { ExactBody } from '../field/exactWork.ts';
import { LiveField, type LiveStep } from '../field/liveField.ts';
import { Lately } from './lately.ts';

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
  readonly #kept = new Lately<Kept>();

  constructor(most: number = MOST) {
    this.#most = most;
  }

  get names(): readonly string[] {
    return this.#kept.names;
  }

  /** It is soon located, and given up it would have to be located anew. */
  isEdit(asked: Asked): boolean {
    const own = this.#own(asked);
    if (!own?.located) return false;
    return own.located.key !== asked.key && own.field.isEdit(asked.node);
  }

  /** Given up half-way it begins anew the next time. FieldError for what has no field. */
  *locating(asked: Asked): Generator<number, LiveStep> {
    const { name, key, node, cells } = asked;
    const same = this.#same(asked);
    if (same) {
      this.#kept.put(name, same);
      return same.located!.step;
    }
    const field = this.#own(asked)?.field ?? new LiveField(cells);
    this.#kept.put(name, { cells, field, located: null });
    const step = yield* field.locating(node);
    this.#kept.put(name, { cells, field, located: { key, step } });
    return step;
  }

  /** Lets go of what is too much and not among these. */
  trim(names: readonly string[]): void {
    const fields = new Set(names.map((name) => this.#kept.known(name)?.field));
    for (const name of this.names) {
      // a part that is gone is not to keep another one of its tree from being edited
      if (!names.includes(name) && fields.has(this.#kept.known(name)!.field)) this.#kept.drop(name);
    }
    const counted = new Set<LiveField>();
    const size = ({ field, located }: Kept): number => {
      const isCounted = counted.has(field);
      counted.add(field);
      return isCounted ? 0 : (located?.step.bricks.active.length ?? 0);
    };
    this.#kept.trim(this.#most, size, names);
  }

  /** The same tree, also as another part. */
  #same({ key, cells }: Asked): Kept | null {
    const all = this.names.map((name) => this.#kept.known(name)!);
    return all.find((kept) => kept.located?.key === key && kept.cells === cells) ?? null;
  }

  /** Of that part, and of no other; null: there is none to be edited. */
  #own({ name, cells }: Asked): Kept | null {
    const own = this.#kept.known(name);
    const isOthers = (other: string) => other !== name && this.#kept.known(other)?.field === own?.field;
    return own?.cells === cells && !this.names.some(isOthers) ? own : null;
  }
}
