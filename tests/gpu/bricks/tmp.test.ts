import { afterAll, it } from 'vitest';
import { boundedProgram } from '../../../src/gpu/bricks/bounds.ts';
import { rowsOf } from '../../../src/gpu/bricks/cullsOnDevice.ts';
import { encodeCulling } from '../../../src/gpu/bricks/encode.ts';
import { COUNTERS, firstRooms, neededRooms } from '../../../src/gpu/bricks/levels.ts';
import { brickStagesOn } from '../../../src/gpu/bricks/stages.ts';
import { Buffers, readBack, USAGE } from '../../../src/gpu/polygonize/buffers.ts';
import { programOf } from '../../../src/gpu/program.ts';
import { loadScan } from '../../../src/gpu/scan.ts';
import { sceneNode } from '../../bench/scenes/index.ts';
import { bricksOf } from '../../fixtures/bricks.ts';
import { withDevice } from '../compute.ts';
import { closeDawn, describeGpu } from '../dawn.ts';

afterAll(closeDawn);
describeGpu('x', () => {
  it('runs', async () => {
    for (const [name, n] of (process.env.SC ?? 'tree16 64')
      .split(',')
      .map((x) => x.split(' ') as [string, string])) {
      const node = sceneNode(name as 'tree16');
      const N = Number(n);
      const lattice = { origin: [-1, -1, -1], step: 2 / N, counts: [N + 1, N + 1, N + 1] } as const;
      const t0 = performance.now();
      const bricks = bricksOf(node, lattice);
      console.log(name, N, 'cpu', performance.now() - t0, bricks.active.length);
      await withDevice(async (device) => {
        const program = programOf(node);
        const t1 = performance.now();
        const stages = await brickStagesOn(device)(program.ingredients);
        console.log('pipeline', performance.now() - t1);
        const scan = await loadScan(device);
        const work = new Buffers(device);
        const bounded = boundedProgram(node, program);
        const rooms = firstRooms(lattice, rowsOf(program));
        for (let i = 0; i < 4; i++) {
          const t = performance.now();
          const counters = work.put('counters', new Uint32Array(COUNTERS), USAGE.storage | USAGE.copySource);
          const encoder = device.createCommandEncoder();
          const pass = encoder.beginComputePass();
          encodeCulling(
            device,
            pass,
            scan,
            work,
            { lattice, stages, bounded, rooms },
            { vertices: 1, triangles: 1 },
            counters,
          );
          pass.end();
          device.queue.submit([encoder.finish()]);
          await device.queue.onSubmittedWorkDone();
          const ms = performance.now() - t;
          const [b] = await readBack(device, [counters]);
          console.log('ms', ms, JSON.stringify(neededRooms(new Uint32Array(b!))));
        }
        work.destroy();
      });
    }
  });
});
