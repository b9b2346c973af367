/** Who casts rays: the device where it can, workers elsewhere and where it fails. */
import { beforeEach, describe, expect, it } from 'vitest';
import type { Caster, CastImages, CastListener, ShownBody } from '../../src/element/caster.ts';
import { Rays } from '../../src/element/rays.ts';
import type { FieldNode } from '../../src/field/node.ts';
import type { RayCamera } from '../../src/field/rayImage.ts';
import { UNMOVED } from '../../src/math/placement.ts';
import type { Scene, SurfaceImage } from '../../src/scene/index.ts';

const VIEW = { pivot: [0, 0, 0], rotation: [0, 0, 0, 1], height: 20, fov: 0 } as const;
const CAMERA: RayCamera = { view: VIEW, width: 8, height: 6, offset: [0.5, 0.5] };
const shown = (node: FieldNode): ShownBody => ({ id: 'a', node, placement: UNMOVED, cells: 16 });
const sphere = (): FieldNode => ({ type: 'shape', shape: { type: 'sphere', radius: 5 } });
/** a plate of a singular kernel */
const hard: FieldNode = {
  type: 'skels',
  kernel: 'inverseCubic',
  params: {},
  threshold: 1,
  skels: [
    {
      skel: {
        type: 'polygon',
        origin: [0, 0, 0],
        u: [1, 0, 0],
        v: [0, 1, 0],
        loops: [
          [
            [0, 0],
            [4, 0],
            [0, 4],
          ],
        ],
        weight: 2,
      },
    },
  ],
};

class Fake implements Caster {
  readonly casts: CastListener[] = [];
  stopped = 0;
  ended = 0;
  wished: number | null = null;
  readonly images = { count: 0, whole: 5, known: 0, share: 0, image: () => ({}) } as unknown as CastImages;
  cast(_bodies: readonly ShownBody[], _camera: RayCamera, listener: CastListener): CastImages {
    this.casts.push(listener);
    return this.images;
  }
  live(_bodies: readonly ShownBody[], _view: unknown, _pixels: unknown, milliseconds: number): SurfaceImage {
    this.wished = milliseconds;
    return {} as SurfaceImage;
  }
  stop(): void {
    this.stopped++;
  }
  end(): void {
    this.ended++;
    this.casts.at(-1)?.refused('given up');
  }
}

let workers: Fake;
let devices: Fake[];
let rays: Rays;
const scene = (device: GPUDevice | null, software = false) =>
  ({ device, description: device && { software } }) as unknown as Scene;
const device = {} as GPUDevice;
const told: string[] = [];
const listener: CastListener = { changed: () => told.push('changed'), refused: (why) => told.push(why) };
const cast = (...nodes: FieldNode[]) => rays.cast(nodes.map(shown), CAMERA, listener);

beforeEach(() => {
  told.length = 0;
  workers = new Fake();
  devices = [];
  rays = new Rays(workers, () => devices[devices.push(new Fake()) - 1]!);
});

describe('Rays', () => {
  it('are the workers’ where there is no device, or one in software, but for who asks', () => {
    cast(sphere());
    rays.use(scene(null));
    cast(sphere());
    rays.use(scene(device, true));
    cast(sphere());
    expect(workers.casts.length).toBe(3);
    expect(rays.live([shown(sphere())], VIEW, CAMERA, 12)).toBeNull();
    rays.choice = 'device';
    cast(sphere());
    expect(devices[0]!.casts.length).toBe(1);
    rays.live([shown(sphere())], VIEW, CAMERA, 12);
    expect(devices[0]!.wished).toBe(Infinity);
  });

  it('are the device’s where all bodies are such as it knows bounds for', () => {
    rays.use(scene(device));
    cast(sphere(), sphere());
    expect(devices[0]!.casts.length).toBe(1);
    rays.live([shown(sphere())], VIEW, CAMERA, 12);
    expect(devices[0]!.wished).toBe(12);
    cast(sphere(), hard);
    // what has no field is told by workers
    cast({ type: 'skels', kernel: 'none', params: {}, threshold: 1, skels: [] } as unknown as FieldNode);
    expect(workers.casts.length).toBe(2);
    rays.choice = 'worker';
    cast(sphere());
    expect(workers.casts.length).toBe(3);
    expect(devices[0]!.casts.length).toBe(1);
  });

  it('go over to workers where the device refuses, and stay there', () => {
    rays.use(scene(device));
    const [node, other] = [sphere(), sphere()];
    const images = cast(other, node);
    devices[0]!.casts[0]!.refused('no room', [node]);
    expect(told).toEqual([]);
    expect(workers.casts.length).toBe(1);
    Object.assign(workers.images, { count: 3 });
    expect(images.count).toBe(3);
    workers.casts[0]!.refused('none either');
    expect(told).toEqual(['none either']);
    cast(node);
    expect(workers.casts.length).toBe(2);
    // only what was refused
    cast(other);
    expect(devices[0]!.casts.length).toBe(2);
    // of nobody in particular: of this picture alone
    devices[0]!.casts[1]!.refused('2 rays were given up');
    expect(workers.casts.length).toBe(3);
    cast(other);
    expect(devices[0]!.casts.length).toBe(3);
  });

  it('end with the device, whose successor is asked next; nothing begins anew', () => {
    rays.use(scene(device));
    cast(sphere());
    rays.end();
    expect(devices[0]!.ended).toBe(1);
    expect(told).toEqual(['given up']);
    expect(workers.casts.length).toBe(0);
    rays.use(scene(device));
    cast(sphere());
    expect(devices[1]!.casts.length).toBe(1);
    rays.stop();
    expect([devices[1]!.stopped, workers.stopped]).toEqual([1, 1]);
  });
});
