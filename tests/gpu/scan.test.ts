/** Sums on the GPU against sums in a loop, of sizes about the width of a group and its square. */
import { afterAll, expect, it } from 'vitest';
import { readBack } from '../../src/gpu/polygonize/buffers.ts';
import { ITEM, loadScan, totalsOf } from '../../src/gpu/scan.ts';
import { random } from '../fixtures/random.ts';
import { withDevice } from './compute.ts';
import { closeDawn, describeGpu } from './dawn.ts';

afterAll(closeDawn);

const SIZES = [0, 1, 255, 256, 257, 1023, 1024, 1025, 65_536, 65_537, 1_000_000];

describeGpu('scan', () => {
  it.each(SIZES)('is exclusive sums of %i items, and the total (seed 51)', async (size) => {
    const next = random(51 + size);
    // WebGPU binds no empty buffer: one zero
    const count = Math.max(1, size);
    const items = Uint32Array.from({ length: 4 * count }, () => (size === 0 ? 0 : Math.floor(1000 * next())));
    const { scanned, totals } = await scanOf(items);
    const sums = [0, 0, 0, 0];
    // one comparison in place of millions of expectations
    let wrong = 0;
    items.forEach((item, i) => {
      if (scanned[i] !== sums[i % 4]) wrong++;
      sums[i % 4]! += item;
    });
    expect(wrong).toBe(0);
    expect([...totals.slice(-4)]).toEqual(sums);
  });
});

const scanOf = (items: Uint32Array<ArrayBuffer>) =>
  withDevice(async (device) => {
    const scan = await loadScan(device);
    const made = (size: number) => ({ buffer: device.createBuffer({ size, usage: 0x80 | 0x4 | 0x8 }), size });
    const buffers = [made(items.byteLength), made(ITEM * totalsOf(items.length / 4))] as const;
    device.queue.writeBuffer(buffers[0].buffer, 0, items);
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    scan.encode(pass, ...buffers);
    pass.end();
    device.queue.submit([encoder.finish()]);
    const [scanned, totals] = await readBack(device, buffers);
    for (const { buffer } of buffers) buffer.destroy();
    return { scanned: new Uint32Array(scanned!), totals: new Uint32Array(totals!) };
  });
