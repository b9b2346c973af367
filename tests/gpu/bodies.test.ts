/** `rotund mesh --backend gpu`: bodies of documents as the CPU makes them, with both backends' work counted. */
import { afterAll, expect, it } from 'vitest';
import { withGpuBodies } from '../../src/cli/gpuBodies.ts';
import { Problem } from '../../src/cli/problem.ts';
import { bodyMade } from '../../src/document/bodies.ts';
import { finerCells } from '../../src/document/cells.ts';
import { isBody } from '../../src/document/document.ts';
import { bindField } from '../../src/field/bind.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { polygonize } from '../../src/field/polygonize.ts';
import { topology } from '../../src/mesh/check.ts';
import { volume } from '../../src/mesh/measure.ts';
import { documentOf, TORUS } from '../cli/drawings.ts';
import { body, box } from '../field/trees.ts';
import { closeDawn, dawnGpu, describeGpu } from './dawn.ts';

afterAll(closeDawn);

const CELLS = 40;

/** The nodes of what a document holds. */
function nodesOf(node: FieldNode): readonly FieldNode[] {
  const { parts } = documentOf([TORUS, { type: 'addBody', name: 'Body', node }]);
  return parts.filter(isBody).map((part) => part.node);
}

describeGpu('bodies of a document on the GPU', () => {
  it('are those of the CPU: genus, triangles, volume', async () => {
    const nodes = nodesOf(body());
    expect(nodes.length).toBe(2);
    await withGpuBodies(
      (use) => use(dawnGpu()),
      async (make) => {
        for (const node of nodes) {
          const { mesh, evaluations, cells } = await make(node, CELLS, 'Body');
          const cpu = polygonize(bindField(node), CELLS);
          const [own, expected] = [topology(mesh), topology(cpu.mesh)];
          expect(own).toMatchObject({ watertight: true, genus: expected.genus });
          expect(mesh.indices.length).toBe(cpu.mesh.indices.length);
          expect(Math.abs(volume(mesh) / volume(cpu.mesh) - 1)).toBeLessThan(1e-4);
          expect(cells).toBe(CELLS);
          // for the exporter
          expect(bodyMade(node)?.mesh).toBe(mesh);
          // at least a value a vertex; not all skels at all nodes
          expect(evaluations).toBeGreaterThan(mesh.positions.length / 3);
          expect(evaluations).toBeLessThan(3 * CELLS ** 3);
        }
      },
    );
  });

  it('are thin in the same places', async () => {
    const node: FieldNode = { type: 'shape', shape: { type: 'torus', ring: 20, tube: 0.5 } };
    const { mesh, backend } = await withGpuBodies(
      (use) => use(dawnGpu()),
      (make) => make(node, CELLS, 'Ring'),
    );
    const { thin } = polygonize(bindField(node), CELLS).mesh;
    expect(backend).toBe('webgpu');
    // how many hang together depends on where each ends its steps
    expect(mesh.thin!.places).toBeGreaterThan(0);
    expect(mesh.thin!.gaps).toBe(0);
    expect(Math.abs(mesh.thin!.least - 1)).toBeLessThan(0.02);
    expect(thin!.least).toBeCloseTo(1, 1);
  });

  it('that no cell sees are made finer as on the CPU, or said to be too thin', async () => {
    const node: FieldNode = { type: 'shape', shape: { type: 'box', half: [20, 0.1, 20] } };
    const { mesh, cells } = await withGpuBodies(
      (use) => use(dawnGpu()),
      (make) => make(node, CELLS, 'Foil'),
    );
    const onCpu = polygonize(bindField(node), CELLS).mesh;
    expect(mesh.indices.length).toBe(0);
    expect(onCpu.indices.length).toBe(0);
    expect(mesh.thin).toEqual(onCpu.thin);
    expect(finerCells({ mesh, cells, evaluations: 0 })).toBe(2 * CELLS);
  });

  it('have their sharp edges', async () => {
    const { mesh } = await withGpuBodies(
      (use) => use(dawnGpu()),
      (make) => make(box(3, 2, 1), 16, 'Box'),
    );
    expect(topology(mesh)).toMatchObject({ watertight: true, genus: 0 });
    expect(volume(mesh)).toBeCloseTo(6 * 4 * 2, 3);
  });

  it('are refused in words where there is no adapter', async () => {
    const none = { requestAdapter: async () => null } as unknown as GPU;
    const made = withGpuBodies(
      (use) => use(none),
      (make) => make(box(1, 1, 1), 16, 'Box'),
    );
    await expect(made).rejects.toThrow(/--backend gpu: /);
    await expect(made).rejects.toBeInstanceOf(Problem);
  });
});
