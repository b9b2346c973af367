/** Buffers that stay from one mesh to the next and grow where they are too small; bound with the size that is asked for. */

import { USAGE } from '../usage.ts';

export { USAGE };

/** bytes that every device binds */
export const MOST_BYTES = 1 << 27;

/** The size is there, always. */
export type Slice = GPUBufferBinding & { readonly buffer: GPUBuffer; readonly size: number };

export class Buffers {
  readonly #device: GPUDevice;
  readonly #made = new Map<string, GPUBuffer>();
  readonly #usages = new Map<string, number>();

  constructor(device: GPUDevice) {
    this.#device = device;
  }

  /** The buffer of that name, with whatever is in it, but for one that was made for less. RangeError for more than every device binds. */
  get(name: string, size: number, usage: number): Slice {
    const known = this.#made.get(name);
    const before = this.#usages.get(name) ?? 0;
    if (known && known.size >= size && (before & usage) === usage) return { buffer: known, size };
    if (size > MOST_BYTES) throw new RangeError(`${name}: ${size} bytes are more than every device binds`);
    known?.destroy();
    // half as much again: bodies grow under the pen
    const grown = known && known.size < size ? Math.min(4 * Math.ceil((1.5 * size) / 4), MOST_BYTES) : size;
    const room = Math.max(grown, known?.size ?? 0);
    const buffer = this.#device.createBuffer({ label: name, size: room, usage: before | usage });
    this.#usages.set(name, before | usage);
    this.#made.set(name, buffer);
    return { buffer, size };
  }

  /** The same with bytes in it. */
  put(name: string, bytes: ArrayBuffer | ArrayBufferView<ArrayBuffer>, usage: number): Slice {
    const slice = this.get(name, bytes.byteLength, usage | USAGE.copyTarget);
    this.#device.queue.writeBuffer(slice.buffer, 0, bytes);
    return slice;
  }

  /** What the device still works with stays until it is done. */
  destroy(): void {
    for (const buffer of this.#made.values()) buffer.destroy();
    this.#made.clear();
    this.#usages.clear();
  }
}

/** Bytes of buffers, in one copy. Rejects when the device is lost. */
export async function readBack(device: GPUDevice, slices: readonly Slice[]): Promise<readonly ArrayBuffer[]> {
  const total = slices.reduce((sum, { size }) => sum + size, 0);
  if (total === 0) return slices.map(() => new ArrayBuffer(0));
  const readable = device.createBuffer({
    label: 'read back',
    size: total,
    usage: USAGE.mapRead | USAGE.copyTarget,
  });
  const encoder = device.createCommandEncoder({ label: 'read back' });
  let end = 0;
  const starts = slices.map(({ buffer, size }) => {
    if (size > 0) encoder.copyBufferToBuffer(buffer, 0, readable, end, size);
    end += size;
    return end - size;
  });
  device.queue.submit([encoder.finish()]);
  try {
    await readable.mapAsync(USAGE.mapRead);
    const bytes = readable.getMappedRange();
    return slices.map(({ size }, i) => bytes.slice(starts[i]!, starts[i]! + size));
  } finally {
    readable.destroy();
  }
}
