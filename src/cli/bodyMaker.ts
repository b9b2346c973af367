/** Who makes the meshes of bodies: the seam between `rotund mesh` and what computes. */
import { type Body, makeBody } from '../document/bodies.ts';
import type { FieldNode } from '../field/node.ts';
import type { Backend } from './values.ts';

/** Makes a body in so many cells along its longest side, and keeps it for the exporter (`keepBody`). */
export type BodyMaker = (node: FieldNode, cells: number) => Promise<Body>;

/** Lends a maker for the time of `use`. */
export async function withBodyMaker<T>(backend: Backend, use: (make: BodyMaker) => Promise<T>): Promise<T> {
  if (backend === 'cpu') return use(async (node, cells) => makeBody(node, cells));
  const [{ withGpuBodies }, { withWebGpu }] = await Promise.all([
    import('./gpuBodies.ts'),
    import('./webgpu.ts'),
  ]);
  return withGpuBodies(withWebGpu, use);
}
