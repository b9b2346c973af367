/** Who makes the meshes of bodies: the seam between `rotund mesh` and what computes. */
import { type Body, makeBody } from '../document/bodies.ts';
import { finerCells } from '../document/cells.ts';
import type { FieldNode } from '../field/node.ts';
import type { Backend } from './values.ts';

export interface MadeBody extends Body {
  /** what computed its mesh */
  readonly backend: 'cpu' | 'webgpu';
}

/** Makes a body in so many cells along its longest side, and keeps it for the exporter (`keepBody`). `name`: for messages. */
export type BodyMaker = (node: FieldNode, cells: number, name: string) => Promise<MadeBody>;

/** In finer cells where a body is thinner than they are, as the application makes it. */
export const shownWhole =
  (make: BodyMaker): BodyMaker =>
  async (node, cells, name) => {
    const body = await make(node, cells, name);
    const finer = finerCells(body);
    if (finer === cells) return body;
    const second = await make(node, finer, name);
    return { ...second, evaluations: body.evaluations + second.evaluations };
  };

/** Lends a maker for the time of `use`. */
export async function withBodyMaker<T>(backend: Backend, use: (make: BodyMaker) => Promise<T>): Promise<T> {
  if (backend === 'cpu') return use(async (node, cells) => ({ ...makeBody(node, cells), backend: 'cpu' }));
  const [{ withGpuBodies }, { withWebGpu }] = await Promise.all([
    import('./gpuBodies.ts'),
    import('./webgpu.ts'),
  ]);
  return withGpuBodies(withWebGpu, use);
}
