/** A slider that is dragged: what it would do is only shown until it is let go, and is one undo step then. */
import type { Command } from '../document/command/index.ts';
import type { State } from '../tool/tool.ts';
import { trial } from '../tool/trial.ts';
import type { ToolInHand } from './toolInHand.ts';

export class SliderTrial {
  /** until the slider is let go */
  isCancelled = false;
  /** what is shown */
  #tuned: State | null = null;
  readonly #hand: ToolInHand;

  constructor(hand: ToolInHand) {
    this.#hand = hand;
  }

  /** What is shown is what it would do. */
  get isShown(): boolean {
    return this.#hand.state === this.#tuned;
  }

  /** It is taken hold of or let go: what was only shown is over. */
  hold(): void {
    this.isCancelled = false;
    if (this.isShown) this.#hand.put(this.#hand.idle);
    this.#tuned = null;
  }

  /** `run` carries the command out when the slider is let go. */
  tune(command: Command, done: boolean, run: (command: Command) => void): void {
    if (this.isCancelled) return;
    this.#tuned = null;
    const { idle } = this.#hand;
    this.#hand.put(idle);
    if (done) {
      run(command);
      return;
    }
    this.#tuned = trial(command, idle);
    this.#hand.put(this.#tuned);
  }

  /** Another gesture takes its place. */
  cancel(): void {
    if (this.isShown) this.isCancelled = true;
    this.#tuned = null;
  }
}
