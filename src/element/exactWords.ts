/** What is said of the exact surface: once how it ended, and in the status line what rays do or did. */
import type { Exact } from './exact.ts';
import type { Session } from './session.ts';
import { WORDS } from './words.ts';

export class ExactWords {
  /** that some rows could not be cast, since it was switched on */
  #toldRows = false;
  readonly #session: Pick<Session, 'exact' | 'said'>;

  constructor(session: Pick<Session, 'exact' | 'said'>) {
    this.#session = session;
  }

  /** It is switched on or off. */
  begin(): void {
    this.#toldRows = false;
  }

  /** Whoever heard that it is on its way hears once how that ended, unless something else was said since. */
  say(): void {
    const session = this.#session;
    const { exact } = session;
    if (exact.isInPart && !this.#toldRows) {
      this.#toldRows = true;
      session.said = WORDS.rowsLost;
    }
    if (session.said !== WORDS.onItsWay) return;
    if (exact.problem !== null) session.said = WORDS.noExact(exact.problem);
    else if (exact.evaluationsAPixel !== null) session.said = WORDS.mode.exact;
  }
}

/** What rays do, or did. */
export function raysWords({ share, evaluationsAPixel, problem, milliseconds, isInPart }: Exact): string {
  if (problem !== null) return WORDS.notExact;
  // also before it is begun, and while something moves
  if (evaluationsAPixel === null) return WORDS.casting(Math.min(99, Math.floor(100 * (share ?? 0))));
  const words = WORDS.exact(evaluationsAPixel, milliseconds);
  return isInPart ? WORDS.inPart(words) : words;
}
