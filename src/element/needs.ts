/** Trees whose bodies files wait for, until each of them is made as files have to be, or cannot be made. */
import type { FieldNode } from '../field/node.ts';

/** What waits for bodies. */
export interface Waiting {
  /** gives them up; the promise rejects with its reason */
  readonly signal?: AbortSignal;
  /** hears what share is there, 0–1 */
  readonly progress?: (share: number) => void;
}

interface Need {
  readonly nodes: readonly FieldNode[];
  readonly progress: (share: number) => void;
  readonly resolve: () => void;
  /** of what gives it up, which may live on */
  readonly deaf: AbortController;
}

export class Needs {
  #all: readonly Need[] = [];

  get nodes(): readonly FieldNode[] {
    return this.#all.flatMap(({ nodes }) => nodes);
  }

  /** `changed` hears of what came, and of what was given up. */
  wait(
    nodes: readonly FieldNode[],
    { signal, progress = () => {} }: Waiting,
    changed: () => void,
  ): Promise<void> {
    return new Promise((resolve, reject) => {
      signal?.throwIfAborted();
      const need = { nodes, progress, resolve, deaf: new AbortController() };
      this.#all = [...this.#all, need];
      const giveUp = () => {
        this.#drop(need);
        reject(signal?.reason as Error);
        changed();
      };
      signal?.addEventListener('abort', giveUp, { signal: need.deaf.signal });
      changed();
    });
  }

  /** How much of each there is: 1 where it is made, or never will be. */
  tell(shareOf: (node: FieldNode) => number): void {
    for (const need of this.#all) {
      const { nodes, progress, resolve } = need;
      const shares = nodes.map(shareOf);
      const isDone = shares.every((share) => share === 1);
      progress(isDone ? 1 : shares.reduce((sum, share) => sum + share, 0) / nodes.length);
      if (!isDone) continue;
      this.#drop(need);
      resolve();
    }
  }

  #drop(need: Need): void {
    need.deaf.abort();
    this.#all = this.#all.filter((other) => other !== need);
  }
}
