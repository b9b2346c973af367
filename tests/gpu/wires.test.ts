/** Lines of triangles, made on the device, against the edges counted here. */
import { afterAll, expect, test } from 'vitest';
import { Wires } from '../../src/gpu/wires.ts';
import { random } from '../fixtures/random.ts';
import { withDevice } from './compute.ts';
import { closeDawn, describeGpu } from './dawn.ts';

afterAll(closeDawn);

async function read(device: GPUDevice, buffer: GPUBuffer): Promise<Uint32Array> {
  const back = device.createBuffer({ size: buffer.size, usage: 0x1 | 0x8 });
  const encoder = device.createCommandEncoder();
  encoder.copyBufferToBuffer(buffer, 0, back, 0, buffer.size);
  device.queue.submit([encoder.finish()]);
  await back.mapAsync(1);
  const numbers = new Uint32Array(back.getMappedRange().slice(0));
  back.destroy();
  return numbers;
}

describeGpu('wires', () => {
  test.each([0, 1, 63, 64, 65, 1000])('%d triangles, in buffers with room for more', async (triangles) => {
    await withDevice(async (device) => {
      const next = random(triangles);
      const first = 3;
      const count = 3 * triangles;
      const all = Uint32Array.from({ length: first + count + 300 }, () => Math.floor(1e6 * next()));
      const indices = device.createBuffer({ size: all.byteLength, usage: 0x80 | 0x8 });
      const draw = device.createBuffer({ size: 20, usage: 0x80 | 0x8 });
      device.queue.writeBuffer(indices, 0, all);
      device.queue.writeBuffer(draw, 0, new Uint32Array([count, 1, first, 0, 0]));
      const wires = new Wires(device, indices, draw);
      wires.update();
      const lines = await read(device, wires.indices);
      const expected: number[] = [];
      for (let i = first; i < first + count; i += 3) {
        const [a, b, c] = [all[i]!, all[i + 1]!, all[i + 2]!];
        expected.push(a, b, b, c, c, a);
      }
      expect([...(await read(device, wires.draw))]).toEqual([2 * count, 1, 0, 0, 0]);
      expect([...lines.subarray(0, 2 * count)]).toEqual(expected);
      expect(lines.subarray(2 * count).every((index) => index === 0)).toBe(true);
      wires.destroy();
    });
  });
});
