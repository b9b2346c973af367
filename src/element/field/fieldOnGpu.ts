/**
 * Lattice values from the graphics device, and how far they are from the float64 ones.
 */
import { bindField } from '../../field/bind.ts';
import { type Lattice, latticePoints } from '../../field/lattice.ts';
import type { FieldNode } from '../../field/node.ts';
import { type GpuField, gpuField } from '../../gpu/field.ts';

/** points at which the two are compared */
const SAMPLES = 256;

export interface GpuValues {
  readonly values: Float32Array;
  /** largest difference from float64 among the samples, in parts of the value where that is above 1 */
  readonly difference: number;
}

/** The values of one device; the tree is kept on it from one body to the next. */
export class FieldOnGpu {
  readonly #device: GPUDevice;
  #tree: GpuField | null = null;

  constructor(device: GPUDevice) {
    this.#device = device;
  }

  async values(node: FieldNode, lattice: Lattice): Promise<GpuValues> {
    if (this.#tree) this.#tree.update(node);
    else this.#tree = gpuField(this.#device, node);
    const points = latticePoints(lattice);
    const found = await this.#tree.evaluate(points);
    const values = Float32Array.from({ length: points.length / 3 }, (_, i) => found[4 * i]!);
    return { values, difference: differenceAt(node, points, values) };
  }

  destroy(): void {
    this.#tree?.destroy();
    this.#tree = null;
  }
}

function differenceAt(node: FieldNode, points: Float32Array, values: Float32Array): number {
  const field = bindField(node);
  const step = Math.max(1, Math.floor(values.length / SAMPLES));
  let most = 0;
  for (let i = 0; i < values.length; i += step) {
    const exact = field.value(points[3 * i]!, points[3 * i + 1]!, points[3 * i + 2]!);
    most = Math.max(most, Math.abs(values[i]! - exact) / Math.max(1, Math.abs(exact)));
  }
  return most;
}
