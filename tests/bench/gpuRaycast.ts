/**
 * Rays onto fields on the device: pictures of 512² pixels of the trees, as exact mode casts them (`ROTUND_PIXELS=128`, `ROTUND_SCENES=tree178`).
 * On a graphics card one command yields what is wished there: `ROTUND_TABLES=rays ROTUND_SCENES=tree178 node dist/bench/gpu.time.js`.
 */
import { bindField } from '../../src/field/bind.ts';
import { latticed } from '../../src/field/polygonize.ts';
import type { RayCamera } from '../../src/field/rayImage.ts';
import { type DeviceImage, gpuRaycaster, type PlacedBody } from '../../src/gpu/raycast/raycaster.ts';
import { UNMOVED } from '../../src/math/placement.ts';
import { TEST, WITH_GRADIENT } from '../../src/skeleton/work.ts';
import { finished } from '../field/finished.ts';
import { type SceneName, sceneNode } from './scenes/index.ts';
import { rounded } from './timing.ts';

const PIXELS = Number(process.env.ROTUND_PIXELS ?? 512);
const SCENES = (process.env.ROTUND_SCENES?.split(',') ?? [
  'tree16',
  'tree64',
  'tree178',
  'tree1024',
]) as SceneName[];
/** those of the CPU's bench */
const CELLS: Partial<Record<SceneName, number>> = { tree1024: 320 };
const HEIGHT: Partial<Record<SceneName, number>> = { tree1024: 5.5 };
/** pictures in one measurement, as many as there is time for: waiting for the device takes some ms by itself */
const ROUNDS = 16;
const LONG = 2000;

const cameraOf = (name: SceneName): RayCamera => ({
  view: { pivot: [0, 0, 0], rotation: [0.1, 0.2, 0, 0.9746794], height: HEIGHT[name] ?? 2.2, fov: 30 },
  width: PIXELS,
  height: PIXELS,
  offset: [0.5, 0.5],
});

export async function timeRays(device: GPUDevice): Promise<void> {
  const rows = [];
  for (const name of SCENES) rows.push(await timesOf(device, name));
  console.log(`Rays by the device, ${PIXELS}² pixels, ms`);
  console.table(rows);
}

async function timesOf(device: GPUDevice, name: SceneName) {
  const raycaster = await gpuRaycaster(device);
  const node = sceneNode(name);
  const camera = cameraOf(name);
  const fitted = performance.now();
  const { lattice } = finished(latticed(bindField(node), CELLS[name] ?? 128));
  const fitting = performance.now() - fitted;
  // the first compiles
  (await raycaster.body(node, lattice)).destroy();
  const begun = performance.now();
  const body = await raycaster.body(node, lattice);
  await device.queue.onSubmittedWorkDone();
  const located = performance.now() - begun;
  const bodies = [{ body, placement: UNMOVED }];
  const image = raycaster.image(PIXELS, PIXELS);
  const cast = (rounds: number) => timeOf(device, raycaster, image, bodies, camera, rounds);
  const first = await cast(1);
  const { terms, lost } = await image.work();
  const ms = first > LONG ? first : (await cast(ROUNDS)) / ROUNDS;
  const row = {
    scene: name,
    'fitting, CPU': rounded(fitting, 1),
    'bricks found': rounded(located, 1),
    bricks: body.bricks,
    MiB: rounded(body.bytes / 2 ** 20, 1),
    'a picture': rounded(ms, 2),
    'evaluations a pixel': rounded(((WITH_GRADIENT + TEST) * terms) / PIXELS ** 2, 1),
    lost,
  };
  image.destroy();
  body.destroy();
  raycaster.destroy();
  return row;
}

async function timeOf(
  device: GPUDevice,
  raycaster: Awaited<ReturnType<typeof gpuRaycaster>>,
  image: DeviceImage,
  bodies: readonly PlacedBody[],
  camera: RayCamera,
  rounds: number,
): Promise<number> {
  await device.queue.onSubmittedWorkDone();
  const start = performance.now();
  for (let round = 0; round < rounds; round++) raycaster.cast(image, bodies, camera);
  await device.queue.onSubmittedWorkDone();
  return performance.now() - start;
}
