/** What the pen would do where it is over the picture: shown at every place, spoken once when the pen rests. */
import type { State } from '../tool/tool.ts';
import { Lull } from './lull.ts';
import { EDIT_WORDS, SECTION_WORDS } from './words.ts';

/** ms: a hint that stays for so long is spoken */
const CALM = 600;

/** '' where there is nothing to say. */
export const hintOf = ({ guide, redrawing: held }: State): string =>
  guide
    ? SECTION_WORDS.at(Math.round(100 * guide.u), guide.side)
    : held?.over
      ? EDIT_WORDS.redrawLit[held.over]
      : '';

export class HoverHint {
  shown = '';
  /** for those who do not see it; '' while it changes */
  atRest = '';
  readonly #lull: Lull;

  /** `calm`: it has come to rest. */
  constructor(calm: () => void) {
    this.#lull = new Lull(CALM, () => {
      this.atRest = this.shown;
      calm();
    });
  }

  follow(state: State): void {
    const hint = hintOf(state);
    if (hint === this.shown) return;
    this.shown = hint;
    this.atRest = '';
    if (hint) this.#lull.stir();
    else this.#lull.stop();
  }
}
