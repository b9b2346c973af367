/** Fields on the GPU, by Dawn in Node on whatever adapter it finds; says which. */
import { create } from 'webgpu';
import { openDevice } from '../../src/gpu/device.ts';
import { timeTrees } from './tree.time.ts';

// has to stay referenced while the device lives
const dawn: { gpu: GPU | null } = { gpu: create([]) as GPU };
const opened = await openDevice(dawn.gpu!);
if ('reason' in opened) {
  console.log(`No graphics adapter: ${opened.reason}`);
} else {
  console.log(`Fields on ${opened.description.adapter}`);
  await timeTrees(opened.device);
  opened.release();
}
dawn.gpu = null;
