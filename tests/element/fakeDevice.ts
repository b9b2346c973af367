/** A graphics device as far as error scopes go: what is asked of it while it `refuses` is told to the innermost scopes. */
export class FakeDevice {
  /** why; null: it takes what it is asked for */
  refuses: string | null = null;
  readonly #scopes: (string | null)[] = [];

  get gpu(): GPUDevice {
    return this as unknown as GPUDevice;
  }

  readonly queue = { onSubmittedWorkDone: async () => {}, submit: () => {} };

  /** Something was. */
  asked(): void {
    if (this.refuses !== null && this.#scopes.length > 0)
      this.#scopes[this.#scopes.length - 1] ??= this.refuses;
  }

  pushErrorScope(): void {
    this.#scopes.push(null);
  }

  async popErrorScope(): Promise<{ readonly message: string } | null> {
    const message = this.#scopes.pop() ?? null;
    return message === null ? null : { message };
  }
}
