import { afterAll, describe, expect, it } from 'vitest';
import { openDevice } from '../../src/gpu/device.ts';
import { selfTest } from '../../src/gpu/selfTest.ts';
import { closeDawn, dawnGpu, describeGpu } from './dawn.ts';

afterAll(closeDawn);

async function opened() {
  const result = await openDevice(dawnGpu());
  if ('reason' in result) throw new Error(result.reason);
  return result;
}

describeGpu('the device', () => {
  it('opens, passes its self-test and tells what it is', async () => {
    const { device, description, release } = await opened();
    expect(device.label).toBe('rotund');
    expect(await selfTest(device)).toBeNull();
    expect(description.adapter).not.toBe('');
    expect(description.maxStorageBuffersPerStage).toBeGreaterThanOrEqual(8);
    expect(description.core).toBe(device.features.has('core-features-and-limits'));
    release();
  });

  it('is shared until the last user leaves', async () => {
    const first = await opened();
    const second = await opened();
    expect(second.device).toBe(first.device);
    first.release();
    first.release();
    expect(await selfTest(second.device)).toBeNull();
    second.release();
    expect((await second.device.lost).reason).toBe('destroyed');
    const third = await opened();
    expect(third.device).not.toBe(first.device);
    third.release();
  });
});

describe('without a usable device', () => {
  it('says so when the browser has no WebGPU', async () => {
    expect(await openDevice(undefined)).toEqual({ reason: 'this browser has no WebGPU' });
  });

  it('says so when there is no adapter, and asks again the next time', async () => {
    let asked = 0;
    const requestAdapter = async () => {
      asked++;
      return null;
    };
    const gpu = { requestAdapter } as unknown as GPU;
    expect(await openDevice(gpu)).toEqual({ reason: 'WebGPU found no graphics adapter' });
    expect('reason' in (await openDevice(gpu))).toBe(true);
    expect(asked).toBe(2);
  });

  it('does not throw when the driver does', async () => {
    const gpu = { requestAdapter: async () => Promise.reject(new Error('driver is gone')) } as unknown as GPU;
    expect(await openDevice(gpu)).toEqual({ reason: 'driver is gone' });
  });
});
