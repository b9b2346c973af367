/** What elements take of the graphics device they give back: counted, not guessed. */
import { expect, type Page, test } from '@playwright/test';
import { type Count, countDevice } from './count.ts';
import { listen, serious } from './life.ts';

test.use({ viewport: { width: 256, height: 256 } });
test.slow();

async function openPage(page: Page): Promise<readonly string[]> {
  const errors = listen(page);
  await page.addInitScript(countDevice);
  await page.goto('/e2e/life/index.html');
  await page.waitForFunction(() => typeof window.mount === 'function');
  return errors;
}

const count = (page: Page): Promise<Count> => page.evaluate(() => ({ ...window.count }));

/** Elements that come and go; the counts after each of them. */
const comeAndGo = (page: Page, times: number, backend: 'auto' | 'webgl2'): Promise<Count[]> =>
  page.evaluate(
    async ([n, choice]) => {
      const counts: Count[] = [];
      await window.comeAndGo(n, choice, () => counts.push({ ...window.count }));
      return counts;
    },
    [times, backend] as const,
  );

/** Scenes still in memory after a collection. */
async function scenesInMemory(page: Page): Promise<number> {
  const session = await page.context().newCDPSession(page);
  await session.send('HeapProfiler.collectGarbage');
  return page.evaluate(() => window.scenesInMemory());
}

test('50 elements beside one that stays leave its device as it was', async ({ page }) => {
  const errors = await openPage(page);
  await page.evaluate(async () => {
    window.keeper = await window.mount('auto');
  });
  const before = await count(page);
  expect(before.bytes).toBeGreaterThan(100_000);
  expect(before.devices).toBe(1);
  const counts = await comeAndGo(page, 50, 'auto');
  for (const [i, { bytes, resources, devices }] of counts.entries()) {
    expect({ i, bytes, resources, devices }).toEqual({
      i,
      bytes: before.bytes,
      resources: before.resources,
      devices: 1,
    });
  }
  expect(await page.evaluate(() => window.keeper.dataset.backend)).toBe('WebGPU');
  // the keeper's own, and the last one, which the engine may still be holding in its hand
  await expect.poll(() => scenesInMemory(page)).toBeLessThanOrEqual(2);
  await page.evaluate(() => window.unmount(window.keeper));
  expect((await count(page)).devices).toBe(0);
  expect(serious(errors)).toEqual([]);
});

test('elements on WebGL2 leave no context and no object', async ({ page }) => {
  const errors = await openPage(page);
  const counts = await comeAndGo(page, 10, 'webgl2');
  for (const { contexts, objects } of counts)
    expect({ contexts, objects }).toEqual({ contexts: 0, objects: 0 });
  await expect.poll(() => scenesInMemory(page)).toBeLessThanOrEqual(1);
  expect(serious(errors)).toEqual([]);
});

test('200 steps back and forth leave the device as it was', async ({ page }) => {
  await openPage(page);
  const counts = await page.evaluate(async () => {
    const sketch = await window.mount('auto');
    const frame = () => new Promise(requestAnimationFrame);
    const seen: Count[] = [];
    for (let i = 0; i < 50; i++) {
      for (const step of ['undo', 'undo', 'redo', 'redo'] as const) {
        sketch[step]();
        await frame();
      }
      await frame();
      seen.push({ ...window.count });
    }
    return seen;
  });
  const { bytes, resources } = counts[4]!;
  for (const [i, now] of counts.entries()) {
    if (i > 4) expect({ i, bytes: now.bytes, resources: now.resources }).toEqual({ i, bytes, resources });
  }
});

test('an element that leaves before its scene is there, and one that is put elsewhere', async ({ page }) => {
  const errors = await openPage(page);
  const backends = await page.evaluate(async () => {
    const sketch = document.createElement('rotund-sketch');
    sketch.controls = 'none';
    document.body.append(sketch);
    await sketch.updateComplete;
    // at several points of its way to a scene
    for (const wait of [0, 1, 5, 20, 60, 150, 300]) {
      await new Promise((done) => setTimeout(done, wait));
      sketch.remove();
      document.body.append(sketch);
    }
    const other = document.body.appendChild(document.createElement('div'));
    other.append(sketch);
    await new Promise((resolve) => sketch.addEventListener('ready', resolve, { once: true }));
    const first = sketch.dataset.backend;
    sketch.remove();
    return [first, sketch.session.scene];
  });
  expect(backends).toEqual(['WebGPU', null]);
  await expect.poll(async () => (await count(page)).devices).toBe(0);
  expect(serious(errors)).toEqual([]);
});

test('frames are drawn only when something changes', async ({ page }) => {
  await openPage(page);
  for (const backend of ['auto', 'webgl2'] as const) {
    await page.evaluate(async (choice) => {
      window.keeper = await window.mount(choice);
      await window.keeper.picture({ width: 64, height: 64 });
    }, backend);
    // A loop asks for a frame in every frame: then no such while is without one.
    const asked = () =>
      page.evaluate(async () => {
        const before = window.count.frames;
        await new Promise((done) => setTimeout(done, 500));
        return window.count.frames - before;
      });
    await expect.poll(asked, backend).toBe(0);
    const before = (await count(page)).frames;
    await page.evaluate(() => window.keeper.undo());
    await expect.poll(async () => (await count(page)).frames, backend).toBeGreaterThan(before);
    await expect.poll(asked, backend).toBe(0);
    await page.evaluate(() => window.unmount(window.keeper));
  }
});
