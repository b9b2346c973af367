/** `compile()` waits for the device, on WebGL2 too, where nothing tells of its own accord that a frame is done. */
import { expect, test } from '@playwright/test';
import { openScenePage } from './picture.ts';

test('after compile nothing is left to wait for, webgl2', async ({ page }) => {
  await openScenePage(page);
  const done = await page.evaluate(async () => {
    const canvas = document.body.appendChild(document.createElement('canvas'));
    const scene = await window.createScene(canvas, { backend: 'webgl2', lineTexels: 4e6 });
    scene.resize(640, 480, 1);
    const gl = canvas.getContext('webgl2')!;
    const found: boolean[] = [];
    for (let i = 0; i < 4; i++) {
      scene.render();
      const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0)!;
      await scene.compile();
      // A look, no wait.
      found.push(gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.SIGNALED);
    }
    scene.dispose();
    return found;
  });
  expect(done).toEqual([true, true, true, true]);
});
