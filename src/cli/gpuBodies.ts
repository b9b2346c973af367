/** `rotund mesh --backend gpu`: bricks by the device or the CPU, meshes of them in WGSL, on whatever adapter there is, read back. */
import { type Body, bodyMade, keepBody, makeBody } from '../document/bodies.ts';
import { bindField } from '../field/bind.ts';
import { hasCreases, isSmooth } from '../field/bricks.ts';
import type { FieldNode } from '../field/node.ts';
import { type Located, latticed, locating } from '../field/polygonize.ts';
import { cullsOnDevice } from '../gpu/bricks/cullsOnDevice.ts';
import { openDevice } from '../gpu/device.ts';
import { type GpuPolygonizer, gpuPolygonizer, type Where } from '../gpu/polygonize/polygonizer.ts';
import { gpuWork } from '../gpu/polygonize/work.ts';
import type { BodyMaker } from './bodyMaker.ts';
import type { OpenGpu } from './gpuEvaluator.ts';
import { Problem } from './problem.ts';
import { say } from './say.ts';

/** A maker for the time of `use`, on one device. */
export async function withGpuBodies<T>(open: OpenGpu, use: (make: BodyMaker) => Promise<T>): Promise<T> {
  return open(async (gpu) => {
    const opened = await openDevice(gpu);
    if ('reason' in opened) throw new Problem(`--backend gpu: ${opened.reason}`, 1);
    const polygonizer = gpuPolygonizer(opened.device);
    say(`bodies are made on ${opened.description.adapter}`);
    try {
      return await use((node, cells) => made(polygonizer, node, cells));
    } finally {
      polygonizer.destroy();
      opened.release();
    }
  });
}

/** The GPU cuts sharp edges off, so that bodies that have some are the CPU's; smooth ones it finds the bricks of where it can. */
async function made(polygonizer: GpuPolygonizer, node: FieldNode, cells: number): Promise<Body> {
  const known = bodyMade(node);
  if (known?.cells === cells) return known;
  const field = bindField(node);
  if (isSmooth(field) && cullsOnDevice(node)) {
    const { lattice, tally } = finished(latticed(field, cells));
    const { mesh, work } = await read(polygonizer, node, lattice);
    return kept(node, { mesh, evaluations: tally.work + work, cells });
  }
  const located = finished(locating(field, cells));
  if (hasCreases(located.bricks)) {
    say('a body with sharp edges is made by the cpu');
    return makeBody(node, cells);
  }
  return kept(node, { ...(await onGpu(polygonizer, node, located)), cells });
}

function kept(node: FieldNode, body: Body): Body {
  keepBody(node, body);
  return body;
}

function finished<T>(steps: Generator<number, T>): T {
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}

async function onGpu(
  polygonizer: GpuPolygonizer,
  node: FieldNode,
  { bricks, tally }: Located,
): Promise<Omit<Body, 'cells'>> {
  const { nodes, aVertex } = gpuWork(bricks);
  const { mesh } = await read(polygonizer, node, bricks);
  const vertices = mesh.positions.length / 3;
  return { mesh, evaluations: tally.work + nodes + aVertex * vertices };
}

/** The mesh, and what the device says that it took to find its bricks. */
async function read(polygonizer: GpuPolygonizer, node: FieldNode, where: Where) {
  const onDevice = await polygonizer.whole(node, where).catch((error: unknown) => {
    throw new Problem(`--backend gpu: ${error instanceof Error ? error.message : String(error)}`, 1);
  });
  const mesh = await onDevice.read();
  const { work } = await onDevice.needed();
  onDevice.destroy();
  return { mesh, work };
}
