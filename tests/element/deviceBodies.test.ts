/** Bodies on a device whose making takes as long as the test likes: each is made once, and none is left behind. */
import { describe, expect, it, vi } from 'vitest';
import type { ShownBody } from '../../src/element/caster.ts';
import { DeviceBodies } from '../../src/element/deviceBodies.ts';
import type { FieldNode } from '../../src/field/node.ts';
import type { DeviceBody } from '../../src/gpu/raycast/body.ts';
import { UNMOVED } from '../../src/math/placement.ts';

const sphere = (radius: number): FieldNode => ({ type: 'shape', shape: { type: 'sphere', radius } });
const shown = (node: FieldNode): ShownBody => ({ id: 'a', node, placement: UNMOVED, cells: 16 });

class FakeRaycaster {
  readonly made: { isDestroyed: boolean }[] = [];
  readonly bytes: number;
  readonly #waiting: (() => void)[] = [];

  constructor(bytes = 1) {
    this.bytes = bytes;
  }

  body(): Promise<DeviceBody> {
    const body = { isDestroyed: false };
    const destroy = () => {
      expect(body.isDestroyed).toBe(false);
      body.isDestroyed = true;
    };
    return new Promise((resolve) => {
      this.#waiting.push(() => {
        this.made.push(body);
        resolve({ bytes: this.bytes, destroy } as unknown as DeviceBody);
      });
    });
  }

  /** Until so many are being made. */
  async begun(count: number): Promise<void> {
    await vi.waitFor(() => expect(this.#waiting.length).toBe(count));
  }

  finish(): void {
    for (const done of this.#waiting.splice(0)) done();
  }

  get left(): number {
    return this.made.filter(({ isDestroyed }) => !isDestroyed).length;
  }
}

const nothing = () => {};

describe('DeviceBodies', () => {
  it('two casts of one tree make it once', async () => {
    const device = new FakeRaycaster();
    const bodies = new DeviceBodies(device);
    const wish = [shown(sphere(3))];
    const casts = [bodies.ready(wish, () => false, nothing), bodies.ready(wish, () => true, nothing)];
    await device.begun(1);
    device.finish();
    const [first, second] = await Promise.all(casts);
    expect(first).toBeNull();
    expect(second).toHaveLength(1);
    expect(device.made).toHaveLength(1);
    await bodies.destroy();
    expect(device.left).toBe(0);
  });

  it('what is given up while it is made is kept for the next wish', async () => {
    const device = new FakeRaycaster();
    const bodies = new DeviceBodies(device);
    const wish = [shown(sphere(3))];
    let isWanted = true;
    const first = bodies.ready(wish, () => isWanted, nothing);
    await device.begun(1);
    isWanted = false;
    device.finish();
    expect(await first).toBeNull();
    expect(await bodies.ready(wish, () => true, nothing)).toHaveLength(1);
    expect(device.made).toHaveLength(1);
  });

  it('what arrives after the end is let go', async () => {
    const device = new FakeRaycaster();
    const bodies = new DeviceBodies(device);
    const cast = bodies.ready([shown(sphere(3))], () => true, nothing);
    await device.begun(1);
    const gone = bodies.destroy();
    device.finish();
    await gone;
    expect(await cast).toBeNull();
    expect(device.left).toBe(0);
  });

  it('bodies of the picture stay, whatever their size; others go where there is too much', async () => {
    const device = new FakeRaycaster(1 << 28);
    const bodies = new DeviceBodies(device);
    const ask = async (nodes: readonly FieldNode[]) => {
      const cast = bodies.ready(nodes.map(shown), () => true, nothing);
      for (let i = 0; i < nodes.length; i++) {
        await Promise.race([device.begun(1), cast]);
        device.finish();
      }
      return cast;
    };
    expect(await ask([sphere(1), sphere(2)])).toHaveLength(2);
    expect(device.left).toBe(2);
    expect(await ask([sphere(3)])).toHaveLength(1);
    expect(device.left).toBe(1);
  });
});
