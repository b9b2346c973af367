/**
 * What a page declares: a drawing by its address or as a property, and a style; and when all of that can be seen. Nothing
 * here throws: what cannot be done is told by an event, and what is open stays.
 */
import type { Drawing } from '../document/drawing.ts';
import { MODES, type Mode, STYLES, type Style } from '../document/look.ts';
import { FileError } from '../document/serialize.ts';
import { messageOf } from './events.ts';
import type { Notice } from './notice.ts';
import type { Session } from './session.ts';
import { isBlank } from './snapshot.ts';
import { Source } from './source.ts';
import { WORDS } from './words.ts';

export interface DeclaredHost {
  readonly session: Session;
  readonly isConnected: boolean;
  readonly src: string | null;
  /** Resolves when what the browser kept of this drawing is open, or there is nothing; true: it is open. */
  restored(): Promise<boolean>;
  renderStyle: Style | null;
  mode: Mode | null;
  /** the drawing that is open is just so where it came from */
  began(): void;
  /** Says what went wrong; true when the page leaves telling the person to the element. */
  fail(error: unknown): boolean;
  /** the first picture of a scene is there */
  ready(): void;
}

export class Declared {
  readonly #host: DeclaredHost;
  readonly #source = new Source({
    wanted: async () => this.#begun || !(await this.#host.restored()),
    skipped: () => this.#skipped(),
    opened: (drawing) => this.begin(drawing),
    failed: (error) => this.#sourceFailed(error),
  });
  /** what the page begins with is there, or was tried */
  #begun = false;
  /** an address that is not to be read: something else was opened in its place */
  #done: string | null = null;
  /** the style last taken from the attribute or given to it */
  #style: Style | null = null;
  #mode: Mode | null = null;
  #readyDue = false;
  /** that `src` could not be opened */
  #notice: Notice | null = null;

  constructor(host: DeclaredHost) {
    this.#host = host;
  }

  /** What a blank page begins with is no deed that undo could take back. */
  begin(drawing: Drawing): void {
    const { session } = this.#host;
    const { past, future } = session.history;
    const fresh = isBlank(session.drawing) && past.length + future.length === 0 && !session.state.wet;
    this.#begun = true;
    session.open(this.styled(drawing), { fresh });
    this.#host.began();
    if (session.notice === this.#notice) session.notice = null;
    this.#announce();
  }

  /** The declared style and mode win over those of the drawing. */
  styled(drawing: Drawing): Drawing {
    const style = known(STYLES, this.#host.renderStyle);
    const mode = known(MODES, this.#host.mode);
    return { ...drawing, look: { ...drawing.look, ...(style && { style }), ...(mode && { mode }) } };
  }

  /** Resolves when no address is being read. */
  async settled(): Promise<void> {
    while (this.#source.busy) await this.#source.settled;
  }

  // ── the address ─────────────────────────────────────────────────────────────────────────────────────

  fetch(): void {
    const { src, isConnected } = this.#host;
    const done = src !== null && src === this.#done;
    this.#done = null;
    if (!done) this.#source.open(src, isConnected);
  }

  /** Another drawing is opened in place of the one that is declared. */
  forget(): void {
    this.#done = this.#host.src;
    this.#begun = true;
    this.#source.forget();
  }

  /** The element leaves the page. */
  pause(): void {
    this.#source.pause();
  }

  /** What `pause` interrupted begins anew. */
  resume(): void {
    this.#source.resume();
  }

  #skipped(): void {
    this.#begun = true;
    this.#announce();
  }

  #sourceFailed(error: unknown): void {
    const { session } = this.#host;
    this.#begun = true;
    if (this.#host.fail(error)) {
      this.#notice = {
        text: messageOf(error),
        actions: [{ label: WORDS.tryAgain, run: () => this.fetch() }],
      };
      session.notice = this.#notice;
      session.update();
    }
    this.#announce();
  }

  // ── the style and the mode ──────────────────────────────────────────────────────────────────────────────────

  takeStyle(): void {
    const { renderStyle: wanted, session } = this.#host;
    this.#style = known(STYLES, wanted);
    if (this.#style) session.setLook({ style: this.#style });
    else if (wanted !== null) this.#refuse('render-style', STYLES, wanted);
  }

  takeMode(): void {
    const { mode: wanted, session } = this.#host;
    this.#mode = known(MODES, wanted);
    if (this.#mode) session.setLook({ mode: this.#mode });
    else if (wanted !== null) this.#refuse('mode', MODES, wanted);
  }

  #refuse(attribute: string, choices: readonly string[], found: unknown): void {
    const expected = `expected one of ${choices.join(', ')}, found ${JSON.stringify(found)}`;
    this.#host.fail(new FileError('rotund-sketch', attribute, expected));
  }

  /** What is declared follows what a person chooses. */
  followLook(): void {
    const { style, mode } = this.#host.session.look;
    if (this.#style && style !== this.#style) {
      this.#style = style;
      this.#host.renderStyle = style;
    }
    if (this.#mode && mode !== this.#mode) {
      this.#mode = mode;
      this.#host.mode = mode;
    }
  }

  // ── when it can be seen ─────────────────────────────────────────────────────────────────────────────

  sceneCame(): void {
    this.#readyDue = true;
    this.#announce();
  }

  /** Once a scene: when the first picture with all that is declared is there, or would be if it were seen. */
  sayReady(): void {
    const { scene, bodies, frames } = this.#host.session;
    if (!this.#readyDue || !scene || this.#source.busy) return;
    if (bodies.making && !frames.asleep) return;
    this.#readyDue = false;
    this.#host.ready();
  }

  /** The next frame says that it is ready; where nobody looks there is none. */
  #announce(): void {
    if (this.#host.session.frames.asleep) this.sayReady();
    else this.#host.session.frames.wake();
  }
}

const known = <T extends string>(choices: readonly T[], found: string | null): T | null =>
  choices.find((name) => name === found) ?? null;
