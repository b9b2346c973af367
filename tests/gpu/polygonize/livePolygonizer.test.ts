/** Edited bodies on the GPU: what an edit does not reach is neither written nor evaluated, and the mesh is that of all bricks. */
import { afterAll, expect, it } from 'vitest';
import { LiveField } from '../../../src/field/liveField.ts';
import type { FieldNode } from '../../../src/field/node.ts';
import { packBricks } from '../../../src/gpu/polygonize/lists.ts';
import { type LivePolygonizer, livePolygonizer } from '../../../src/gpu/polygonize/livePolygonizer.ts';
import { packEdit } from '../../../src/gpu/polygonize/packEdit.ts';
import { gpuPolygonizer } from '../../../src/gpu/polygonize/polygonizer.ts';
import { topology } from '../../../src/mesh/check.ts';
import { finished } from '../../field/finished.ts';
import { offBy } from '../../field/meshes.ts';
import { body, placed } from '../../field/trees.ts';
import { withDevice } from '../compute.ts';
import { closeDawn, describeGpu } from '../dawn.ts';
import { trianglesOf } from './places.ts';

afterAll(closeDawn);

/** A row of bones, one of which leans, less than the last. */
const bones = (count: number, lean: number): FieldNode => ({
  ...body(
    Array.from({ length: count }, (_, i) => ({
      skel: {
        type: 'segment',
        a: [8 * i, 0, 0],
        b: [8 * i + 2, 9, i === 4 ? lean : i === 13 ? 5 : 0],
        weights: [1],
      },
      colour: [(i % 3) / 2, 0.5, 0.2],
    })),
  ),
  kernel: 'quartic',
  params: { R: 4 },
});
const union = (x: number): FieldNode => ({
  type: 'union',
  form: 'smooth',
  parts: [bones(3, 0), placed(bones(1, 0), 30, x, 0), placed(bones(1, 0), 50, 4, 0)],
});

/** Bytes that are written to the device from now on, but for those that all meshes need. */
function counting(device: GPUDevice): { bytes: number } {
  const count = { bytes: 0 };
  const { queue } = device;
  const writeBuffer = queue.writeBuffer.bind(queue);
  queue.writeBuffer = (buffer, offset, data, ...rest) => {
    if (buffer.label !== 'loops') count.bytes += data.byteLength;
    writeBuffer(buffer, offset, data, ...rest);
  };
  return count;
}

async function expectMeshOf(
  live: LivePolygonizer,
  device: GPUDevice,
  nodes: readonly FieldNode[],
  most: number,
) {
  const field = new LiveField(64, true);
  const polygonizer = gpuPolygonizer(device);
  const count = counting(device);
  const first = finished(field.locating(nodes[0]!));
  const begun = await live.whole(nodes[0]!, packBricks(nodes[0]!, first.bricks));
  const { bytes } = count;
  expect(live.evaluated).toBe(first.bricks.active.length);
  begun.destroy();
  for (const node of nodes.slice(1)) {
    const step = finished(field.locating(node));
    expect(step).toMatchObject({ isEdit: true, isGrown: false });
    const { active, lattice } = step.bricks;
    count.bytes = 0;
    const mesh = await live.edit(node, [packEdit(node, step)]);
    console.info(`an edit: ${live.evaluated} of ${active.length} bricks, ${count.bytes} of ${bytes} bytes`);
    expect(count.bytes).toBeLessThan(most * bytes);
    expect(live.evaluated).toBeLessThan(most * active.length);
    const made = await mesh.read();
    mesh.destroy();
    const all = await polygonizer.whole(node, packBricks(node, step.bricks));
    const expected = await all.read();
    all.destroy();
    expect(topology(made)).toMatchObject({ watertight: true, badEdges: 0, finite: true });
    expect(trianglesOf(made, lattice)).toEqual(trianglesOf(expected, lattice));
    expect(offBy(node, made, lattice.step)).toBeLessThan(0.03);
  }
  polygonizer.destroy();
}

describeGpu('a body that is edited on the GPU', () => {
  it('makes nothing where nothing is, and something again', async () => {
    await withDevice(async (device) => {
      const polygonizer = gpuPolygonizer(device);
      const live = livePolygonizer(device, polygonizer);
      for (const [threshold, isEmpty] of [
        [1e3, true],
        [1, false],
      ] as const) {
        const node: FieldNode = { ...bones(3, 0), threshold } as FieldNode;
        const { bricks } = finished(new LiveField(24, true).locating(node));
        const mesh = await live.whole(node, packBricks(node, bricks));
        const { triangles } = await mesh.needed();
        expect(triangles === 0).toBe(isEmpty);
        mesh.destroy();
      }
      live.destroy();
      polygonizer.destroy();
    });
  });

  it('is evaluated and written where one of its skels moves', async () => {
    await withDevice(async (device) => {
      const polygonizer = gpuPolygonizer(device);
      const live = livePolygonizer(device, polygonizer);
      const nodes = [0, 0.4, 1.3, 1.25, 0].map((lean) => bones(14, lean));
      await expectMeshOf(live, device, nodes, 0.3);
      live.destroy();
      polygonizer.destroy();
    });
  });

  it('is evaluated and written where one of its parts moves', async () => {
    await withDevice(async (device) => {
      const polygonizer = gpuPolygonizer(device);
      const live = livePolygonizer(device, polygonizer);
      await expectMeshOf(live, device, [0, 0.5, 3].map(union), 0.4);
      live.destroy();
      polygonizer.destroy();
    });
  });

  it('takes several edits at once, and meshes that did not fit', async () => {
    await withDevice(async (device) => {
      const polygonizer = gpuPolygonizer(device, { vertices: 60, triangles: 100 });
      const live = livePolygonizer(device, polygonizer);
      await expect(live.edit(bones(5, 0), [])).rejects.toThrow('no bricks');
      const field = new LiveField(40, true);
      const first = finished(field.locating(bones(14, 0)));
      await live.whole(bones(14, 0), packBricks(bones(14, 0), first.bricks));
      const edits = [0.5, 1.5].map((lean) =>
        packEdit(bones(14, lean), finished(field.locating(bones(14, lean)))),
      );
      const mesh = await live.edit(bones(14, 1.5), edits);
      const made = await mesh.read();
      expect(topology(made)).toMatchObject({ watertight: true, components: 14 });
      expect(offBy(bones(14, 1.5), made, first.bricks.lattice.step)).toBeLessThan(0.03);
      live.destroy();
      polygonizer.destroy();
    });
  });
});
