/**
 * A field tree on the GPU, in float32: its records bound once, evaluated at lists of points. Twin of src/field/bind.ts.
 */
import type { FieldNode } from '../field/node.ts';
import { bindRecords, dispatch } from './dispatch.ts';
import { type Entry, fieldPipelines } from './pipelines.ts';
import { programOf } from './program.ts';

export interface GpuField {
  /**
   * Takes another tree; compiles only when kernels, skels, sections, shapes or operations take part that did not before.
   * FieldError for what has no field; the tree before stays then.
   */
  update(node: FieldNode): void;
  /** At points (x, y, z, x, …), mm: value and gradient of each, four numbers a point. */
  evaluate(points: Float32Array): Promise<Float32Array>;
  /** The same with value, red, green, blue (0–1, linear). */
  colours(points: Float32Array): Promise<Float32Array>;
  /** Gives the buffers back; what is under way still comes. */
  destroy(): void;
}

/** The field of a tree on a device. Throws what bindField throws, and a RangeError for more records than every device binds. */
export function gpuField(device: GPUDevice, node: FieldNode): GpuField {
  let bound = bind(device, node);
  let busy: Promise<void> = Promise.resolve();
  let isGone = false;
  const run = async (entry: Entry, points: Float32Array) => {
    if (isGone) throw new Error('the field was given back');
    if (points.length % 3 !== 0) throw new RangeError(`${points.length} numbers are no list of points`);
    const own = bound;
    const values = own.pipelines.pipeline(entry).then((pipeline) => dispatch(device, own, pipeline, points));
    const before = busy;
    // that it is over, not what it came to: results are not to be kept
    busy = Promise.allSettled([before, values]).then(() => undefined);
    return values;
  };
  // What is under way still reads the buffers.
  const discard = (old: typeof bound) => void busy.then(() => old.destroy());
  return {
    update(next) {
      const old = bound;
      bound = bind(device, next);
      discard(old);
    },
    evaluate: (points) => run('points', points),
    colours: (points) => run('colours', points),
    destroy() {
      isGone = true;
      discard(bound);
    },
  };
}

function bind(device: GPUDevice, node: FieldNode) {
  const { records, ingredients } = programOf(node);
  return bindRecords(device, fieldPipelines(device, ingredients), records);
}
