/** What is selected: parts, and what solids are made of. */
import { partsWith } from '../document/chosen.ts';
import { itemsOf } from '../document/command/changeParts.ts';
import type { Session } from './session.ts';
import { SOLID_WORDS, WORDS } from './words.ts';

export class Selection {
  /** in the document's order */
  ids: readonly string[] = [];
  readonly #session: Session;

  constructor(session: Session) {
    this.#session = session;
  }

  /** Ids that nothing has are left out; false: it was the selection before. */
  set(ids: readonly string[]): boolean {
    const wanted = new Set(ids);
    const known =
      ids.length === 0
        ? []
        : itemsOf(this.#session.document)
            .map(({ id }) => id)
            .filter((id) => wanted.has(id));
    if (known.length === this.ids.length && known.every((id, i) => id === this.ids[i])) return false;
    this.ids = known;
    this.contour();
    return true;
  }

  /** Of a group the part is seen that it is in. */
  contour(): void {
    this.#session.scene?.select(partsWith(this.#session.document, this.ids).map(({ id }) => id));
  }

  /** For a selection that a person made. */
  get words(): string {
    const { document } = this.#session;
    const chosen = itemsOf(document).filter(({ id }) => this.ids.includes(id));
    const names = chosen.map(({ name }) => name);
    const [only] = partsWith(document, this.ids);
    const isPart = names.length !== 1 || only?.id === this.ids[0];
    return isPart
      ? WORDS.selected(names, document.parts.length)
      : SOLID_WORDS.selectedIn(names[0]!, only!.name);
  }
}
