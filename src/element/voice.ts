/** What files have to say to a person: in the status line, or as a notice with ways on. */
import type { Notice } from './notice.ts';
import type { Session } from './session.ts';

export class Voice {
  #notice: Notice | null = null;
  readonly #session: () => Session;

  constructor(session: () => Session) {
    this.#session = session;
  }

  say(words: string): void {
    const session = this.#session();
    session.said = words;
    session.update();
  }

  notify(text: string, ...actions: Notice['actions']): void {
    const session = this.#session();
    this.#notice = { text, actions };
    session.notice = this.#notice;
    session.update();
  }

  /** What was noticed is over; another one's notice stays. */
  hush(): void {
    const session = this.#session();
    if (session.notice !== this.#notice || !this.#notice) return;
    session.notice = null;
    session.update();
  }
}

/** The words that were said are on the screen; in a page that nobody sees, a moment later. */
export const painted = (): Promise<void> =>
  new Promise((resolve) => {
    setTimeout(resolve, 100);
    requestAnimationFrame(() => setTimeout(resolve));
  });
