/** Each skel at its own point, on a device opened for it alone: what `rotund field --backend gpu` asks for. */
import { openDevice } from './device.ts';
import { evaluatePairs } from './pairs.ts';
import type { KernelSkel } from './records.ts';

export interface Evaluated {
  /** value and gradient, four numbers a skel */
  readonly values: Float32Array;
  /** e.g. "google swiftshader" */
  readonly adapter: string;
}

/** The field of the first skel at the first point (x, y, z, x, …), mm, and so on; or why there is no device. */
export async function evaluateAlone(
  gpu: GPU,
  skels: readonly KernelSkel[],
  points: Float32Array,
): Promise<Evaluated | { readonly reason: string }> {
  const opened = await openDevice(gpu);
  if ('reason' in opened) return opened;
  const { device, description, release } = opened;
  try {
    return { values: await evaluatePairs(device, skels, points), adapter: description.adapter };
  } finally {
    release();
  }
}
