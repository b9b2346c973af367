/** A back end that cannot be trusted gives way to the next one, and the page says so. */
import { expect, type Page, test } from '@playwright/test';
import { everyStyleAndTool } from './everything.ts';
import { drawVase, listen, ON_FORM, open, saturation, serious, shown, VIEWPORT } from './life.ts';

test.use({ viewport: VIEWPORT });

const why = (page: Page) =>
  page.evaluate(() => document.querySelector('rotund-sketch')!.session.scene!.fallbackReason);

async function expectWebGL(page: Page, reason: RegExp): Promise<void> {
  const errors = listen(page);
  const pen = await open(page, 'WebGL2');
  expect(await why(page)).toMatch(reason);
  await expect(page.locator('.status')).toContainText('WebGL2, slower');
  await page.getByRole('button', { name: 'More' }).click();
  await expect(page.getByRole('dialog', { name: 'More' })).toContainText('WebGL2: ');
  await page.keyboard.press('Escape');
  await drawVase(page, pen);
  expect(saturation(await shown(page), ON_FORM)).toBeGreaterThan(60);
  expect(serious(errors)).toEqual([]);
}

test('asked for by the address, WebGL2 draws every style for every tool', async ({ page }) => {
  const errors = listen(page);
  const pen = await open(page, 'WebGL2', '/?backend=webgl2');
  await everyStyleAndTool(page, pen);
  await expect(page.locator('.status')).toContainText('WebGL2, slower');
  expect(serious(errors)).toEqual([]);
});

test('a device that computes nonsense is not used', async ({ page }) => {
  await page.addInitScript(() => {
    const make = GPUDevice.prototype.createComputePipeline;
    GPUDevice.prototype.createComputePipeline = function (descriptor) {
      const code = `@group(0) @binding(0) var<storage, read_write> numbers: array<f32>;
        @compute @workgroup_size(64) fn wrong(@builtin(local_invocation_index) i: u32) { numbers[i] = 7.0; }`;
      const compute = { module: this.createShaderModule({ code }), entryPoint: 'wrong' };
      return make.call(this, { ...descriptor, compute });
    };
  });
  await expectWebGL(page, /^self-test failed: computed 7 in place of 3969.5$/);
});

test('a device whose answers cannot be read is not used', async ({ page }) => {
  await page.addInitScript(() => {
    GPUBuffer.prototype.mapAsync = () => Promise.reject(new Error('mapping is broken'));
  });
  await expectWebGL(page, /^self-test failed: mapping is broken$/);
});

test('a device that passes its self-test but shows nothing gives way on a fresh canvas', async ({ page }) => {
  await page.addInitScript(() => {
    GPUCanvasContext.prototype.configure = () => {
      throw new Error('no presentation');
    };
  });
  await expectWebGL(page, /^WebGPU failed: it could not draw: no presentation$/);
});
