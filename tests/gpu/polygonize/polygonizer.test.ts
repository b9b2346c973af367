/** Meshes from the GPU are those of the CPU: the same loops around the same cells, whatever the values. Creases: creases.test.ts. */
import { afterAll, expect, it } from 'vitest';
import { bindField } from '../../../src/field/bind.ts';
import type { FieldMesh } from '../../../src/field/brickMesh.ts';
import { type Lattice, latticeAround, latticeOver } from '../../../src/field/lattice.ts';
import type { FieldNode, Term } from '../../../src/field/node.ts';
import { type ListedBricks, packBricks } from '../../../src/gpu/polygonize/lists.ts';
import { gpuPolygonizer } from '../../../src/gpu/polygonize/polygonizer.ts';
import type { Vec3 } from '../../../src/math/vec.ts';
import { topology } from '../../../src/mesh/check.ts';
import { body, box, placed, RIGID, SKEW, sphere } from '../../field/trees.ts';
import { askedOf, bricksOf } from '../../fixtures/bricks.ts';
import { withDevice } from '../compute.ts';
import { closeDawn, describeGpu } from '../dawn.ts';
import { allBricks, noiseField, noiseModules } from './noise.ts';
import { onCpu } from './onCpu.ts';
import { placesOf, trianglesOf } from './places.ts';

afterAll(closeDawn);

const onGpu = (node: FieldNode, bricks: ListedBricks, seed: number | null = null): Promise<FieldMesh> =>
  withDevice(async (device) => {
    const polygonizer = gpuPolygonizer(device, null, seed === null ? null : noiseModules(seed));
    const gpu = await polygonizer.whole(node, { ...packBricks(node, bricks), hasCreases: false });
    const mesh = await gpu.read();
    polygonizer.destroy();
    return mesh;
  });

/** Whatever takes the place of noise. */
const ANY = sphere(1);
const hard = (type: 'union' | 'subtraction' | 'intersection', ...parts: readonly FieldNode[]): FieldNode => ({
  type,
  form: 'hard',
  parts,
});
const smooth = (...parts: readonly FieldNode[]): FieldNode => ({ type: 'union', form: 'smooth', parts });

const BODIES: Readonly<Record<string, FieldNode>> = {
  'a sphere': sphere(3),
  'a body of three skels': body(),
  'a moved body': { type: 'affine', matrix: RIGID, node: body() },
  'a stretched body beside a box': hard(
    'union',
    { type: 'affine', matrix: SKEW, node: body() },
    placed(box(2, 1, 3), 6, 1, 0),
  ),
  'a body less a sphere': hard('subtraction', body(), placed(sphere(1.5), 1, 0, 0.5)),
  'bodies on the right of others': smooth(
    sphere(1),
    hard('union', placed(sphere(1), 2, 0, 0), smooth(placed(sphere(2), 0, 3, 0), body())),
  ),
};

/** parts of a step: what lists may miss (bricks.ts), and float32 */
const MISSED = 0.02;

