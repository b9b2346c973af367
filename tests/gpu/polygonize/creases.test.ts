/**
 * Sharp edges of meshes from the GPU: within 0.1 cell of the true ones, and the same mesh as the CPU's. Numbers of triangles may differ where float32
 * decides otherwise than float64: whether Newton's steps come to an end within reach, on which of two sides a vertex is that is on both.
 */
import { afterAll, expect, it, vi } from 'vitest';
import { bindField } from '../../../src/field/bind.ts';
import type { FieldMesh } from '../../../src/field/brickMesh.ts';
import { hasCreases } from '../../../src/field/bricks.ts';
import type { FieldNode } from '../../../src/field/node.ts';
import { type Polygonized, polygonize } from '../../../src/field/polygonize.ts';
import type { TreeField } from '../../../src/field/treeField.ts';
import { gpuPolygonizer } from '../../../src/gpu/polygonize/polygonizer.ts';
import { topology } from '../../../src/mesh/check.ts';
import { type CreaseCase, creaseCases } from '../../field/creaseCases.ts';
import { expectSharp } from '../../field/creaseChecks.ts';
import { hardTree } from '../../field/hardTrees.ts';
import { Lot } from '../../field/lot.ts';
import { set, touches } from '../../field/meshes.ts';
import { body, box, type Point, placed, sphere } from '../../field/trees.ts';
import { withDevice } from '../compute.ts';
import { closeDawn, describeGpu } from '../dawn.ts';

afterAll(closeDawn);

const CELLS = 48;
/** cells: what lists miss, and where Newton's steps end */
const ON = 0.016;

interface Both extends Polygonized {
  readonly gpu: FieldMesh;
  readonly field: TreeField;
}

async function onBoth(node: FieldNode, cells: number): Promise<Both> {
  const field = bindField(node);
  const cpu = polygonize(field, cells);
  expect(hasCreases(cpu.bricks.active)).toBe(true);
  const gpu = await withDevice(async (device) => {
    const polygonizer = gpuPolygonizer(device);
    const mesh = await (await polygonizer.whole(node, cpu.bricks)).read();
    polygonizer.destroy();
    return mesh;
  });
  return { ...cpu, gpu, field };
}

/** Parts of a step by which vertices are off the surface, the largest first. */
function off({ field, lattice }: Both, { positions }: FieldMesh): readonly number[] {
  const out = new Float64Array(4);
  const all: number[] = [];
  for (let i = 0; i < positions.length; i += 3) {
    field.evaluate(positions[i]!, positions[i + 1]!, positions[i + 2]!, out);
    all.push(Math.abs(out[0]!) / Math.hypot(out[1]!, out[2]!, out[3]!) / lattice.step);
  }
  return all.sort((a, b) => b - a);
}

function expectAlike(both: Both): void {
  const { gpu, mesh } = both;
  expect(topology(gpu)).toEqual(topology(mesh));
  expect(touches(gpu)).toBe(false);
  expect(gpu.indices.length).toBe(mesh.indices.length);
  expect(gpu.positions.length).toBe(mesh.positions.length);
  expect(off(both, gpu)[0]).toBeLessThan(ON);
}

/** A tree of each kind of set, off the lattice. */
const SETS: Readonly<Record<string, FieldNode>> = {
  'a smooth union of a body and a box': set('union', 'smooth', body(), placed(box(2, 1, 3), 6, 1, 0)),
  'a blend less a box: one smooth field': set(
    'subtraction',
    'hard',
    { type: 'blend', a: body(), b: placed(sphere(3), 5, 1, 0), a0: 0.5, a1: 1, a2: 1 },
    placed(box(9, 2, 2), 0.1, 0.3, 2.2),
  ),
};

/** ms: pipelines compile for each, and a busy machine is no failure */
const PATIENCE = 300_000;

vi.setConfig({ testTimeout: PATIENCE });

describeGpu('creases on the GPU', () => {
  it.each(creaseCases())('are sharp and those of the CPU: $name', async (one: CreaseCase) => {
    const both = await onBoth(one.node, CELLS);
    expectSharp(both.gpu, both.lattice, one);
    expectAlike(both);
  });

  it.each(Object.entries(SETS))('are those of the CPU: %s', async (_, node) => {
    expectAlike(await onBoth(node, CELLS));
  });

  it('end where the body is cut off: a wedge without end', async () => {
    const plane = (normal: Point): FieldNode =>
      placed({ type: 'shape', shape: { type: 'halfSpace', normal, offset: 0 } }, 3, 5, 7);
    const { gpu, mesh } = await onBoth(
      set('intersection', 'hard', plane([0, 0.6, 0.8]), plane([1, 0, 0])),
      24,
    );
    expect(topology(gpu)).toEqual(topology(mesh));
    expect(gpu.indices.length).toBe(mesh.indices.length);
    expect(touches(gpu)).toBe(false);
  });

  it('are closed wherever they meet: a row of trees drawn by lot (seeds from 4300)', async () => {
    const trees = Array.from({ length: 8 }, (_, i) => placed(hardTree(new Lot(4300 + i)), 16 * i, 0, 0));
    const both = await onBoth(set('union', 'hard', ...trees), 200);
    const { gpu, mesh } = both;
    const [own, expected] = [topology(gpu), topology(mesh)];
    expect(own).toMatchObject({ watertight: true, finite: true, euler: expected.euler });
    expect(touches(gpu)).toBe(false);
    console.info(`triangles: ${gpu.indices.length / 3}, of the CPU ${mesh.indices.length / 3}`);
    expect(Math.abs(gpu.indices.length / mesh.indices.length - 1)).toBeLessThan(1e-3);
    // of blades some points are beside what else there is, on both alike
    const [far, farther] = [off(both, gpu), off(both, mesh)];
    const count = (all: readonly number[]) => all.filter((x) => x > ON).length;
    expect(count(far)).toBeLessThan(1.1 * count(farther) + 10);
  });

  it('that do not fit are told, and made again', async () => {
    const node = box(3, 2, 1);
    const { bricks } = polygonize(bindField(node), 20);
    await withDevice(async (device) => {
      const whole = gpuPolygonizer(device);
      const first = await whole.whole(node, bricks);
      const [expected, needed] = [await first.read(), await first.needed()];
      const rooms = [
        { ...needed, vertices: needed.vertices - 1 },
        { ...needed, triangles: needed.triangles - 1 },
      ];
      for (const room of rooms) {
        const polygonizer = gpuPolygonizer(device, room);
        const small = await polygonizer.polygonize(node, bricks);
        expect(await small.overflowed()).toBe(true);
        expect(await small.needed()).toMatchObject({
          vertices: needed.vertices,
          triangles: needed.triangles,
        });
        expect(await (await polygonizer.whole(node, bricks)).read()).toEqual(expected);
        polygonizer.destroy();
      }
      const just = gpuPolygonizer(device, needed);
      expect(await (await just.polygonize(node, bricks)).overflowed()).toBe(false);
      for (const polygonizer of [whole, just]) polygonizer.destroy();
    });
  });
});
