/** Random trees of everything (ten times as many with ROTUND_FULL): meshes from the GPU are closed, and have the vertices of the CPU's where no value is too small to tell its sign. */
import { afterAll, expect, it } from 'vitest';
import { bindField } from '../../../src/field/bind.ts';
import type { FieldMesh } from '../../../src/field/brickMesh.ts';
import type { Bricks } from '../../../src/field/bricks.ts';
import { latticeAround } from '../../../src/field/lattice.ts';
import type { FieldNode } from '../../../src/field/node.ts';
import { Buffers, readBack } from '../../../src/gpu/polygonize/buffers.ts';
import { encodeField, encodeMesh, meshBuffers, uploadField } from '../../../src/gpu/polygonize/encode.ts';
import { gpuMesh, outputs } from '../../../src/gpu/polygonize/gpuMesh.ts';
import { packBricks } from '../../../src/gpu/polygonize/lists.ts';
import { stagesOn } from '../../../src/gpu/polygonize/stages.ts';
import { programOf } from '../../../src/gpu/program.ts';
import { topology } from '../../../src/mesh/check.ts';
import { Lot } from '../../field/lot.ts';
import { randomTree } from '../../field/randomTrees.ts';
import { bricksOf } from '../../fixtures/bricks.ts';
import { withDevice } from '../compute.ts';
import { closeDawn, describeGpu } from '../dawn.ts';
import { EVERYTHING } from '../everything.ts';
import { onCpu, valuesOf } from './onCpu.ts';
import { placesOf } from './places.ts';

afterAll(closeDawn);

const TREES = process.env.ROTUND_FULL ? 120 : 12;
const CELLS = 14;
/** ms: a pipeline of everything takes lavapipe half a minute */
const PATIENCE = 300_000;
const ROOM = { vertices: 1 << 14, triangles: 1 << 15 };
/** of 1 and the value: signs of smaller values are float32's to choose */
const BLUR = 1e-4;

interface Scene {
  readonly node: FieldNode;
  readonly bricks: Bricks;
}

/** Bounded ones. */
function scenes(seed: number): readonly Scene[] {
  const lot = new Lot(seed);
  const found: Scene[] = [];
  while (found.length < TREES) {
    const node = randomTree(lot);
    const { box } = bindField(node);
    const size = box ? Math.max(...box.max.map((x, axis) => x - box.min[axis]!)) : 0;
    if (box && size > 0 && size < 100)
      found.push({ node, bricks: bricksOf(node, latticeAround(box, CELLS)) });
  }
  return found;
}

/** All by one pipeline, made once. */
async function meshes(device: GPUDevice, all: readonly Scene[]): Promise<readonly FieldMesh[]> {
  const stages = await stagesOn(device)(EVERYTHING);
  const [work, own] = [new Buffers(device), new Buffers(device)];
  const found: FieldMesh[] = [];
  for (const { node, bricks } of all) {
    const written = outputs(own, ROOM);
    const packed = packBricks(node, bricks);
    const field = uploadField(work, programOf(node), packed, ROOM);
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    encodeField(device, pass, stages, field, packed.count);
    encodeMesh(
      device,
      pass,
      stages,
      { ...field, ...meshBuffers(work, packed.count, ROOM), ...written },
      packed.count,
    );
    pass.end();
    device.queue.submit([encoder.finish()]);
    found.push(
      await gpuMesh(
        written,
        (slices) => readBack(device, slices),
        () => {},
      ).read(),
    );
  }
  for (const buffers of [work, own]) buffers.destroy();
  return found;
}

describeGpu('meshes of random trees', () => {
  it(
    `are closed and those of the CPU (${TREES} trees, seed 91)`,
    async () => {
      const all = scenes(91);
      const made = await withDevice((device) => meshes(device, all));
      let compared = 0;
      made.forEach((mesh, i) => {
        const { node, bricks } = all[i]!;
        const about = `tree ${i}: ${JSON.stringify(node)}`;
        expect(topology(mesh), about).toMatchObject({ watertight: true, finite: true });
        const field = bindField(node);
        if (valuesOf(field, bricks.lattice).some((value) => Math.abs(value) < BLUR)) return;
        compared++;
        const expected = onCpu(field, bricks.lattice);
        expect([...placesOf(mesh, bricks.lattice)].sort(), about).toEqual(
          [...placesOf(expected, bricks.lattice)].sort(),
        );
        expect(mesh.indices.length, about).toBe(expected.indices.length);
      });
      expect(compared).toBeGreaterThan(TREES / 2);
    },
    PATIENCE,
  );
});
