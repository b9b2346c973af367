/**
 * Which file a drawing came from, and what may be replaced without loss. It is remembered with the step that opened the
 * drawing: undo brings back name, view and file, too, so that no drawing is ever saved over another one.
 */
import type { Command } from '../document/command/index.ts';
import type { Document } from '../document/document.ts';
import type { Drawing } from '../document/drawing.ts';
import type { ChangeDetail } from './events.ts';
import type { Session } from './session.ts';
import { isBlank } from './snapshot.ts';
import type { StoredFile } from './vault.ts';

/** Where a drawing is written again. */
export interface Origin {
  /** of the file */
  readonly name: string;
  readonly handle: FileSystemFileHandle | null;
}

/** What has a drawing just so: a file, a sample, or the page around the element. */
export type Where = 'file' | 'sample' | 'page';

interface Around {
  readonly name: string;
  readonly view: Drawing['view'];
  readonly look: Drawing['look'];
  readonly origin: Origin | null;
}

/** After these another drawing is there, or none. */
const REPLACING: readonly Command['type'][] = ['load', 'removeAll'];

export class Origins {
  current: Origin | null = null;
  /** of what is being opened */
  next: Origin | null = null;
  readonly #safe = new WeakMap<Document, { readonly name: string; readonly where: Where }>();
  readonly #turns = new WeakMap<Command, { before: Around; after: Around }>();
  /** as of the last update */
  #last: Drawing;
  readonly #session: Session;
  readonly #replaced: (drawing: Drawing) => void;

  /** `replaced` hears of what another drawing took the place of, and no file has. */
  constructor(session: Session, replaced: (drawing: Drawing) => void) {
    this.#session = session;
    this.#replaced = replaced;
    this.#last = session.drawing;
  }

  /** After each update: how the drawing was called and looked at before a step that replaces it. */
  remember(): void {
    this.#last = this.#session.drawing;
  }

  /** It is just so there. */
  mark(document: Document, name: string, where: Where): void {
    this.#safe.set(document, { name, where });
  }

  where({ document, name }: Drawing): Where | null {
    const found = this.#safe.get(document);
    return found?.name === name ? found.where : null;
  }

  get fact(): StoredFile | null {
    const { current: origin } = this;
    if (!origin) return null;
    const unchanged = this.where(this.#session.drawing) === 'file';
    // What is no real handle cannot be stored.
    const real = typeof FileSystemFileHandle !== 'undefined' && origin.handle instanceof FileSystemFileHandle;
    return real ? { name: origin.name, unchanged, handle: origin.handle } : { name: origin.name, unchanged };
  }

  changed({ commands, cause }: ChangeDetail): void {
    const { past, future } = this.#session.history;
    if (cause === 'undo') this.#turn(future[0]?.command, 'before');
    else if (cause === 'redo') this.#turn(past.at(-1)?.command, 'after');
    else {
      const replacing = ({ type }: Command) => REPLACING.includes(type);
      const step = past.findLast(({ command }) => commands.includes(command) && replacing(command));
      if (step) this.#replace(step.before, step.command);
    }
  }

  #replace(document: Document, command: Command): void {
    const drawing = { ...this.#last, document };
    const before = this.#around(drawing);
    if (!isBlank(drawing) && !this.where(drawing)) this.#replaced(drawing);
    if (command.type !== 'load') return;
    this.current = this.next;
    this.#turns.set(command, { before, after: this.#around(this.#session.drawing) });
  }

  #around({ name, view, look }: Drawing): Around {
    return { name, view, look, origin: this.current };
  }

  #turn(command: Command | undefined, to: 'before' | 'after'): void {
    const turn = command && this.#turns.get(command);
    if (!turn) return;
    turn[to === 'before' ? 'after' : 'before'] = this.#around(this.#last);
    const { name, view, look, origin } = turn[to];
    const session = this.#session;
    session.name = name;
    this.current = origin;
    session.setLook(look);
    session.scene?.rig.setView(view, true);
  }
}
