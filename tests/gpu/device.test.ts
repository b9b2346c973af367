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

/** Dawn, with something done to every device it gives. */
function meddled(meddle: (device: GPUDevice, count: number) => void): GPU {
  let count = 0;
  const requestAdapter = async () => {
    const adapter = await dawnGpu().requestAdapter();
    if (!adapter) return null;
    const requestDevice = async (descriptor: GPUDeviceDescriptor) => {
      const device = await adapter.requestDevice(descriptor);
      meddle(device, ++count);
      return device;
    };
    const { features, limits, info } = adapter;
    return { features, limits, info, requestDevice } as unknown as GPUAdapter;
  };
  return { requestAdapter } as unknown as GPU;
}

/** Shadows a method of one device. */
function shadow<K extends 'createShaderModule' | 'createBuffer' | 'createTexture'>(
  device: GPUDevice,
  name: K,
  instead: (made: GPUDevice[K]) => GPUDevice[K],
): void {
  Object.defineProperty(device, name, { value: instead(device[name].bind(device) as GPUDevice[K]) });
}

describeGpu('error scopes', () => {
  const popping = async (text: string) => {
    const gpu = meddled((device) => {
      const pop = device.popErrorScope.bind(device);
      let asked = 0;
      // the first is the self-test's
      device.popErrorScope = () =>
        asked++ ? Promise.reject(new DOMException(text, 'OperationError')) : pop();
    });
    const made = await openDevice(gpu);
    if ('reason' in made) throw new Error(made.reason);
    return made;
  };

  it('of a device whose process died hold no error', async () => {
    const { device, release } = await popping('Instance dropped in popErrorScope');
    expect(await device.popErrorScope()).toBeNull();
    release();
  });

  it('that were never opened are still a mistake', async () => {
    const { device, release } = await popping('No error scopes to pop');
    await expect(device.popErrorScope()).rejects.toThrow('No error scopes');
    release();
  });
});

describeGpu('a device that cannot be trusted', () => {
  it('is refused when it computes nonsense, with the nonsense as reason, and given back', async () => {
    const devices: GPUDevice[] = [];
    const gpu = meddled((device) => {
      devices.push(device);
      shadow(device, 'createShaderModule', (make) => (descriptor) => {
        const code = descriptor.code.replace('+ 0.5', '+ 0.25');
        expect(code).not.toBe(descriptor.code);
        return make({ ...descriptor, code });
      });
    });
    const result = await openDevice(gpu);
    expect('reason' in result && result.reason).toMatch(
      /^self-test failed: computed 3969.25 in place of 3969.5/,
    );
    expect(devices).toHaveLength(1);
    expect((await devices[0]!.lost).reason).toBe('destroyed');
  });

  it('is refused when a shader does not compile', async () => {
    const gpu = meddled((device) =>
      shadow(
        device,
        'createShaderModule',
        (make) => (descriptor) => make({ ...descriptor, code: 'nonsense' }),
      ),
    );
    const result = await openDevice(gpu);
    expect('reason' in result && result.reason).toMatch(/^self-test failed: /);
  });

  it('leaves nothing of its self-test behind', async () => {
    const alive = new Set<object>();
    const counted =
      <D, R extends { destroy(): undefined }>(make: (descriptor: D) => R) =>
      (descriptor: D): R => {
        const made = make(descriptor);
        const destroy = made.destroy.bind(made);
        alive.add(made);
        Object.defineProperty(made, 'destroy', {
          value: () => {
            alive.delete(made);
            destroy();
          },
        });
        return made;
      };
    let most = 0;
    const gpu = meddled((device) => {
      shadow(device, 'createBuffer', counted);
      shadow(device, 'createTexture', counted);
      shadow(device, 'createShaderModule', (make) => (descriptor) => {
        queueMicrotask(() => {
          most = alive.size;
        });
        return make(descriptor);
      });
    });
    const result = await openDevice(gpu);
    expect('reason' in result).toBe(false);
    expect(most).toBe(4);
    expect(alive.size).toBe(0);
    if ('release' in result) result.release();
  });

  it('gets another try when it is lost in its self-test, and not a fourth one', async () => {
    let made = 0;
    const losing = (times: number) =>
      meddled((device, count) => {
        made = count;
        if (count <= times) device.destroy();
      });
    const second = await openDevice(losing(1));
    expect(made).toBe(2);
    if ('release' in second) second.release();
    else expect(second).toBe('a device');
    const never = await openDevice(losing(9));
    expect('reason' in never && never.reason).toMatch(/^device lost 3 times/);
    expect(made).toBe(3);
  });

  it('tells every user of its loss, but none that has left', async () => {
    let device: GPUDevice | undefined;
    const gpu = meddled((made) => {
      device = made;
    });
    const [one, other] = [await openDevice(gpu), await openDevice(gpu)];
    if ('reason' in one || 'reason' in other) throw new Error('no device');
    let told = false;
    void one.lost.then(() => {
      told = true;
    });
    one.release();
    device?.destroy();
    expect(await other.lost).not.toBe('');
    await new Promise((done) => setTimeout(done));
    expect(told).toBe(false);
    const next = await openDevice(gpu);
    expect('device' in next && next.device !== one.device).toBe(true);
    other.release();
    if ('release' in next) next.release();
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

  it('does not wait for ever for a driver that never answers', async () => {
    const gpu = { requestAdapter: () => new Promise(() => {}) } as unknown as GPU;
    expect(await openDevice(gpu, 50)).toEqual({ reason: 'the graphics device did not answer within 0.05 s' });
  });
});
