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
  /** no body can be made of it */
  unmade: FieldNode | null = null;
  /** what the device refuses, as it is asked for */
  refuses: (asked: 'image' | 'cast', bodies: readonly PlacedBody[], size: number) => boolean = () => false;
  readonly #device: FakeDevice;

  constructor(device: FakeDevice) {
    this.#device = device;
  }
  async body(node: FieldNode): Promise<DeviceBody> {
    if (node === this.unmade) throw new RangeError('no bounds\n - While calling');
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
    const why = 'the graphics device refused an image: no';
    expect(await cast(camera(40, 30), sphere(5))).toEqual([why, []]);
    expect(await cast(camera(20, 30), sphere(5))).toEqual([why, []]);
    expect(told).toEqual(['the graphics device refused an image: no']);
    expect(raycaster.rooms).toBe(0);
  });

  it('so do rays, whatever was there before; and nothing is told of what ended', async () => {
    let left = 3;
    raycaster.refuses = (asked) => asked === 'cast' && left-- === 0;
    expect(await cast(camera(40, 30), sphere(5))).toEqual(['the graphics device refused rays: no', []]);
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
      expect(await cast(camera(40, 30), sphere(5))).toEqual(['2 rays were given up', []]);
      expect(raycaster.rooms).toBe(0);
    }
    expect(told).toEqual([]);
    raycaster.refuses = () => false;
    raycaster.lost = 0;
    expect(await cast(camera(40, 30), sphere(5))).toBe('whole');
  });

  it('the tree that no body can be made of is to blame, no other', async () => {
    const [good, bad] = [sphere(5), sphere(6)];
    raycaster.unmade = bad;
    expect(await cast(camera(40, 30), good, bad)).toEqual([expect.stringContaining('no bounds'), [bad]]);
    expect(told).toEqual(['no bounds']);
    expect(await cast(camera(40, 30), good)).toBe('whole');
  });

  it('so is the one whose rays alone are refused', async () => {
    const [good, bad] = [sphere(5), sphere(6)];
    const isBad = ({ body }: PlacedBody) => (body as unknown as { node: FieldNode }).node === bad;
    raycaster.refuses = (asked, bodies) => asked === 'cast' && bodies.some(isBad);
    expect(await cast(camera(40, 30), good, bad)).toEqual([expect.stringContaining('refused rays'), [bad]]);
    expect(raycaster.rooms).toBe(0);
    expect(await cast(camera(40, 30), good)).toBe('whole');
  });

  it('where nobody is it is the size of the picture, and larger ones are not tried', async () => {
    const node = sphere(5);
    raycaster.refuses = (_, bodies, size) => bodies.length === 0 && size >= 1200;
    const refused = [expect.stringContaining('refused an image'), []];
    expect(await cast(camera(40, 30), node)).toEqual(refused);
    const asked = vi.spyOn(raycaster, 'image');
    expect(await cast(camera(40, 40), node)).toEqual(['as many rays were refused before', []]);
    expect(asked).not.toHaveBeenCalled();
    expect(await cast(camera(30, 30), node)).toBe('whole');
  });

  it('what was too large is tried again once all have rested', async () => {
    raycaster.refuses = () => true;
    expect(await cast(camera(40, 30), sphere(5))).not.toBe('whole');
    raycaster.refuses = () => false;
    expect(await cast(camera(40, 40), sphere(5))).toEqual(['as many rays were refused before', []]);
    rays.idle();
    expect(await cast(camera(40, 40), sphere(5))).toBe('whole');
  });

  it.each([true, false])('room for it is made once, of pictures that can be cast again: %s', async (can) => {
    const first = rays.cast([shown(sphere(5))], camera(40, 30), { changed: () => {}, refused: () => {} });
    await vi.waitFor(() => expect(first.count).toBe(5));
    raycaster.refuses = (asked) => asked === 'image' && raycaster.rooms >= 7;
    let asked = 0;
    const spare = () => {
      if (asked++ > 0 || !can) return false;
      first.drop!();
      return true;
    };
    const came = await new Promise((resolve) => {
      const images = rays.cast([shown(sphere(5))], camera(30, 30), {
        changed: () => images.count === images.whole && resolve('whole'),
        spare,
        refused: resolve,
      });
    });
    expect(asked).toBe(1);
    expect(came).toEqual(can ? 'whole' : expect.stringContaining('refused an image'));
    expect(raycaster.rooms).toBe(5);
  });

  it('images are there until they are dropped', async () => {
    expect(await cast(camera(40, 30), sphere(5))).toBe('whole');
    expect(raycaster.rooms).toBe(5);
    const images = rays.cast([shown(sphere(5))], camera(30, 30), { changed: () => {}, refused: () => {} });
    await vi.waitFor(() => expect(images.count).toBe(5));
    expect(raycaster.rooms).toBe(10);
    images.drop!();
    expect(raycaster.rooms).toBe(5);
    expect([images.count, ...images.known]).toEqual([0, 0, 0]);
  });
});
