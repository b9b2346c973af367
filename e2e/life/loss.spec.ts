/** The device goes at any moment: the drawing and the stroke stay, and the picture comes back by itself. */
import { type Browser, chromium, expect, type Page, test } from '@playwright/test';
import { findChromium, QUIET, SOFTWARE_WEBGPU } from '../../scripts/chromium.mjs';
import {
  difference,
  drawVase,
  LEFT,
  listen,
  ON_FORM,
  open,
  RIGHT,
  saturation,
  serious,
  shown,
  strokes,
  TUBE,
  VIEWPORT,
} from './life.ts';

test.use({ viewport: VIEWPORT });
// A new scene takes a second, on a busy machine many.
test.slow();

declare global {
  interface Window {
    /** devices made from now on that are lost on the way, and how far they get */
    doomed: ('in its self-test' | 'while the scene is built')[];
  }
}

/** Takes the device or the context away, as a driver does. */
const lose = (page: Page) =>
  page.evaluate(() => {
    const sketch = document.querySelector('rotund-sketch')!;
    const { device } = sketch.session.scene!;
    if (device) device.destroy();
    else {
      const canvas = sketch.shadowRoot!.querySelector<HTMLCanvasElement>('.picture')!;
      canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!.loseContext();
    }
  });

const scenes = new WeakMap<Page, number>();

/** Counts the scenes of a page, so that a new one can be waited for. */
async function watch(page: Page): Promise<void> {
  scenes.set(page, 0);
  await page.exposeFunction('sceneCame', () => scenes.set(page, scenes.get(page)! + 1));
  await page.addInitScript(() => {
    window.doomed = [];
    // Losses close together are told from others by the clock: on a slow machine they are not close.
    const now = performance.now.bind(performance);
    performance.now = () => now() / 20;
    const backends = new MutationObserver(() => {
      const sketch = document.querySelector('rotund-sketch');
      if (!sketch) return;
      backends.disconnect();
      let last: object | null = null;
      const look = () => {
        const { scene } = sketch.session ?? {};
        if (scene && scene !== last) (window as unknown as { sceneCame(): void }).sceneCame();
        last = scene ?? last;
        requestAnimationFrame(look);
      };
      look();
    });
    backends.observe(document, { childList: true, subtree: true });
  });
}

async function cameAgain(page: Page, count: number): Promise<void> {
  await expect.poll(() => scenes.get(page)).toBe(count);
  await expect(page.locator('.notice')).toBeHidden();
}

test('between strokes, in mid-stroke, and once more in the same stroke', async ({ page }) => {
  const errors = listen(page);
  await watch(page);
  const pen = await open(page, 'WebGPU');
  await drawVase(page, pen);
  const before = await shown(page);
  await lose(page);
  await expect(page.locator('.notice')).toContainText('Your drawing is safe');
  await cameAgain(page, 2);
  expect(difference(before, await shown(page))).toBe(0);

  await pen.trace(TUBE.slice(0, 12));
  await lose(page);
  await cameAgain(page, 3);
  expect(await strokes(page)).toEqual({ parts: 1, draft: 0, wet: true });
  for (const point of TUBE.slice(12)) await pen.move(point);
  await pen.up(TUBE.at(-1)!);
  expect(await strokes(page)).toEqual({ parts: 1, draft: 1, wet: false });
  expect(saturation(await shown(page), TUBE[20]!)).toBeGreaterThan(30);
  await page.keyboard.press('Escape');
  expect(difference(before, await shown(page))).toBe(0);
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', 'WebGPU');
  expect(serious(errors)).toEqual([]);
});

test('under a slider, and while a picture is taken', async ({ page }) => {
  const errors = listen(page);
  await watch(page);
  const pen = await open(page, 'WebGPU');
  await pen.draw(TUBE);
  const slider = page.getByRole('slider', { name: 'Tube radius' });
  const box = (await slider.boundingBox())!;
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.8, box.y + box.height / 2);
  await lose(page);
  await cameAgain(page, 2);
  await page.mouse.up();
  const radius = await page.evaluate(() => document.querySelector('rotund-sketch')!.document.brush.radius);
  expect(radius).toBeGreaterThan(8);
  const before = await shown(page);

  const told = await page.evaluate(async () => {
    const { session } = document.querySelector('rotund-sketch')!;
    const { view, look, scene } = session;
    const picture = scene!.picture({ width: 300, height: 200, view, look, items: [] });
    scene!.device!.destroy();
    return picture.then(String, (error: Error) => error.message);
  });
  expect(told).toMatch(/^The picture of 300 × 200 pixels could not be drawn: ./);
  await cameAgain(page, 3);
  expect(difference(before, await shown(page))).toBe(0);
  const again = await page.evaluate(async () => {
    const { session } = document.querySelector('rotund-sketch')!;
    const { view, look, scene } = session;
    return (await scene!.picture({ width: 300, height: 200, view, look, items: [] })).width;
  });
  expect(again).toBe(300);
  expect(serious(errors)).toEqual([]);
});

