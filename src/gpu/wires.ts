/** Triangles on the device → their edges as lines there, as many as the device says, without its being asked. */
import source from '../../shaders/lib/wires.wgsl?raw';
import { USAGE } from './usage.ts';

const WORKGROUP = 64;
/** workgroups that every device takes in a row */
const ROW = 65_535;
const TRIANGLE = 3 * Uint32Array.BYTES_PER_ELEMENT;
const DRAW = 5 * Uint32Array.BYTES_PER_ELEMENT;

const pipelines = new WeakMap<GPUDevice, GPUComputePipeline>();

function pipelineOf(device: GPUDevice): GPUComputePipeline {
  let pipeline = pipelines.get(device);
  if (!pipeline) {
    const module = device.createShaderModule({ label: 'lib/wires.wgsl', code: source });
    pipeline = device.createComputePipeline({ label: 'wires', layout: 'auto', compute: { module } });
    pipelines.set(device, pipeline);
  }
  return pipeline;
}

export class Wires {
  /** u32, two a line */
  readonly indices: GPUBuffer;
  /** five u32, for drawIndexedIndirect */
  readonly draw: GPUBuffer;
  readonly #device: GPUDevice;
  readonly #bindings: GPUBindGroup;
  readonly #groups: number;

  /** Of what `draw`, five u32, draws of `indices`; both with the usage STORAGE. */
  constructor(device: GPUDevice, indices: GPUBuffer, draw: GPUBuffer) {
    const made = (label: string, size: number, usage: number) =>
      device.createBuffer({ label, size, usage: usage | USAGE.storage | USAGE.copySource });
    this.#device = device;
    this.indices = made('wires', Math.max(2 * indices.size, 2 * TRIANGLE), USAGE.index);
    this.draw = made('wires, draw', DRAW, USAGE.indirect);
    const buffers = [indices, draw, this.indices, this.draw];
    this.#bindings = device.createBindGroup({
      label: 'wires',
      layout: pipelineOf(device).getBindGroupLayout(0),
      entries: buffers.map((buffer, binding) => ({ binding, resource: { buffer } })),
    });
    this.#groups = Math.max(1, Math.ceil(indices.size / TRIANGLE / WORKGROUP));
  }

  /** Makes the lines of the triangles that are there now. */
  update(): void {
    const encoder = this.#device.createCommandEncoder({ label: 'wires' });
    const pass = encoder.beginComputePass({ label: 'wires' });
    pass.setPipeline(pipelineOf(this.#device));
    pass.setBindGroup(0, this.#bindings);
    const rows = Math.ceil(this.#groups / ROW);
    pass.dispatchWorkgroups(Math.ceil(this.#groups / rows), rows);
    pass.end();
    this.#device.queue.submit([encoder.finish()]);
  }

  destroy(): void {
    this.indices.destroy();
    this.draw.destroy();
  }
}
