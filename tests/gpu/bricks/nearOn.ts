/** Fields as they are in bricks that the device found: evaluated there, by their lists. */
import type { FieldNode } from '../../../src/field/node.ts';
import { compile, link } from '../../../src/gpu/link.ts';
import { Buffers, readBack, USAGE } from '../../../src/gpu/polygonize/buffers.ts';
import { modulesOf } from '../../../src/gpu/polygonize/stages.ts';
import { programOf } from '../../../src/gpu/program.ts';
import { EVERYTHING } from '../everything.ts';
import type { Culled } from './culled.ts';

/** x, y, z and the number of a brick; its value comes back. */
const ENTRY = `#import polygonize/near
@group(0) @binding(0) var<storage, read> points: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> values: array<f32>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
  if (id.x < arrayLength(&points)) {
    let at = points[id.x];
    values[id.x] = near_field(lists[u32(at.w)].y, at.xyz, false).x;
  }
}
`;

export type NearOn = (
  node: FieldNode,
  culled: Culled,
  points: Float32Array<ArrayBuffer>,
) => Promise<Float32Array>;

/** By one pipeline of everything. */
export async function nearOn(device: GPUDevice): Promise<NearOn> {
  const module = await compile(device, 'near', link({ ...modulesOf(EVERYTHING), test: ENTRY }, 'test'));
  const pipeline = await device.createComputePipelineAsync({ layout: 'auto', compute: { module } });
  return async (node, { lists }, points) => {
    const work = new Buffers(device);
    const count = points.length / 4;
    const values = work.get('values', 4 * count, USAGE.storage | USAGE.copySource);
    const groups = [
      [work.put('points', points, USAGE.storage), values],
      [
        work.put('records', programOf(node).records, USAGE.storage),
        work.put('lists', lists as Uint32Array<ArrayBuffer>, USAGE.storage),
      ],
    ];
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    groups.forEach((slices, group) => {
      const entries = slices.map((resource, binding) => ({ binding, resource }));
      const layout = pipeline.getBindGroupLayout(group);
      pass.setBindGroup(group, device.createBindGroup({ layout, entries }));
    });
    pass.dispatchWorkgroups(Math.ceil(count / 64));
    pass.end();
    device.queue.submit([encoder.finish()]);
    const [bytes] = await readBack(device, [values]);
    work.destroy();
    return new Float32Array(bytes!);
  };
}
