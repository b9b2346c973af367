import { afterAll, expect, it } from 'vitest';
import { bindField } from '../../../src/field/bind.ts';
import { gpuPolygonizer } from '../../../src/gpu/polygonize/polygonizer.ts';
import { topology } from '../../../src/mesh/check.ts';
import { sceneNode } from '../../bench/scenes/index.ts';
import { bricksOf } from '../../fixtures/bricks.ts';
import { withDevice } from '../compute.ts';
import { closeDawn, describeGpu } from '../dawn.ts';
import { EVERYTHING } from '../everything.ts';
import { compile, link } from '../../../src/gpu/link.ts';
import { brickModules } from '../../../src/gpu/bricks/stages.ts';
afterAll(closeDawn);
describeGpu('x', () => {
  it('compiles', async () => {
    await withDevice(async (device) => {
      for (const name of ['begin','cull','next','count','number'])
      await compile(device, name, link(brickModules(EVERYTHING), `bricks/${name}`));
    });
  });
  it('runs', async () => {
    const node = sceneNode('tree16');
    const n = 64;
    const lattice = { origin: [-1, -1, -1], step: 2 / n, counts: [n+1, n+1, n+1] } as const;
    const bricks = bricksOf(node, lattice);
    await withDevice(async (device) => {
      const p = gpuPolygonizer(device);
      const a = await p.whole(node, bricks);
      const m = await a.read();
      for (let i = 0; i < 3; i++) {
      const t = performance.now();
      const b = await p.whole(node, lattice);
      await device.queue.onSubmittedWorkDone();
      console.log('ms', performance.now() - t);
      const needed = await b.needed();
      console.log(JSON.stringify(needed), bricks.active.length);
      const mb = await b.read();
      console.log(topology(m), topology(mb));
      b.destroy();
      }
      p.destroy();
    });
  });
});
