/** `rotund mesh --backend gpu`: bricks by the device or the CPU, meshes of them in WGSL, on whatever adapter there is, read back. */

import { type Body, bodyMade, keepBody } from '../document/bodies.ts';
import { bindField } from '../field/bind.ts';
import { checkTold, type Lattice } from '../field/lattice.ts';
import { localField, type Sided } from '../field/local.ts';
import type { FieldNode } from '../field/node.ts';
import { type Located, latticed, locating, polygonize } from '../field/polygonize.ts';
import { thinOf } from '../field/thin.ts';
import type { TreeField } from '../field/treeField.ts';
import { cullsOnDevice } from '../gpu/bricks/cullsOnDevice.ts';
import { openDevice } from '../gpu/device.ts';
import { type GpuPolygonizer, gpuPolygonizer, type Where } from '../gpu/polygonize/polygonizer.ts';
import { gpuWork } from '../gpu/polygonize/work.ts';
import { finished } from '../math/finished.ts';
import type { Mesh } from '../mesh/mesh.ts';
import type { BodyMaker, MadeBody } from './bodyMaker.ts';
import type { OpenGpu } from './gpuEvaluator.ts';
import { Problem } from './problem.ts';
import { say } from './say.ts';

/** A maker for the time of `use`, on one device. */
export async function withGpuBodies<T>(open: OpenGpu, use: (make: BodyMaker) => Promise<T>): Promise<T> {
  return open(async (gpu) => {
    const opened = await openDevice(gpu);
    if ('reason' in opened) throw new Problem(`--backend gpu: ${opened.reason}`, 1);
    const polygonizer = gpuPolygonizer(opened.device);
    say(`rotund: bodies are made on ${opened.description.adapter}`);
    try {
      return await use((node, cells, name) => made(polygonizer, node, cells, name));
    } finally {
      polygonizer.destroy();
      opened.release();
    }
  });
}

async function made(
  polygonizer: GpuPolygonizer,
  node: FieldNode,
  cells: number,
  name: string,
): Promise<MadeBody> {
  const known = bodyMade(node);
  if (known?.cells === cells) return { ...known, backend: 'webgpu' };
  const field = bindField(node);
  if (cullsOnDevice(node)) {
    const { lattice, tally, whole } = finished(latticed(field, cells));
    const { mesh, work } = await read(polygonizer, node, lattice, lattice, name);
    const found = thinOn(mesh, whole, lattice, cells, field);
    return kept(node, {
      mesh: { ...mesh, thin: found.thin },
      evaluations: tally.work + work + found.evaluations,
      cells,
    });
  }
  return kept(node, {
    ...(await onGpu(polygonizer, node, finished(locating(field, cells)), { name, cells, field })),
    cells,
  });
}

function kept(node: FieldNode, body: Body): MadeBody {
  keepBody(node, body);
  return { ...body, backend: 'webgpu' };
}

async function onGpu(
  polygonizer: GpuPolygonizer,
  node: FieldNode,
  { bricks, tally }: Located,
  { name, cells, field }: { readonly name: string; readonly cells: number; readonly field: TreeField },
): Promise<Omit<Body, 'cells'>> {
  const { nodes, aVertex } = gpuWork(bricks);
  const { mesh } = await read(polygonizer, node, bricks, bricks.lattice, name);
  const vertices = mesh.positions.length / 3;
  const { thin, evaluations } = thinOn(mesh, localField(bricks), bricks.lattice, cells, field);
  return {
    mesh: { ...mesh, thin },
    evaluations: tally.work + nodes + aVertex * vertices + evaluations,
  };
}

/** Where nothing came of it the CPU has to say whether that is because it is too thin. */
function thinOn(mesh: Mesh, whole: Sided, lattice: Lattice, cells: number, field: TreeField) {
  if (mesh.indices.length > 0) return { thin: thinOf(mesh, lattice, whole), evaluations: 0 };
  const { mesh: again, evaluations } = polygonize(field, cells);
  return { thin: again.thin ?? null, evaluations };
}

/** The mesh, and what the device says that it took to find its bricks. */
async function read(
  polygonizer: GpuPolygonizer,
  node: FieldNode,
  where: Where,
  lattice: Lattice,
  name: string,
) {
  try {
    const onDevice = await polygonizer.whole(node, where);
    try {
      const mesh = await onDevice.read();
      if (mesh.indices.length > 0) checkTold(lattice);
      const { work } = await onDevice.needed();
      return { mesh, work };
    } finally {
      onDevice.destroy();
    }
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    throw new Problem(`--backend gpu, part “${name}”: ${reason}`, 1);
  }
}
