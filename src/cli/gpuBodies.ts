/** `rotund mesh --backend gpu`: bricks by the device or the CPU, meshes of them in WGSL, on whatever adapter there is, read back. */

import { type Body, bodyMade, keepBody } from '../document/bodies.ts';
import { bindField } from '../field/bind.ts';
import type { FieldNode } from '../field/node.ts';
import { type Located, latticed, locating } from '../field/polygonize.ts';
import { thinOf } from '../field/thin.ts';
import { cullsOnDevice } from '../gpu/bricks/cullsOnDevice.ts';
import { openDevice } from '../gpu/device.ts';
import { type GpuPolygonizer, gpuPolygonizer, type Where } from '../gpu/polygonize/polygonizer.ts';
import { gpuWork } from '../gpu/polygonize/work.ts';
import { finished } from '../math/finished.ts';
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
    const { lattice, tally } = finished(latticed(field, cells));
    const { mesh, work } = await read(polygonizer, node, lattice, name);
    const thin = thinOf(mesh, lattice);
    return kept(node, { mesh: { ...mesh, thin }, evaluations: tally.work + work, cells });
  }
  return kept(node, { ...(await onGpu(polygonizer, node, finished(locating(field, cells)), name)), cells });
}

function kept(node: FieldNode, body: Body): MadeBody {
  keepBody(node, body);
  return { ...body, backend: 'webgpu' };
}

async function onGpu(
  polygonizer: GpuPolygonizer,
  node: FieldNode,
  { bricks, tally }: Located,
  name: string,
): Promise<Omit<Body, 'cells'>> {
  const { nodes, aVertex } = gpuWork(bricks);
  const { mesh } = await read(polygonizer, node, bricks, name);
  const vertices = mesh.positions.length / 3;
  const thin = thinOf(mesh, bricks.lattice);
  return { mesh: { ...mesh, thin }, evaluations: tally.work + nodes + aVertex * vertices };
}

/** The mesh, and what the device says that it took to find its bricks. */
async function read(polygonizer: GpuPolygonizer, node: FieldNode, where: Where, name: string) {
  try {
    const onDevice = await polygonizer.whole(node, where);
    try {
      const mesh = await onDevice.read();
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
