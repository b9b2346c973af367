/** A window moved to another screen: other pixels, the same size; the picture follows at once and is sharp. */
import { expect, type Page, test } from '@playwright/test';
import { drawVase, open, VIEWPORT } from './life.ts';

test.use({ viewport: VIEWPORT });

test('the picture and the ink have the pixels of the screen they are on', async ({ page }) => {
  const pen = await open(page, 'WebGPU');
  await drawVase(page, pen);
  const session = await page.context().newCDPSession(page);
  for (const deviceScaleFactor of [2, 1]) {
    await session.send('Emulation.setDeviceMetricsOverride', {
      ...VIEWPORT,
      deviceScaleFactor,
      mobile: false,
    });
    // A real screen lets the browser look at its media queries again; the emulated one leaves that to another change.
    await page.emulateMedia({ reducedMotion: deviceScaleFactor === 2 ? 'reduce' : 'no-preference' });
    const sizes = () =>
      page.evaluate(() =>
        [...document.querySelector('rotund-sketch')!.shadowRoot!.querySelectorAll('canvas')].map(
          ({ width, height }) => [width, height],
        ),
      );
    const expected = [VIEWPORT.width * deviceScaleFactor, VIEWPORT.height * deviceScaleFactor];
    await expect.poll(sizes).toEqual([expected, expected]);
    const colour = (x: number, y: number) => saturation(page, x * deviceScaleFactor, y * deviceScaleFactor);
    expect(await colour(200, 220), 'on the form').toBeGreaterThan(60);
    expect(await colour(120, 220), 'beside it').toBeLessThan(30);
    expect(await colour(280, 220), 'beside it').toBeLessThan(30);
  }
});

/** How far a pixel of the canvas itself is from grey. */
const saturation = (page: Page, x: number, y: number): Promise<number> =>
  page.evaluate(
    ([left, top]) => {
      const sketch = document.querySelector('rotund-sketch')!;
      const canvas = sketch.shadowRoot!.querySelector<HTMLCanvasElement>('.picture')!;
      const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d')!;
      // In the task that drew it the canvas still holds its picture.
      sketch.session.scene!.render();
      copy.drawImage(canvas, 0, 0);
      const [r, g, b] = copy.getImageData(left, top, 1, 1).data;
      return Math.max(r!, g!, b!) - Math.min(r!, g!, b!);
    },
    [x, y] as const,
  );
