/** A press that lasts does something else than a tap: so does the other button, and the key for menus. */

/** ms: a press this long is a long one */
const LONG = 500;

export class LongPress {
  #timer: ReturnType<typeof setTimeout> | undefined;
  #isDown = false;
  /** the press under way, or the one just ended, was a long one */
  #wasLong = false;
  readonly #deed: () => void;

  constructor(deed: () => void) {
    this.#deed = deed;
  }

  readonly begin = ({ button }: Pick<PointerEvent, 'button'>): void => {
    this.stop();
    this.#wasLong = false;
    this.#isDown = true;
    // the other button has its own event, and no click
    if (button !== 0) return;
    this.#timer = setTimeout(() => {
      this.#wasLong = true;
      this.#deed();
    }, LONG);
  };

  readonly end = (): void => this.stop();

  /** A finger that stays is told of as a menu, too: once is enough. */
  readonly menu = (event: Pick<Event, 'preventDefault'>): void => {
    event.preventDefault();
    const isDone = this.#isDown && this.#wasLong;
    const isTouch = this.#timer !== undefined;
    this.stop();
    if (isDone) return;
    this.#wasLong = isTouch;
    this.#deed();
  };

  /** Whether this click only ends a long press; keys' clicks, which have no detail, never do. */
  swallows({ detail }: Pick<UIEvent, 'detail'>): boolean {
    const isEnd = this.#wasLong && detail > 0;
    this.#wasLong = false;
    return isEnd;
  }

  /** What was pressed is gone. */
  stop(): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    this.#isDown = false;
  }
}