test('the replacement too, on its way; after three of them WebGL2 draws, and says why', async ({ page }) => {
  const errors = listen(page);
  await watch(page);
  await page.addInitScript(() => {
    const request = GPUAdapter.prototype.requestDevice;
    GPUAdapter.prototype.requestDevice = async function (descriptor) {
      const device = await request.call(this, descriptor);
      const fate = window.doomed.shift();
      if (fate === 'in its self-test') setTimeout(() => device.destroy());
      if (fate === 'while the scene is built') {
        let made = 0;
        const make = device.createRenderPipeline.bind(device);
        device.createRenderPipeline = (wanted) => {
          if (++made === 2) device.destroy();
          return make(wanted);
        };
      }
      return device;
    };
  });
  const pen = await open(page, 'WebGPU');
  await drawVase(page, pen);
  const before = await shown(page);
  await page.evaluate(() => window.doomed.push('in its self-test', 'while the scene is built'));
  await lose(page);
  await expect.poll(() => page.evaluate(() => window.doomed.length)).toBe(0);
  await expect.poll(() => scenes.get(page)).toBeGreaterThan(1);
  await expect(page.locator('.notice')).toBeHidden();
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', 'WebGPU');
  await expect
    .poll(() =>
      page.evaluate(async () => {
        const { scene } = document.querySelector('rotund-sketch')!.session;
        const alive =
          scene && (await Promise.race([scene.lost.then(() => false), scene.compile().then(() => true)]));
        return Boolean(alive);
      }),
    )
    .toBe(true);
  expect(difference(before, await shown(page))).toBe(0);

  await lose(page);
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', 'WebGL2');
  await expect(page.locator('.notice')).toBeHidden();
  await page.getByRole('button', { name: 'More' }).click();
  await expect(page.getByRole('dialog', { name: 'More' })).toContainText('WebGPU was lost 3 times');
  await page.keyboard.press('Escape');
  expect(difference(before, await shown(page))).toBeLessThan(0.01);
  expect(await strokes(page)).toEqual({ parts: 1, draft: 0, wet: false });
  expect(serious(errors)).toEqual([]);
});

test('WebGL2 loses its context: between strokes, in mid-stroke, and then for good', async ({ page }) => {
  const errors = listen(page);
  await watch(page);
  const pen = await open(page, 'WebGL2', '/?backend=webgl2');
  await drawVase(page, pen);
  const before = await shown(page);
  await lose(page);
  await cameAgain(page, 2);
  expect(difference(before, await shown(page))).toBe(0);

  await pen.trace(TUBE.slice(0, 12));
  await lose(page);
  await cameAgain(page, 3);
  expect(await strokes(page)).toEqual({ parts: 1, draft: 0, wet: true });
  await page.keyboard.press('Escape');
  await pen.up(TUBE[12]!);
  expect(difference(before, await shown(page))).toBe(0);

  const told = await page.evaluate(async () => {
    const sketch = document.querySelector('rotund-sketch')!;
    const { view, look, scene } = sketch.session;
    const picture = scene!.picture({ width: 300, height: 200, view, look, items: [] });
    const canvas = sketch.shadowRoot!.querySelector<HTMLCanvasElement>('.picture')!;
    canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!.loseContext();
    return picture.then(String, (error: Error) => error.message);
  });
  expect(told).toMatch(/could not be drawn: the WebGL context was lost$/);
  const card = page.getByRole('region', { name: 'There is no picture here' });
  await expect(card).toContainText('WebGL2 was lost 3 times');
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', 'none');
  await card.getByRole('button', { name: 'Try again' }).click();
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', 'WebGL2');
  await expect(card).toBeHidden();
  expect(difference(before, await shown(page))).toBe(0);
  expect(serious(errors)).toEqual([]);
});

test('the whole graphics process dies in mid-stroke', async () => {
  const browser: Browser = await chromium.launch({
    executablePath: findChromium() ?? '/usr/bin/chromium',
    args: [...SOFTWARE_WEBGPU, ...QUIET],
  });
  try {
    const page = await browser.newPage({ viewport: VIEWPORT, baseURL: test.info().project.use.baseURL! });
    const errors = listen(page);
    await watch(page);
    const pen = await open(page, 'WebGPU');
    await pen.draw(LEFT);
    await pen.trace(RIGHT.slice(0, 12));
    const system = await browser.newBrowserCDPSession();
    await system.send('Browser.crashGpuProcess');
    await cameAgain(page, 2);
    for (const point of RIGHT.slice(12)) await pen.move(point);
    await pen.up(RIGHT.at(-1)!);
    expect(await strokes(page)).toEqual({ parts: 0, draft: 2, wet: false });
    await page.locator('.stage').focus();
    await page.keyboard.press('n');
    expect(saturation(await shown(page), ON_FORM)).toBeGreaterThan(60);
    expect(serious(errors)).toEqual([]);
  } finally {
    await browser.close();
  }
});
