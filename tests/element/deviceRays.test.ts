/** Exact mode on a device and with rays that the test answers for: what was refused is noticed, given back, and told once. */
import { beforeEach, describe, expect, it, vi } from 'vitest';
import type { CastListener, ShownBody } from '../../src/element/caster.ts';
import { DeviceRays } from '../../src/element/deviceRays.ts';
import type { FieldNode } from '../../src/field/node.ts';
import type { RayCamera } from '../../src/field/rayImage.ts';
import type { DeviceBody } from '../../src/gpu/raycast/body.ts';
import type { DeviceImage, GpuRaycaster, PlacedBody } from '../../src/gpu/raycast/raycaster.ts';
import { UNMOVED } from '../../src/math/placement.ts';
import { FakeDevice } from './fakeDevice.ts';

const VIEW = { pivot: [0, 0, 0], rotation: [0, 0, 0, 1], height: 20, fov: 0 } as const;
const camera = (width: number, height: number): RayCamera => ({
  view: VIEW,
  width,
  height,
  offset: [0.5, 0.5],
});
const shown = (node: FieldNode): ShownBody => ({ id: 'a', node, placement: UNMOVED, cells: 16 });
const sphere = (radius: number): FieldNode => ({ type: 'shape', shape: { type: 'sphere', radius } });

class FakeRaycaster implements GpuRaycaster {
  rooms = 0;
  lost = 0;
  /** what the device refuses, as it is asked for */
  refuses: (asked: 'image' | 'cast', bodies: readonly PlacedBody[], size: number) => boolean = () => false;
  readonly #device: FakeDevice;

  constructor(device: FakeDevice) {
    this.#device = device;
  }
  async body(node: FieldNode): Promise<DeviceBody> {
    return { node, bytes: 1, destroy: () => {} } as unknown as DeviceBody;
  }
  image(width: number, height: number): DeviceImage {
    this.#ask(this.refuses('image', [], width * height));
    this.rooms++;
    const destroy = () => void this.rooms--;
    const work = async () => ({ terms: 64, lost: this.lost });
    return { width, height, stride: width, work, destroy } as unknown as DeviceImage;
  }
  cast(image: DeviceImage, bodies: readonly PlacedBody[]): number {
    this.#ask(this.refuses('cast', bodies, image.width * image.height));
    return 1000;
  }
  destroy(): void {}
  #ask(refuses: boolean): void {
    this.#device.refuses = refuses ? 'no' : null;
    this.#device.asked();
    this.#device.refuses = null;
  }
}

let raycaster: FakeRaycaster;
let rays: DeviceRays;
let told: string[];

/** What came of it: all images, or why not. */
function cast(of: RayCamera, ...nodes: FieldNode[]): Promise<Parameters<CastListener['refused']> | 'whole'> {
  return new Promise((resolve) => {
    const images = rays.cast(nodes.map(shown), of, {
      changed: () => images.count === images.whole && resolve('whole'),
      refused: (...why) => resolve(why),
    });
  });
}

beforeEach(() => {
  const device = new FakeDevice();
  raycaster = new FakeRaycaster(device);
  told = [];
  rays = new DeviceRays(
    device.gpu,
    (why) => told.push(why),
    async () => raycaster,
  );
});

describe('DeviceRays', () => {
  it('memory that is refused ends the picture, and is told once', async () => {
    raycaster.refuses = (asked) => asked === 'image';
    for (let i = 0; i < 2; i++)
      expect(await cast(camera(40, 30), sphere(5))).toMatchObject([
        'the graphics device refused an image: no',
      ]);
    expect(told).toEqual(['the graphics device refused an image: no']);
    expect(raycaster.rooms).toBe(0);
  });

  it('so do rays, whatever was there before; and nothing is told of what ended', async () => {
    let left = 3;
    raycaster.refuses = (asked) => asked === 'cast' && left-- === 0;
    expect(await cast(camera(40, 30), sphere(5))).toMatchObject(['the graphics device refused rays: no']);
    expect(raycaster.rooms).toBe(0);
    rays.end();
    expect(told.length).toBe(1);
  });

  it('a picture with rays that were given up is never whole, in whatever image; the next one is cast all the same', async () => {
    for (const first of [0, 3]) {
      let number = 0;
      raycaster.refuses = (asked) => {
        if (asked === 'image') raycaster.lost = number++ >= first ? 2 : 0;
        return false;
      };
      expect(await cast(camera(40, 30), sphere(5))).toEqual(['2 rays were given up']);
      expect(raycaster.rooms).toBe(0);
    }
    expect(told).toEqual([]);
    raycaster.refuses = () => false;
    raycaster.lost = 0;
    expect(await cast(camera(40, 30), sphere(5))).toBe('whole');
  });

  it('images are there until they are dropped', async () => {
    expect(await cast(camera(40, 30), sphere(5))).toBe('whole');
    expect(raycaster.rooms).toBe(5);
    const images = rays.cast([shown(sphere(5))], camera(30, 30), { changed: () => {}, refused: () => {} });
    await vi.waitFor(() => expect(images.count).toBe(5));
    expect(raycaster.rooms).toBe(10);
    images.drop!();
    expect(raycaster.rooms).toBe(5);
  });
});
