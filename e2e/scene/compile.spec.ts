/** `compile()` waits for the device, on WebGL2 too, where nothing tells of its own accord that a frame is done. */
import { expect, test } from '@playwright/test';
import { openScenePage } from './picture.ts';

test('after compile nothing is left to wait for, webgl2', async ({ page }) => {
  await openScenePage(page);
  const { waited, left } = await page.evaluate(async () => {
    const { createScene } = await import(/* @vite-ignore */ `${location.origin}/src/scene/index.ts`);
    const canvas = document.body.appendChild(document.createElement('canvas'));
    const scene = await createScene(canvas, { backend: 'webgl2', lineTexels: 4e6 });
    scene.resize(640, 480, 1);
    const gl = canvas.getContext('webgl2')!;
    // Reading a pixel waits for all that was drawn before it.
    const read = () => {
      const start = performance.now();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      return performance.now() - start;
    };
    await scene.compile();
    let [drawn, after] = [0, 0];
    for (let i = 0; i < 4; i++) {
      scene.render();
      drawn += read();
      await scene.compile();
      after += read();
    }
    scene.dispose();
    return { waited: drawn, left: after };
  });
  expect(left).toBeLessThan(waited / 3);
});
