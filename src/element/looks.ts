/** How the drawing is looked at: style, paper, bodies as triangles or exactly. */
import { bodiesOf } from '../document/fieldParts.ts';
import { type Background, DEFAULT_LOOK, type Look, type Mode, type Style } from '../document/look.ts';
import { ExactWords } from './exactWords.ts';
import type { Session } from './session.ts';
import { WORDS } from './words.ts';

export class Looks {
  look: Look = DEFAULT_LOOK;
  /** Zhu et al.'s bounding volumes are drawn over bodies */
  volumes = false;
  /** a person chose the background: the theme leaves it alone */
  choseBackground = false;
  readonly exact: ExactWords;
  readonly #session: Session;
  readonly #moded: (mode: Mode) => void;

  /** `moded`: bodies are shown otherwise. */
  constructor(session: Session, moded: (mode: Mode) => void) {
    this.#session = session;
    this.#moded = moded;
    this.exact = new ExactWords(session);
  }

  set(change: Partial<Look>): void {
    const { mode } = this.look;
    this.look = { ...this.look, ...change };
    this.#session.scene?.setLook(this.look);
    this.#session.update();
    if (this.look.mode !== mode) this.#moded(this.look.mode);
  }

  /** There is something that rays can be cast at. */
  get hasBodies(): boolean {
    return bodiesOf(this.#session.document).some(({ hidden }) => !hidden);
  }

  setMode(mode: Mode): void {
    const isOther = mode !== this.look.mode;
    if (isOther) this.exact.begin();
    const words = mode === 'exact' && isOther ? WORDS.onItsWay : WORDS.mode[mode];
    this.#session.said = this.hasBodies ? words : WORDS.noBodies;
    if (this.hasBodies) this.set({ mode });
    else this.#session.update();
  }

  setVolumes(on: boolean): void {
    if (on === this.volumes) return;
    this.volumes = on;
    this.#session.frames.version++;
    this.#session.update();
  }

  /** For people, who are told. */
  toggleVolumes(): void {
    this.#session.said = this.hasBodies ? WORDS.volumesSaid(!this.volumes) : WORDS.noBodies;
    if (this.hasBodies) this.setVolumes(!this.volumes);
    else this.#session.update();
  }

  setStyle(style: Style, name: string): void {
    this.#session.said = WORDS.style(name);
    this.set({ style });
  }

  setBackground(background: Background): void {
    this.choseBackground = true;
    this.set({ background });
  }
}
