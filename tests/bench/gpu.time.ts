/**
 * Fields on the GPU, by Dawn in Node on whatever adapter it finds; says which. `ROTUND_TABLES=polygonizer,kravtsov` chooses.
 */
import { create } from 'webgpu';
import { openDevice } from '../../src/gpu/device.ts';
import { timeCulling } from './gpuCulling.ts';
import { timeKravtsov, timePolygonizer } from './gpuPolygonize.ts';
import { timePolygons } from './gpuPolygons.ts';
import { timeRays } from './gpuRaycast.ts';
import { timeSkels } from './gpuSkels.ts';
import { timeTrees } from './gpuTrees.ts';

const TABLES: Readonly<Record<string, (device: GPUDevice) => Promise<void>>> = {
  skels: timeSkels,
  polygons: timePolygons,
  trees: timeTrees,
  polygonizer: timePolygonizer,
  culling: timeCulling,
  kravtsov: timeKravtsov,
  rays: timeRays,
};

// has to stay referenced while the device lives
const dawn: { gpu: GPU | null } = { gpu: create([]) as GPU };
const opened = await openDevice(dawn.gpu!);
if ('reason' in opened) {
  console.log(`No graphics adapter: ${opened.reason}`);
} else {
  console.log(`Fields on ${opened.description.adapter}`);
  const chosen = process.env.ROTUND_TABLES?.split(',') ?? Object.keys(TABLES);
  for (const name of chosen) await TABLES[name]?.(opened.device);
  opened.release();
}
dawn.gpu = null;
