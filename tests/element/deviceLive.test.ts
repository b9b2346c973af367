/** What moves, on a device that the test answers for: no frame is drawn from what the device refused, and why is told once. */
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { DeviceLive, type Moving } from '../../src/element/deviceLive.ts';
import { Pace } from '../../src/element/pace.ts';
import type { DeviceBody } from '../../src/gpu/raycast/body.ts';
import type { DeviceImage } from '../../src/gpu/raycast/raycaster.ts';
import { UNMOVED } from '../../src/math/placement.ts';
import { FakeDevice } from './fakeDevice.ts';

const VIEW = { pivot: [0, 0, 0], rotation: [0, 0, 0, 1], height: 20, fov: 0 } as const;
const BODY = {} as DeviceBody;
const moving = (width: number, height: number, body = BODY): Moving => ({
  bodies: [{ body, placement: UNMOVED }],
  items: ['a'],
  view: VIEW,
  pixels: { width, height },
});

let device: FakeDevice;
let rooms: number;
let casts: number;
let lost: number;
let told: string[];
let live: DeviceLive;
const raycaster = {
  image(width: number, height: number): DeviceImage {
    device.asked();
    rooms++;
    const destroy = () => void rooms--;
    const work = async () => ({ terms: 1, lost });
    return {
      width,
      height,
      stride: width,
      surface: {},
      colours: {},
      work,
      destroy,
    } as unknown as DeviceImage;
  },
  cast(): number {
    device.asked();
    casts++;
    return 100;
  },
};
const image = (width = 40, height = 30) => live.image(raycaster, moving(width, height), 12);

beforeEach(() => {
  device = new FakeDevice();
  rooms = 0;
  casts = 0;
  lost = 0;
  told = [];
  const pace = new Pace();
  pace.hear(1e6, 1);
  live = new DeviceLive(device.gpu, pace, (why) => told.push(why));
});

describe('DeviceLive', () => {
  it('has no image before there is room for it, then one in each frame, of each size', async () => {
    expect(image()).toBeNull();
    expect(image()).toBeNull();
    await vi.waitFor(() =>
      expect(image()).toMatchObject({ camera: { width: 40, height: 30 }, items: ['a'] }),
    );
    expect(image(20, 10)).toBeNull();
    await vi.waitFor(() => expect(image(20, 10)).not.toBeNull());
    expect(image()).not.toBeNull();
    for (let width = 50; width < 60; width++) {
      expect(image(width)).toBeNull();
      await vi.waitFor(() => expect(image(width)).not.toBeNull());
    }
    expect(rooms).toBeLessThanOrEqual(3);
    live.idle();
    expect(rooms).toBe(0);
    expect(told).toEqual([]);
  });

  it('room that the device refuses is never drawn from', async () => {
    device.refuses = 'no memory';
    expect(image()).toBeNull();
    await vi.waitFor(() => expect(told).toEqual(['the graphics device refused an image: no memory']));
    device.refuses = null;
    for (let i = 0; i < 3; i++) {
      expect(image()).toBeNull();
      await Promise.resolve();
    }
    expect([rooms, casts, told.length]).toEqual([0, 0, 1]);
    // there may be room once all have rested
    live.idle();
    await vi.waitFor(() => expect(image()).not.toBeNull());
  });

  it('rays that the device refuses are the last ones', async () => {
    image();
    await vi.waitFor(() => expect(image()).not.toBeNull());
    device.refuses = 'no';
    image();
    await vi.waitFor(() => expect(told.length).toBe(1));
    expect(image()).toBeNull();
    expect(rooms).toBe(0);
  });

  it('bodies with rays that were given up are seen no more, others are', async () => {
    image();
    await vi.waitFor(() => expect(image()).not.toBeNull());
    lost = 1;
    await vi.waitFor(() => expect(image()).toBeNull());
    expect(live.image(raycaster, moving(40, 30, {} as DeviceBody), 12)).not.toBeNull();
    expect(told).toEqual([]);
  });

  it('room that arrives when nobody moves any more goes', async () => {
    expect(image()).toBeNull();
    live.idle();
    await vi.waitFor(() => expect(rooms).toBe(0));
    expect(told).toEqual([]);
  });
});
