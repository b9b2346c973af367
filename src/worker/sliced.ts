/** Long work in slices, between which a worker hears messages. */

/** ms of work between two looks at the messages */
const SLICE = 12;

/** Runs steps to their end as long as they are wanted; null when they were given up. `progress` hears what share is done, 0–1. */
export async function sliced<T>(
  work: Generator<number, T>,
  wanted: () => boolean,
  progress: (share: number) => void = () => {},
): Promise<T | null> {
  let until = performance.now() + SLICE;
  for (;;) {
    const { done, value } = work.next();
    if (done) return value;
    if (performance.now() < until) continue;
    progress(value);
    await breath();
    if (!wanted()) return null;
    until = performance.now() + SLICE;
  }
}

const { port1, port2 } = new MessageChannel();

/** Lets messages in. A timer would take 4 ms. */
function breath(): Promise<void> {
  return new Promise((resolve) => {
    port1.onmessage = () => resolve();
    port2.postMessage(null);
  });
}
