/** Fields on the GPU know which smooth field their value is from, and its value alone, as on the CPU (Near.branch, Near.onBranch). */
import { afterAll, expect, it } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { branchOf, type Near, Tally } from '../../src/field/near.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { polygonize } from '../../src/field/polygonize.ts';
import { compile, link } from '../../src/gpu/link.ts';
import { fieldModules } from '../../src/gpu/modules.ts';
import { readBack } from '../../src/gpu/polygonize/buffers.ts';
import { CREASED } from '../../src/gpu/polygonize/stages.ts';
import { programOf } from '../../src/gpu/program.ts';
import { hardTree } from '../field/hardTrees.ts';
import { Lot } from '../field/lot.ts';
import type { Point } from '../field/trees.ts';
import { withDevice } from './compute.ts';
import { closeDawn, describeGpu } from './dawn.ts';
import { EVERYTHING } from './everything.ts';

afterAll(closeDawn);

/** Of a point and a branch: the field and its branch, and the field of that branch. */
const ENTRY = `#import field/branches
@group(0) @binding(0) var<storage, read> points: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> values: array<vec4f>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
  if (id.x >= arrayLength(&points)) { return; }
  let point = points[id.x];
  for (var i = 0u; i < 2u; i++) {
    let found = run_branches(point.xyz, false, select(u32(point.w), NO_BRANCH, i == 0u));
    values[2u * id.x + i] = select(found.field, vec4f(found.field.x, f32(found.branch), 0.0, 0.0), i == 0u);
  }
}
`;

interface Asked {
  readonly node: FieldNode;
  readonly points: readonly Point[];
  readonly wanted: readonly number[];
}

/** All by one pipeline. */
const onGpu = (all: readonly Asked[]): Promise<readonly Float32Array[]> =>
  withDevice(async (device) => {
    const ingredients = { ...EVERYTHING, kernels: new Set(['cauchy'] as const), sections: new Set<never>() };
    const modules = { ...fieldModules(ingredients), shape: CREASED.shape!, test: ENTRY };
    const module = await compile(device, 'branches', link(modules, 'test'));
    const pipeline = await device.createComputePipelineAsync({ layout: 'auto', compute: { module } });
    const found: Float32Array[] = [];
    for (const { node, points, wanted } of all) {
      const put = (bytes: ArrayBuffer) => {
        const buffer = device.createBuffer({ size: bytes.byteLength, usage: 0x80 | 0x4 | 0x8 });
        device.queue.writeBuffer(buffer, 0, bytes);
        return { buffer, size: bytes.byteLength };
      };
      const values = put(new ArrayBuffer(32 * points.length));
      const at = put(Float32Array.from(points.flatMap((p, i) => [...p, wanted[i]!])).buffer);
      const records = put(programOf(node).records);
      const encoder = device.createCommandEncoder();
      const pass = encoder.beginComputePass();
      pass.setPipeline(pipeline);
      [[at, values], [records]].forEach((slices, group) => {
        const entries = slices.map((resource, binding) => ({ binding, resource }));
        const layout = pipeline.getBindGroupLayout(group);
        pass.setBindGroup(group, device.createBindGroup({ layout, entries }));
      });
      pass.dispatchWorkgroups(Math.ceil(points.length / 64));
      pass.end();
      device.queue.submit([encoder.finish()]);
      found.push(new Float32Array((await readBack(device, [values]))[0]!));
      for (const { buffer } of [at, values, records]) buffer.destroy();
    }
    return found;
  });

/** mm: float32 tells no places apart that are nearer */
const BLUR = 1e-4;
const POINTS = 60;

/** Of places all around one that float32 takes for it. */
function branchesAbout(near: Near, [x, y, z]: Point): ReadonlySet<number> {
  const around = [-BLUR, 0, BLUR];
  const all = around.flatMap((i) => around.flatMap((j) => around.map((k) => [x + i, y + j, z + k] as const)));
  return new Set(all.map((at) => near.branch(...at)));
}

/** The device's numbers of blends and morphs, which are of their first leaves, by the CPU's, which are of the sets. */
function blendsOf(node: FieldNode): ReadonlyMap<number, number> {
  const found = new Map<number, number>();
  const count = { leaves: 0, sets: 0 };
  const visit = (at: FieldNode): void => {
    if (at.type === 'affine') visit(at.node);
    else if (at.type === 'skels' || at.type === 'shape') count.leaves++;
    else {
      const set = ++count.sets;
      if (at.type === 'blend' || at.type === 'morph') found.set(branchOf(-set), branchOf(count.leaves));
      const parts = at.type === 'blend' ? [at.a, at.b] : at.type === 'morph' ? [at.from, at.to] : at.parts;
      for (const part of parts) visit(part);
    }
  };
  visit(node);
  return found;
}

const toDevice = (node: FieldNode) => {
  const blends = blendsOf(node);
  return (branch: number) => blends.get(branch) ?? branch;
};

describeGpu('branches', () => {
  it('are those of the CPU on surfaces, and so are their values anywhere (40 trees, seeds from 7300)', async () => {
    const all = Array.from({ length: 40 }, (_, i): Asked => {
      const lot = new Lot(7300 + i);
      const node = hardTree(lot);
      const near = bindField(node).near(new Tally());
      const { positions } = polygonize(bindField(node), 10).mesh;
      const vertex = () => {
        const v = 3 * Math.floor(lot.between(0, positions.length / 3));
        return [positions[v]!, positions[v + 1]!, positions[v + 2]!] as const;
      };
      const points = positions.length > 0 ? lot.many(POINTS, vertex) : [];
      return { node, points, wanted: points.map(() => near.branch(...vertex())) };
    }).filter(({ points }) => points.length > 0);
    const values = await onGpu(
      all.map((asked) => ({ ...asked, wanted: asked.wanted.map(toDevice(asked.node)) })),
    );
    const out = new Float64Array(4);
    let several = 0;
    all.forEach(({ node, points, wanted }, i) => {
      const near = bindField(node).near(new Tally());
      const branches = new Set<number>();
      points.forEach((p, k) => {
        const [, branch, , , value, ...gradient] = values[i]!.subarray(8 * k, 8 * k + 8);
        const about = `tree ${i}, point ${k}, branch ${wanted[k]}`;
        expect([...branchesAbout(near, p)].map(toDevice(node)), about).toContain(branch);
        branches.add(branch!);
        near.onBranch(wanted[k]!, ...p, out);
        const scale = 1 + Math.abs(out[0]!);
        expect(Math.abs(value! - out[0]!), about).toBeLessThan(2e-5 * scale);
        gradient.forEach((g, axis) => {
          expect(Math.abs(g - out[1 + axis]!), about).toBeLessThan(2e-3 * scale);
        });
      });
      if (branches.size > 2) several++;
    });
    expect(several).toBeGreaterThan(20);
  });
});
