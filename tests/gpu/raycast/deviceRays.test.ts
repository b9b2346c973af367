/** Exact mode's images on the device: those of the CPU, in whatever order they are asked for, given up and begun anew. */
import { afterAll, beforeAll, expect, it, vi } from 'vitest';
import type { CastImages, ShownBody } from '../../../src/element/caster.ts';
import { DeviceRays } from '../../../src/element/deviceRays.ts';
import { bindField } from '../../../src/field/bind.ts';
import type { FieldNode } from '../../../src/field/node.ts';
import { locating } from '../../../src/field/polygonize.ts';
import { OFFSETS } from '../../../src/field/rayEdges.ts';
import { NOWHERE, type RayCamera } from '../../../src/field/rayImage.ts';
import { emptyImage, SceneCaster } from '../../../src/field/rayScene.ts';
import { type OpenedDevice, openDevice } from '../../../src/gpu/device.ts';
import { readBack } from '../../../src/gpu/polygonize/buffers.ts';
import { UNMOVED } from '../../../src/math/placement.ts';
import type { SurfaceImage } from '../../../src/scene/index.ts';
import { finished } from '../../field/finished.ts';
import { body, placed, sphere } from '../../field/trees.ts';
import { closeDawn, dawnGpu, describeGpu } from '../dawn.ts';

const BODIES: readonly ShownBody[] = [
  {
    id: 'ball',
    node: placed(sphere(6), -4, 0, 0),
    placement: { rotation: [0, 0, 0, 1], translation: [2, 0, 4] },
    cells: 24,
  },
  {
    id: 'point',
    node: body([{ skel: { type: 'point', at: [5, 0, 0], weight: 6 }, colour: [1, 0, 0] }]),
    placement: { rotation: [0, 0.6, 0, 0.8], translation: [0, 1, 0] },
    cells: 24,
  },
];
const camera = (width: number, height: number): RayCamera => ({
  view: { pivot: [0, 0, 0], rotation: [0.1, 0.2, 0, 0.9746794], height: 26, fov: 30 },
  width,
  height,
  offset: [0.5, 0.5],
});

function byCpu(of: RayCamera) {
  const located = ({ node, cells }: ShownBody) => finished(locating(bindField(node), cells));
  const rays = new SceneCaster(
    BODIES.map((shown) => ({ located: located(shown), placement: shown.placement })),
    of,
  );
  const image = emptyImage(of);
  for (let row = 0; row < of.height; row++) rays.row(image, row);
  return image;
}

/** Pixels in which the image is not the CPU's of that camera: surface on one side only, or another place, normal or body. */
async function off(device: GPUDevice, { camera: of, surface, colours, stride = 0 }: SurfaceImage) {
  const size = 16 * stride * of.height;
  const slice = (buffer: Float32Array | GPUBuffer) => ({ buffer: buffer as GPUBuffer, size });
  const [at, painted] = (await readBack(device, [slice(surface), slice(colours)])).map(
    (bytes) => new Float32Array(bytes),
  );
  const cpu = byCpu(of);
  let wrong = 0;
  let hits = 0;
  for (let y = 0; y < of.height; y++)
    for (let x = 0; x < of.width; x++) {
      const [a, b] = [4 * (y * stride + x), 4 * (y * of.width + x)];
      const isHit = cpu.surface[b + 3] !== NOWHERE;
      if (isHit) hits++;
      const far = [0, 1, 2, 3].some((k) => !(Math.abs(at![a + k]! - cpu.surface[b + k]!) < 2e-3));
      const other = (isHit ? [0, 1, 2, 3] : [3]).some(
        (k) => !(Math.abs(painted![a + k]! - cpu.colours[b + k]!) < 2e-3),
      );
      if (far || other) wrong++;
    }
  expect(hits).toBeGreaterThan(100);
  return wrong;
}

/** Until all images are there. */
function whole(rays: DeviceRays, of: RayCamera, bodies = BODIES): Promise<CastImages> {
  return new Promise((resolve, reject) => {
    const images = rays.cast(bodies, of, {
      changed: () => images.count === images.whole && resolve(images),
      refused: (why) => reject(new Error(why)),
    });
  });
}

