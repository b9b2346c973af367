/** Neither WebGPU nor WebGL2: the page says what is missing and goes on with everything that needs no picture. */
import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { findChromium, QUIET } from '../../scripts/chromium.mjs';
import { drawVase, LEFT, listen, open, serious, TUBE } from './life.ts';

test.use({
  viewport: { width: 800, height: 600 },
  launchOptions: {
    executablePath: findChromium() ?? '/usr/bin/chromium',
    args: ['--disable-3d-apis', ...QUIET],
  },
});

const CARD = { name: 'There is no picture here' } as const;

test('a card says what is missing, why, and what can still be done', async ({ page }) => {
  const errors = listen(page);
  await open(page, 'none');
  const card = page.getByRole('region', CARD);
  await expect(card).toContainText('neither WebGPU nor WebGL2');
  await expect(card).toContainText('WebGPU found no graphics adapter');
  await expect(page.locator('.status')).toContainText('No picture');
  await expect(page.locator('.status')).not.toContainText('Preparing');
  for (const theme of ['light', 'dark', 'contrast']) {
    await page.locator('rotund-sketch').evaluate((sketch, name) => sketch.setAttribute('theme', name), theme);
    const { violations } = await new AxeBuilder({ page }).analyze();
    expect(violations.map(({ id, nodes }) => `${theme} ${id}: ${nodes[0]?.failureSummary}`)).toEqual([]);
  }
  await card.getByRole('button', { name: 'Open a file' }).click();
  await expect(page.getByRole('dialog')).toBeVisible();
  await page.keyboard.press('Escape');
  await card.getByRole('button', { name: 'Export' }).click();
  await expect(page.getByRole('dialog')).toBeVisible();
  await page.keyboard.press('Escape');
  await card.getByRole('button', { name: 'Try again' }).click();
  await expect(card).toContainText('neither WebGPU nor WebGL2');
  await card.getByRole('button', { name: 'Close' }).click();
  await expect(card).toBeHidden();
  await expect(page.locator('.status')).toContainText('No picture');
  expect(serious(errors)).toEqual([]);
});

test('strokes are shown as ink, kept, saved, exported and opened again', async ({ page }) => {
  const errors = listen(page);
  const pen = await open(page, 'none');
  await page.getByRole('region', CARD).getByRole('button', { name: 'Close' }).click();
  await drawVase(page, pen);
  await pen.draw(TUBE);
  await expect.poll(() => inkNear(TUBE[12]!)).toBeGreaterThan(0);
  // What was kept, too.
  expect(await inkNear(LEFT[12]!)).toBeGreaterThan(0);
  const made = await page.evaluate(async () => {
    const sketch = document.querySelector('rotund-sketch')!;
    const text = sketch.save();
    const [file] = await sketch.export('stl');
    await sketch.load(text);
    const pictured = await sketch.picture({ width: 100, height: 100 }).then(
      () => 'a picture',
      (error) => String(error),
    );
    return {
      bytes: file!.bytes.length,
      parts: sketch.document.parts.length,
      again: sketch.save() === text,
      pictured,
    };
  });
  expect(made.bytes).toBeGreaterThan(1000);
  expect(made).toMatchObject({ parts: 1, again: true });
  expect(made.pictured).toContain('no WebGL2 context');
  expect(serious(errors)).toEqual([]);

  function inkNear([x, y]: readonly [number, number]): Promise<number> {
    return page.evaluate(
      ([left, top]) => {
        const ink = document
          .querySelector('rotund-sketch')!
          .shadowRoot!.querySelector<HTMLCanvasElement>('.ink')!;
        const { data } = ink.getContext('2d')!.getImageData(left - 5, top - 5, 10, 10);
        return data.filter((value, i) => i % 4 === 3 && value > 128).length;
      },
      [x, y] as const,
    );
  }
});
