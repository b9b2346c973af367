/** The field page: a body at first sight, sliders that change it, errors in words, the fallback, accessibility. */
import AxeBuilder from '@axe-core/playwright';
import { expect, type Page, test } from '@playwright/test';
import type { FieldNode } from '../../src/field/node.ts';
import { readPicture } from '../picture.ts';

/** what a software adapter and two cores make in no time */
const COARSE = '#resolution=32';

/** it compiles what it has not compiled yet */
const PATIENT = { timeout: 60_000 };

async function open(page: Page, address: string): Promise<void> {
  await page.goto(address);
  await expect(page.locator('rotund-field')).toHaveAttribute('data-backend', /WebG/);
  await expect(page.getByRole('status')).toHaveText('Body made');
}

/** What is shown, and what is wrong with what is not. */
const body = (page: Page) =>
  page.evaluate(() => {
    const { made, problem } = document.querySelector('rotund-field')!.body;
    const { id, triangles, maker } = made ?? { id: 0, triangles: 0, maker: '' };
    return { id, triangles, maker, onDevice: made !== null && 'draw' in made.mesh, problem };
  });

/** Share of the free picture that is neither paper nor grey: orange fur. */
async function coloured(page: Page): Promise<number> {
  await page.evaluate(async () => {
    document.querySelector('rotund-field')!.stage.wake();
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  });
  const picture = readPicture(await page.screenshot({ clip: { x: 0, y: 80, width: 440, height: 420 } }));
  let found = 0;
  for (let x = 0; x < 440; x += 4) {
    for (let y = 0; y < 420; y += 4) {
      const [red, , blue] = picture.at(x, y);
      if (red - blue > 60) found++;
    }
  }
  return found / (110 * 105);
}