describeGpu('rays on the device for exact mode', () => {
  // one for all: pipelines take longer than rays
  let opened: OpenedDevice;
  let rays: DeviceRays;
  beforeAll(async () => {
    const result = await openDevice(dawnGpu());
    if ('reason' in result) throw new Error(result.reason);
    opened = result;
    rays = new DeviceRays(opened.device);
  });
  afterAll(() => {
    opened.release();
    closeDawn();
  });

  it('images are the CPU’s in any order, and cast once, also when another picture came in between', async () => {
    expect(rays.live(BODIES, camera(8, 8).view, camera(8, 8), Infinity)).toBeNull();
    const first = await whole(rays, camera(45, 34));
    const second = await whole(rays, camera(30, 30));
    expect(first.evaluationsAPixel).toBeGreaterThan(0.5);
    const submitted = vi.spyOn(opened.device.queue, 'submit');
    const made = vi.spyOn(opened.device, 'createBuffer');
    for (const [images, number] of [
      [second, 4],
      [first, 0],
      [first, 3],
      [second, 0],
      [first, 3],
    ] as const) {
      const image = images.image(number);
      expect(submitted).not.toHaveBeenCalled();
      expect(made).not.toHaveBeenCalled();
      expect(image.items).toEqual(['ball', 'point']);
      expect(image.camera.offset).toEqual([[0.5, 0.5], ...OFFSETS][number]);
      // a ray that only just touches is either
      expect(await off(opened.device, image)).toBeLessThanOrEqual(4);
      submitted.mockClear();
      made.mockClear();
    }
    vi.restoreAllMocks();
    // of pipelines, which a busy machine takes long for
  }, 240_000);

  it('a moving view is cast at once, as finely as there is time for; not what was never seen', async () => {
    const of = camera(64, 48);
    await whole(rays, of);
    // room comes beside the frames
    const fine = await vi.waitFor(() => {
      const image = rays.live(BODIES, of.view, of, Infinity);
      expect(image).not.toBeNull();
      return image!;
    });
    expect(fine.camera).toMatchObject({ width: 64, height: 48 });
    expect(await off(opened.device, fine)).toBeLessThanOrEqual(4);
    expect(rays.live(BODIES, of.view, of, 0)).toBeNull();
    const other = { ...BODIES[0]!, node: placed(sphere(6), -4, 0, 1) };
    expect(rays.live([other], of.view, of, Infinity)).toBeNull();
  });

  it('rays along a wall see all of it; of those that the device gives up there is no picture', async () => {
    const side = 10;
    const wall: FieldNode = { type: 'shape', shape: { type: 'box', half: [side, side, side] } };
    const shown = (id: string, node: FieldNode): ShownBody => ({ id, node, placement: UNMOVED, cells: 24 });
    const box = shown('box', wall);
    // a column of pixels, and a row, look along it
    const along = (pixel: number): RayCamera => ({
      view: { pivot: [side, 0, 0], rotation: [0, 0, 0, 1], height: 9 * pixel, fov: 0 },
      ...{ width: 33, height: 9, offset: [0.5, 0.5] },
    });
    expect((await whole(rays, along(0.01), [box])).count).toBe(5);
    // through a tunnel, inside of what was cut out: there it is not known
    const tunnel: FieldNode = { type: 'shape', shape: { type: 'box', half: [side, side, 6 * side] } };
    const hole: FieldNode = { type: 'subtraction', form: 'hard', parts: [sphere(4 * side), tunnel] };
    const why = await new Promise((resolve) => {
      const images = rays.cast([shown('hole', hole)], along(0.01), {
        changed: () => images.count > 0 && resolve('there'),
        refused: resolve,
      });
    });
    expect(why).toMatch(/^\d+ rays were given up$/);
    // as if nothing had been
    expect((await whole(rays, camera(30, 30), [box])).count).toBe(5);
  });

  it('what is given up tells nothing more, and what waits at the end is refused', async () => {
    const told: string[] = [];
    const listen = (name: string) => ({
      changed: () => void told.push(name),
      refused: (why: string) => void told.push(`${name} ${why}`),
    });
    rays.cast(BODIES, camera(40, 30), listen('first'));
    const images = await whole(rays, camera(32, 24));
    expect(await off(opened.device, images.image(0))).toBeLessThanOrEqual(4);
    expect(told.filter((name) => name !== 'first')).toEqual([]);
    const before = told.length;
    rays.cast(BODIES, camera(40, 30), listen('last'));
    rays.end();
    await opened.device.queue.onSubmittedWorkDone();
    expect(told.slice(before)).toEqual(['last given up']);
  });
});
