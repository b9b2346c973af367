/** Each skel at a point of its own: what `rotund field --backend gpu` and the parity suites ask for. */
import { BATCH, bindRecords, dispatch } from './dispatch.ts';
import { Heap } from './heap.ts';
import { noIngredients, numberOf } from './ingredients.ts';
import { fieldPipelines } from './pipelines.ts';
import { addSkel, type KernelSkel } from './records.ts';
import { PROGRAM, TERM } from './structs.ts';

/**
 * The first skel at the first point (x, y, z, x, …), mm, the second at the second, …: value and gradient, four numbers a
 * point. As many points as skels, a million at most. FieldError for what has no field.
 */
export async function evaluatePairs(
  device: GPUDevice,
  skels: readonly KernelSkel[],
  points: Float32Array,
): Promise<Float32Array> {
  if (points.length !== 3 * skels.length) {
    throw new RangeError(`${points.length / 3} points for ${skels.length} skels`);
  }
  // a second batch would begin with the first skel again
  if (skels.length > BATCH) throw new RangeError(`${skels.length} pairs are more than ${BATCH}`);
  const ingredients = noIngredients();
  for (const { skel, kernel } of skels) {
    ingredients.kernels.add(kernel.name);
    ingredients.primitives.add(skel.type);
  }
  const pipelines = fieldPipelines(device, ingredients);
  const pipeline = await pipelines.pipeline('pairs');
  const bound = bindRecords(device, pipelines, recordsOf(skels));
  return dispatch(device, bound, pipeline, points).finally(() => bound.destroy());
}

function recordsOf(skels: readonly KernelSkel[]): ArrayBuffer {
  const heap = new Heap();
  const program = heap.add(PROGRAM, { first: 0, end: 0 });
  const terms = skels.map((one) => {
    const primitive = numberOf('primitives', one.skel.type);
    const kernel = numberOf('kernels', one.kernel.name);
    return { colour: [0, 0, 0], factor: 1, skel: addSkel(heap, one), warp: 0, kernel, primitive };
  });
  const first = heap.next;
  for (const term of terms) heap.add(TERM, term);
  heap.put(PROGRAM, program, { first, end: heap.next });
  return heap.bytes();
}
