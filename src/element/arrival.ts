/** Something that comes and goes, and those who wait for it. */
export class Arrival<T> {
  #present: T | null = null;
  #failure: { readonly error: unknown } | null = null;
  #waiting: { readonly resolve: (thing: T) => void; readonly reject: (error: unknown) => void }[] = [];

  /** Resolves at once when it is there, else when it comes. */
  get(): Promise<T> {
    if (this.#present !== null) return Promise.resolve(this.#present);
    if (this.#failure) return Promise.reject(this.#failure.error);
    return new Promise((resolve, reject) => this.#waiting.push({ resolve, reject }));
  }

  come(thing: T): void {
    this.#present = thing;
    this.#failure = null;
    for (const { resolve } of this.#waiting.splice(0)) resolve(thing);
  }

  /** Gone, and expected back. */
  go(): void {
    this.#present = null;
    this.#failure = null;
  }

  /** It will not come, unless somebody says `go`. */
  fail(error: unknown): void {
    this.#present = null;
    this.#failure = { error };
    for (const { reject } of this.#waiting.splice(0)) reject(error);
  }
}