test('a body appears in colour, a slider changes it, the address keeps it', async ({ page }) => {
  await open(page, `/field.html${COARSE}`);
  const first = await body(page);
  expect(first.triangles).toBeGreaterThan(1000);
  const orange = await coloured(page);
  expect(orange).toBeGreaterThan(0.05);

  const radius = page.getByRole('slider', { name: 'Radius', exact: true }).first();
  await radius.focus();
  for (let i = 0; i < 12; i++) await radius.press('ArrowRight');
  await expect(page.getByRole('status')).toHaveText('Body made');
  await expect.poll(async () => (await body(page)).triangles).not.toBe(first.triangles);
  expect(await coloured(page)).toBeGreaterThan(1.1 * orange);

  await expect.poll(() => page.evaluate(() => location.hash)).toMatch(/^#radius=\d/);
  await radius.dblclick();
  await expect.poll(() => page.evaluate(() => location.hash)).toBe(COARSE);
  await radius.press('ArrowRight');
  await expect.poll(() => page.evaluate(() => location.hash)).toMatch(/^#radius=\d/);
  await radius.press('Delete');
  await expect.poll(() => page.evaluate(() => location.hash)).toBe(COARSE);
  await expect.poll(async () => (await body(page)).triangles).toBe(first.triangles);
});

test('on the graphics device it is the same body, drawn where it lies', async ({ page }) => {
  await open(page, `/field.html${COARSE}`);
  const onCpu = await body(page);
  expect(onCpu).toMatchObject({ onDevice: false, maker: 'CPU, worker' });
  await expect(page.locator('.status')).toContainText(
    /CPU, worker · \d+ × \d+ × \d+ cells · \d+( k)? evaluations · mesh after \d+ ms/,
  );
  const orange = await coloured(page);
  await page.getByRole('radio', { name: 'GPU' }).click();
  await expect.poll(async () => (await body(page)).id, PATIENT).toBeGreaterThan(onCpu.id);
  expect(await body(page)).toMatchObject({ onDevice: true, triangles: onCpu.triangles });
  await expect(page.locator('.status')).toContainText(/GPU, float32 · \d+ × \d+ × \d+ cells/);
  expect(Math.abs((await coloured(page)) / orange - 1)).toBeLessThan(0.02);

  // a slider goes on from there
  const before = await body(page);
  await page.getByRole('slider', { name: 'Radius', exact: true }).first().press('ArrowRight');
  await expect.poll(async () => (await body(page)).triangles, PATIENT).not.toBe(before.triangles);
  expect(await body(page)).toMatchObject({ onDevice: true, problem: null });
});

test('on the graphics device an edit of a body writes only what it reaches', async ({ page }) => {
  await open(page, `/field.html${COARSE}&where=gpu`);
  await expect.poll(async () => (await body(page)).onDevice, PATIENT).toBe(true);
  const made = await page.evaluate(async () => {
    const { body, stage } = document.querySelector('rotund-field')!;
    const { queue } = stage.scene!.device!;
    let bytes = 0;
    queue.writeBuffer = new Proxy(queue.writeBuffer, {
      apply(write, _, args: Parameters<GPUQueue['writeBuffer']>) {
        if (args[0].label === 'lists') bytes += args[2].byteLength;
        Reflect.apply(write, queue, args);
      },
    });
    const row = (lean: number): FieldNode => ({
      type: 'skels',
      kernel: 'quartic',
      params: { R: 4 },
      threshold: 1,
      skels: Array.from({ length: 14 }, (_, i) => ({
        skel: { type: 'segment', a: [8 * i, 0, 0], b: [8 * i, 9, i === 4 ? lean : i / 3], weights: [1] },
      })),
    });
    const make = async (lean: number) => {
      bytes = 0;
      const before = body.made!.id;
      body.make(() => row(lean), 64, true);
      while (body.progress !== null || body.made!.id === before || body.made!.draft)
        await new Promise((done) => requestAnimationFrame(done));
      return { bytes, triangles: body.made!.triangles, onDevice: 'draw' in body.made!.mesh };
    };
    return [await make(0), await make(0.5), await make(1), await make(0)];
  });
  const [whole, ...edits] = made;
  for (const { bytes, onDevice, triangles } of edits) {
    expect(onDevice).toBe(true);
    expect(bytes).toBeGreaterThan(0);
    expect(bytes).toBeLessThan(0.4 * whole!.bytes);
    expect(Math.abs(triangles / whole!.triangles - 1)).toBeLessThan(0.05);
  }
  expect(edits.at(-1)!.triangles).toBe(whole!.triangles);
});

test('what has sharp edges is made on the graphics device, too', async ({ page }) => {
  await open(page, '/field.html#skeleton=segment&operation=union&resolution=32&where=gpu');
  await expect.poll(async () => (await body(page)).onDevice, PATIENT).toBe(true);
  await expect(page.locator('.status')).toContainText('GPU, float32');
  expect(await body(page)).toMatchObject({ problem: null });
});

test('the body comes back after its device was lost', async ({ page }) => {
  await open(page, `/field.html${COARSE}&where=gpu`);
  await expect.poll(async () => (await body(page)).onDevice, PATIENT).toBe(true);
  const { triangles } = await body(page);
  await page.evaluate(() => document.querySelector('rotund-field')!.stage.scene!.device!.destroy());
  await expect.poll(async () => (await body(page)).onDevice, PATIENT).toBe(false);
  await expect
    .poll(async () => {
      const now = await body(page);
      return now.triangles;
    }, PATIENT)
    .toBe(triangles);
  expect((await body(page)).problem).toBeNull();
  // the next device has its turn
  await expect.poll(async () => (await body(page)).onDevice, PATIENT).toBe(true);
});

test('what is hardly thicker than its cells is said, until there are enough of them', async ({ page }) => {
  await open(page, '/field.html#skeleton=ring&radius=2&resolution=24');
  await expect(page.locator('.status')).toContainText(/Hardly thicker than a cell or two in \d+ places?/);
  await page.evaluate(() => {
    location.hash = '#skeleton=ring&radius=2&resolution=144';
  });
  await expect(page.locator('.status')).not.toContainText('Hardly');
  await expect(page.getByRole('status')).toHaveText('Body made');
});

test('what has no field is told, and the last body stays', async ({ page }) => {
  await open(page, '/field.html#skeleton=segment&kernel=nonsense');
  await expect(page.getByRole('alert')).toContainText('found “nonsense”');
  // all else in the address holds
  await expect(page.getByRole('radio', { name: 'Segment' })).toBeChecked();
  await page.getByRole('button', { name: 'Close' }).click();
  await expect(page.getByRole('alert')).toHaveCount(0);
  const { triangles } = await body(page);
  await expect(page.locator('.status')).toContainText('triangles');
  await page.evaluate(() => {
    location.hash = '#skeleton=segment&kernel=quartic&width=own&R=10';
  });
  await expect(page.getByRole('alert')).toContainText('beyond its support');
  await expect(page.getByRole('status')).toHaveText('Not made. The last body stays');
  expect((await body(page)).triangles).toBe(triangles);
  await expect(page.locator('.status')).not.toContainText('triangles');
  await page.getByRole('button', { name: 'Reset everything' }).click();
  await expect(page.getByRole('alert')).toHaveCount(0);
});

test('the whole body is in sight: on demand, and when a choice makes it larger', async ({ page }) => {
  const height = () => page.evaluate(() => document.querySelector('rotund-field')!.stage.view.height);
  await open(page, '/field.html#skeleton=segment&shapeX=60&resolution=32');
  const first = await height();
  await page.locator('.stage').press('+');
  expect(await height()).toBeLessThan(first);
  await page.getByRole('button', { name: 'Show everything' }).click();
  await expect.poll(height).toBeCloseTo(first, 6);
  await page.getByRole('radio', { name: 'Union' }).click();
  await expect.poll(height).toBeGreaterThan(1.1 * first);
  await expect(page.getByRole('status')).toHaveText('Body made');
  const all = await height();
  const { id } = await body(page);
  await page.getByRole('slider', { name: 'Size' }).press('ArrowRight');
  await expect.poll(async () => (await body(page)).id).toBeGreaterThan(id);
  await expect(page.getByRole('status')).toHaveText('Body made');
  expect(await height()).toBe(all);
});

test('without WebGPU, on a phone, in the dark: the same body, and nothing axe would say', async ({
  page,
}) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await page.emulateMedia({ colorScheme: 'dark', reducedMotion: 'reduce' });
  await open(page, '/field.html?backend=webgl2#skeleton=crossed&operation=union&resolution=40');
  await expect(page.locator('.status')).toContainText('WebGL2, slower');
  expect((await body(page)).triangles).toBeGreaterThan(1500);
  // there is no device that could make it
  await expect(page.getByRole('radio', { name: 'GPU' })).toHaveCount(0);
  const { violations } = await new AxeBuilder({ page }).analyze();
  expect(violations).toEqual([]);
  await page.getByRole('button', { name: 'Hide the controls' }).click();
  await expect(page.getByRole('slider').first()).toBeHidden();
});
