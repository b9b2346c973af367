/** What happens when something has been still for a while. */
export class Lull {
  #timer: ReturnType<typeof setTimeout> | undefined;
  readonly #after: number;
  readonly #still: () => void;

  /** `after` ms without a stir. */
  constructor(after: number, still: () => void) {
    this.#after = after;
    this.#still = still;
  }

  /** It moved. */
  stir(): void {
    this.stop();
    this.#timer = setTimeout(this.#still, this.#after);
  }

  /** There is nothing that could come to rest. */
  stop(): void {
    clearTimeout(this.#timer);
  }
}
