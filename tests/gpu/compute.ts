/** One compute shader, once: bytes in, numbers out. */
import { openDevice } from '../../src/gpu/device.ts';
import { compile, link, type Modules } from '../../src/gpu/link.ts';
import { dawnGpu } from './dawn.ts';

/** The device for the time of `use`. */
export async function withDevice<T>(use: (device: GPUDevice) => Promise<T>): Promise<T> {
  const opened = await openDevice(dawnGpu());
  if ('reason' in opened) throw new Error(opened.reason);
  try {
    return await use(opened.device);
  } finally {
    opened.release();
  }
}

/** Runs `main` of the entry in one thread a number of `count`; binding 0 is read, binding 1 is array<f32>. */
export async function compute(
  device: GPUDevice,
  modules: Modules,
  input: ArrayBuffer,
  size: number,
  threads: number,
): Promise<Float32Array> {
  const module = await compile(device, 'test', link(modules, 'test'));
  const pipeline = await device.createComputePipelineAsync({ layout: 'auto', compute: { module } });
  const read = device.createBuffer({ size: input.byteLength, usage: 0x80 | 0x8 });
  device.queue.writeBuffer(read, 0, input);
  const written = device.createBuffer({ size: 4 * size, usage: 0x80 | 0x4 });
  const back = device.createBuffer({ size: 4 * size, usage: 0x1 | 0x8 });
  const encoder = device.createCommandEncoder();
  const pass = encoder.beginComputePass();
  pass.setPipeline(pipeline);
  const entries = [read, written].map((buffer, binding) => ({ binding, resource: { buffer } }));
  pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries }));
  pass.dispatchWorkgroups(Math.ceil(threads / 64));
  pass.end();
  encoder.copyBufferToBuffer(written, 0, back, 0, 4 * size);
  device.queue.submit([encoder.finish()]);
  await back.mapAsync(1);
  const numbers = new Float32Array(back.getMappedRange().slice(0));
  for (const buffer of [read, written, back]) buffer.destroy();
  return numbers;
}
