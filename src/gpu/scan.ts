/** Exclusive sums on the GPU (shaders/scan): of any number of items of four numbers each, in place; the total stays there too. */
import { compile, link } from './link.ts';
import { SHADERS } from './shaders.ts';

/** items of a group, as in shaders/scan/scan.wgsl */
const WIDTH = 1024;
/** bytes */
export const ITEM = 16;
const ENTRIES = ['scan_items', 'scan_totals', 'add_totals'] as const;

/** How many totals there are of so many items: one a group, and last that of all. */
export const totalsOf = (items: number): number => Math.ceil(items / WIDTH) + 1;

export interface Scan {
  /** `items` of at least one; `totals` is as long as totalsOf says. Both of that very size. */
  encode(pass: GPUComputePassEncoder, items: GPUBufferBinding, totals: GPUBufferBinding): void;
}

export async function loadScan(device: GPUDevice): Promise<Scan> {
  const module = await compile(device, 'scan', link(SHADERS, 'scan/scan'));
  const pipelines = await Promise.all(
    ENTRIES.map((entryPoint) =>
      device.createComputePipelineAsync({
        label: entryPoint,
        layout: 'auto',
        compute: { module, entryPoint },
      }),
    ),
  );
  return {
    encode(pass, items, totals) {
      const groups = totals.size! / ITEM - 1;
      pipelines.forEach((pipeline, i) => {
        const bound = ENTRIES[i] === 'scan_totals' ? [{ binding: 1, resource: totals }] : both(items, totals);
        pass.setPipeline(pipeline);
        pass.setBindGroup(
          0,
          device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries: bound }),
        );
        pass.dispatchWorkgroups(ENTRIES[i] === 'scan_totals' ? 1 : groups);
      });
    },
  };
}

const both = (items: GPUBufferBinding, totals: GPUBufferBinding) => [
  { binding: 0, resource: items },
  { binding: 1, resource: totals },
];