describeGpu('the polygonizer on the GPU', () => {
  it.each([
    [71, [3, 2, 2]],
    [72, [1, 1, 1]],
    [73, [5, 6, 4]],
  ] as const)('makes the mesh of the CPU of noise (seed %i, %j bricks)', async (seed, along) => {
    const bricks = allBricks(along);
    const expected = onCpu(noiseField(seed), bricks.lattice);
    const mesh = await onGpu(ANY, bricks, seed);
    expect(topology(mesh)).toMatchObject({ watertight: true, badEdges: 0, finite: true });
    expect(mesh.positions.length).toBe(expected.positions.length);
    expect(trianglesOf(mesh, bricks.lattice)).toEqual(trianglesOf(expected, bricks.lattice));
  });

  it.each(Object.entries(BODIES))('makes the mesh of the CPU of %s', async (_, node) => {
    const field = bindField(node);
    const bricks = bricksOf(node, latticeAround(field.box!, 30));
    const [mesh, expected] = [await onGpu(node, bricks), onCpu(field, bricks.lattice)];
    expectAlike(mesh, expected, bricks.lattice, MISSED);
  });

  it('cuts off half a cell within the lattice what goes on beyond it', async () => {
    const node = hard(
      'intersection',
      { type: 'shape', shape: { type: 'halfSpace', normal: [0, 0.6, 0.8], offset: 0.3 } },
      sphere(40),
    );
    const bricks = bricksOf(node, latticeOver(5, 14));
    const mesh = await onGpu(node, bricks);
    expect(topology(mesh)).toMatchObject({ watertight: true, genus: 0, components: 1 });
    expectAlike(mesh, onCpu(bindField(node), bricks.lattice), bricks.lattice, 2e-3);
  });

  it('follows lists, with what stands for far skels: as many triangles, each vertex within what is neglected', async () => {
    const node = body(chain(24));
    const field = bindField(node);
    const bricks = bricksOf(node, latticeAround(field.box!, 90));
    expect(askedOf(bricks)).toBeLessThan(12 * bricks.active.length);
    const mesh = await onGpu(node, bricks);
    expectAlike(mesh, onCpu(field, bricks.lattice), bricks.lattice, MISSED);
    const { positions } = mesh;
    for (let i = 0; i < positions.length; i += 3) {
      expect(Math.abs(field.value(positions[i]!, positions[i + 1]!, positions[i + 2]!))).toBeLessThan(4e-3);
    }
  });

  it('makes nothing where nothing is', async () => {
    const lattice: Lattice = { origin: [0, 0, 0], step: 1, counts: [9, 9, 9] };
    const bricks = bricksOf(placed(sphere(1), 50, 0, 0), lattice);
    expect(bricks.active).toEqual([]);
    const mesh = await onGpu(placed(sphere(1), 50, 0, 0), bricks);
    expect(mesh.indices.length + mesh.positions.length).toBe(0);
  });
});

/** A winding line of segments of many colours. */
function chain(count: number): readonly Term[] {
  const at = (i: number): Vec3 => [1.2 * i, 3 * Math.sin(0.6 * i), 3 * Math.cos(0.5 * i)];
  return Array.from({ length: count }, (_, i) => ({
    skel: { type: 'segment', a: at(i), b: at(i + 1), weights: [1.4, 0.1] },
    colour: [(i % 3) / 2, (i % 5) / 4, 0.5],
  }));
}

/** As many triangles, vertices on the same edges and so near, in steps; normals and colours that are alike. */
function expectAlike(mesh: FieldMesh, expected: FieldMesh, lattice: Lattice, near: number): void {
  expect(topology(mesh)).toMatchObject({ watertight: true, badEdges: 0, finite: true });
  expect(mesh.indices.length).toBe(expected.indices.length);
  expect([...placesOf(mesh, lattice)].sort()).toEqual([...placesOf(expected, lattice)].sort());
  const vertexAt = new Map(placesOf(expected, lattice).map((place, vertex) => [place, vertex]));
  const most = { position: 0, normal: 0, colour: 0 };
  placesOf(mesh, lattice).forEach((place, vertex) => {
    const twin = vertexAt.get(place)!;
    const apart = (a: Float32Array, b: Float32Array) =>
      Math.max(...[0, 1, 2].map((axis) => Math.abs(a[3 * vertex + axis]! - b[3 * twin + axis]!)));
    most.position = Math.max(most.position, apart(mesh.positions, expected.positions) / lattice.step);
    most.normal = Math.max(most.normal, apart(mesh.normals, expected.normals));
    most.colour = Math.max(most.colour, apart(mesh.colours, expected.colours));
  });
  expect(most.position).toBeLessThan(near);
  expect(most.normal).toBeLessThan(10 * near);
  expect(most.colour).toBeLessThan(near);
}
