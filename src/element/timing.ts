/** How long it takes from pen-up to the first coarse mesh of a solid and to the fine one: entries of the page's timeline, for whoever measures. */
import { type Body, bodyMade } from '../document/bodies.ts';
import type { FieldNode } from '../field/node.ts';

export const TIMINGS = { coarse: 'rotund: pen-up to coarse', fine: 'rotund: pen-up to fine' } as const;

export class Timing {
  #node: FieldNode | null = null;
  #start = 0;
  #first: Body | null = null;
  #isCoarse = false;

  /** The pen is lifted, now or at `start`: what comes of it is this tree. */
  begin(node: FieldNode | null, start = performance.now()): void {
    this.#node = node;
    this.#start = start;
    this.#first = node && bodyMade(node);
    this.#isCoarse = false;
  }

  /** Something was made: `cells` are those of the fine mesh. */
  look(cells: (node: FieldNode) => number): void {
    const body = this.#node && bodyMade(this.#node);
    if (!this.#node || !body || body === this.#first || body.cells === 0) return;
    if (!this.#isCoarse) this.#say(TIMINGS.coarse);
    this.#isCoarse = true;
    if (body.cells < cells(this.#node)) return;
    this.#say(TIMINGS.fine);
    this.#node = null;
  }

  #say(name: string): void {
    performance.measure(name, { start: this.#start, end: performance.now() });
  }
}
