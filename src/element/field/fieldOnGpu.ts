/** Lattice values from the graphics device. */
import { type Lattice, latticePoints, nodeCount } from '../../field/lattice.ts';
import type { FieldNode } from '../../field/node.ts';
import { type GpuField, gpuField } from '../../gpu/field.ts';

/** The values of one device; the tree is kept on it from one body to the next. */
export class FieldOnGpu {
  readonly #device: GPUDevice;
  #tree: GpuField | null = null;
  /** what `#tree` was made of last */
  #node: FieldNode | null = null;

  constructor(device: GPUDevice) {
    this.#device = device;
  }

  /** Throws what `gpuField` throws. */
  async values(node: FieldNode, lattice: Lattice): Promise<Float32Array<ArrayBuffer>> {
    const found = await this.#treeOf(node).evaluate(latticePoints(lattice));
    // value and gradient of each node
    const values = new Float32Array(nodeCount(lattice));
    for (let i = 0; i < values.length; i++) values[i] = found[4 * i]!;
    return values;
  }

  destroy(): void {
    this.#tree?.destroy();
    this.#tree = null;
  }

  /** A body that outgrows its lattice asks for the same tree again. */
  #treeOf(node: FieldNode): GpuField {
    if (!this.#tree) this.#tree = gpuField(this.#device, node);
    else if (node !== this.#node) this.#tree.update(node);
    this.#node = node;
    return this.#tree;
  }
}
