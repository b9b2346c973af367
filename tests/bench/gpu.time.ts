/** Fields on the GPU, by Dawn in Node on whatever adapter it finds; says which. */
import { create } from 'webgpu';
import { openDevice } from '../../src/gpu/device.ts';
import { timePolygonizer } from './gpuPolygonize.ts';
import { timePolygons } from './gpuPolygons.ts';
import { timeSkels } from './gpuSkels.ts';
import { timeTrees } from './gpuTrees.ts';

// has to stay referenced while the device lives
const dawn: { gpu: GPU | null } = { gpu: create([]) as GPU };
const opened = await openDevice(dawn.gpu!);
if ('reason' in opened) {
  console.log(`No graphics adapter: ${opened.reason}`);
} else {
  console.log(`Fields on ${opened.description.adapter}`);
  await timeSkels(opened.device);
  await timePolygons(opened.device);
  await timeTrees(opened.device);
  await timePolygonizer(opened.device);
  opened.release();
}
dawn.gpu = null;
