/** What was asked for lately, by name. Those that were not asked for longest go where all together are too large. */
export class Lately<T> {
  /** the one asked for last comes last */
  readonly #kept = new Map<string, T>();

  get names(): readonly string[] {
    return [...this.#kept.keys()];
  }

  /** As it is; nobody asks for it. */
  known(name: string): T | null {
    return this.#kept.get(name) ?? null;
  }

  /** In place of what had that name: it is the one asked for last. */
  put(name: string, value: T): void {
    this.#kept.delete(name);
    this.#kept.set(name, value);
  }

  drop(name: string): void {
    this.#kept.delete(name);
  }

  /** Lets go of what is too much, by sizes, and not among `spared`, whose sizes do not count. */
  trim(most: number, sizeOf: (value: T) => number, spared: readonly string[] = []): void {
    let size = 0;
    for (const name of this.names.toReversed()) {
      if (spared.includes(name)) continue;
      size += sizeOf(this.#kept.get(name)!);
      if (size > most) this.#kept.delete(name);
    }
  }
}
