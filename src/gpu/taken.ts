/** What a graphics device says of work: nothing where it has taken it, else why it refuses. */

/** What `work` begins, once the device has taken it; `what` it was for. Throws what `work` throws. */
export async function taken<T>(device: GPUDevice, what: string, work: () => T): Promise<T> {
  for (const filter of ['out-of-memory', 'validation'] as const) device.pushErrorScope(filter);
  const begun = settled(work);
  const refusals = await Promise.all([device.popErrorScope(), device.popErrorScope()]);
  const refusal = refusals.find((error) => error !== null);
  if ('error' in begun) throw begun.error;
  if (refusal) throw new Error(`the graphics device refused ${what}: ${refusal.message}`);
  return begun.value;
}

/** What came of it, or what was thrown. */
function settled<T>(work: () => T): { readonly value: T } | { readonly error: unknown } {
  try {
    return { value: work() };
  } catch (error) {
    return { error };
  }
}
