/** A window moved to another screen: other pixels, the same size; the picture follows at once and is sharp. */
import { expect, test } from '@playwright/test';
import { drawVase, open, saturation, shown, VIEWPORT } from './life.ts';

test.use({ viewport: VIEWPORT });

test('the picture and the ink have the pixels of the screen they are on', async ({ page }) => {
  const pen = await open(page, 'WebGPU');
  await drawVase(page, pen);
  const session = await page.context().newCDPSession(page);
  for (const deviceScaleFactor of [2, 1.5, 1]) {
    await session.send('Emulation.setDeviceMetricsOverride', {
      ...VIEWPORT,
      deviceScaleFactor,
      mobile: false,
    });
    const sizes = () =>
      page.evaluate(() =>
        [...document.querySelector('rotund-sketch')!.shadowRoot!.querySelectorAll('canvas')].map(
          ({ width, height }) => [width, height],
        ),
      );
    const expected = [VIEWPORT.width * deviceScaleFactor, VIEWPORT.height * deviceScaleFactor];
    await expect.poll(sizes).toEqual([expected, expected]);
    const picture = await shown(page);
    expect([picture.width, picture.height]).toEqual(expected);
    const at = (x: number, y: number) => [x * deviceScaleFactor, y * deviceScaleFactor] as const;
    expect(saturation(picture, at(200, 220)), 'on the form').toBeGreaterThan(60);
    expect(saturation(picture, at(120, 220)), 'beside it').toBeLessThan(30);
    expect(saturation(picture, at(280, 220)), 'beside it').toBeLessThan(30);
  }
});
