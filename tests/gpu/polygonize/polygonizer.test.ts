/** Meshes from the GPU are those of the CPU: the same loops around the same cells, whatever the values. */
import { afterAll, expect, it } from 'vitest';
import type { Bricks } from '../../../src/field/bricks.ts';
import type { FieldMesh } from '../../../src/field/latticeMesh.ts';
import { meshing } from '../../../src/field/latticeMesh.ts';
import type { FieldNode } from '../../../src/field/node.ts';
import { gpuPolygonizer } from '../../../src/gpu/polygonize/polygonizer.ts';
import { topology } from '../../../src/mesh/check.ts';
import { withDevice } from '../compute.ts';
import { closeDawn, describeGpu } from '../dawn.ts';
import { allBricks, noiseAt, noiseField, noiseModules } from './noise.ts';
import { trianglesOf } from './places.ts';

afterAll(closeDawn);

/** Whatever takes the place of noise. */
const ANY: FieldNode = { type: 'shape', shape: { type: 'sphere', radius: 1 } };

function onCpu({ lattice }: Bricks, seed: number): FieldMesh {
  const [nx, ny, nz] = lattice.counts;
  const values = Float64Array.from({ length: nx * ny * nz }, (_, node) =>
    noiseAt(node % nx, Math.floor(node / nx) % ny, Math.floor(node / (nx * ny)), seed),
  );
  const steps = meshing(noiseField(seed), lattice, values);
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}

describeGpu('the polygonizer on the GPU', () => {
  it.each([
    [71, [3, 2, 2]],
    [72, [1, 1, 1]],
    [73, [4, 5, 3]],
  ] as const)('makes the mesh of the CPU of noise (seed %i, %j bricks)', async (seed, along) => {
    const bricks = allBricks(along);
    const expected = onCpu(bricks, seed);
    await withDevice(async (device) => {
      const polygonizer = gpuPolygonizer(device, null, noiseModules(seed));
      const gpu = await polygonizer.whole(ANY, bricks);
      const mesh = await gpu.read();
      expect(topology(mesh)).toMatchObject({ watertight: true, badEdges: 0, finite: true });
      expect(mesh.positions.length).toBe(expected.positions.length);
      expect(trianglesOf(mesh)).toEqual(trianglesOf(expected));
      polygonizer.destroy();
    });
  });
});
