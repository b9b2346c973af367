/**
 * Lattice values from the graphics device: the one seam between this page and fields on the GPU. While `onGpu` is null the page
 * does not offer them.
 */
import { bindField } from '../../field/bind.ts';
import { type Lattice, latticePoints } from '../../field/lattice.ts';
import type { FieldNode } from '../../field/node.ts';

/** What the page needs of a tree on a device. */
export interface TreeOnGpu {
  /** Throws a FieldError where the tree has no field. */
  update(node: FieldNode): void;
  /** x, y, z of each point → value and gradient of each, four numbers a point */
  evaluate(points: Float32Array): Promise<Float32Array>;
  destroy(): void;
}

export const onGpu: ((device: GPUDevice, node: FieldNode) => TreeOnGpu) | null = null;

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
  #tree: TreeOnGpu | null = null;

  constructor(device: GPUDevice) {
    this.#device = device;
  }

  async values(node: FieldNode, lattice: Lattice): Promise<GpuValues> {
    if (!onGpu) throw new Error('trees are not evaluated on the GPU yet');
    if (this.#tree) this.#tree.update(node);
    else this.#tree = (onGpu as (device: GPUDevice, node: FieldNode) => TreeOnGpu)(this.#device, node);
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
