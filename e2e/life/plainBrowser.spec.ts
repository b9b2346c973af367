/** Chromium as it comes, without a flag for WebGPU: it finds no adapter, and WebGL2 draws everything. */
import { expect, test } from '@playwright/test';
import { findChromium, QUIET } from '../../scripts/chromium.mjs';
import { everyStyleAndTool } from './everything.ts';
import { listen, open, serious, VIEWPORT } from './life.ts';

test.use({
  viewport: VIEWPORT,
  launchOptions: { executablePath: findChromium() ?? '/usr/bin/chromium', args: QUIET },
});

test('WebGL2 draws every style for every tool, and says why it is there', async ({ page }) => {
  const errors = listen(page);
  const pen = await open(page, 'WebGL2');
  await everyStyleAndTool(page, pen);
  await expect(page.locator('.status')).toContainText('WebGL2, slower');
  await page.getByRole('button', { name: 'More' }).click();
  await expect(page.getByRole('dialog', { name: 'More' })).toContainText(
    /WebGL2: (this browser has no WebGPU|WebGPU found no graphics adapter)/,
  );
  expect(serious(errors)).toEqual([]);
});
