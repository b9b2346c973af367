/** Runs steps to their end; `progress` hears what each yields. */
export function finished<T, Y>(steps: Generator<Y, T>, progress: (step: Y) => void = () => {}): T {
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
    progress(value);
  }
}
