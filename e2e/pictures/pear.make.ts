/** The README's pictures: the pear, drawn with a pen, in every style; and the application while it is being drawn. */
import { mkdirSync, writeFileSync } from 'node:fs';
import { expect, type Page, test } from '@playwright/test';
import { PNG } from 'pngjs';
import { BODY, STEM } from '../pear.ts';
import { PenDriver } from '../pen.ts';
import { takePicture } from '../picture.ts';

const OUT = 'docs/pictures';
const STYLES = ['Toon', 'Lines', 'Ink', 'Shaded'] as const;

/** Device pixels a CSS pixel: sharp enough for a page, small enough for a repository. */
const RATIO = 1.5;

test.use({ deviceScaleFactor: RATIO });

async function open(page: Page): Promise<PenDriver> {
  mkdirSync(OUT, { recursive: true });
  await page.goto('/?quality=fine');
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', /WebG/);
  return PenDriver.on(page);
}

async function colour(page: Page, name: string): Promise<void> {
  await page.getByRole('toolbar').getByRole('button', { name: 'Colour' }).click();
  await page.getByRole('radio', { name, exact: true }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Close' }).click();
}

test('pear in every style', async ({ page }) => {
  const pen = await open(page);
  for (const stroke of BODY) await pen.draw(stroke);
  await page.screenshot({ path: `${OUT}/drawing.png` });
  await page.getByRole('button', { name: 'Keep' }).click();
  await colour(page, 'Bark');
  for (const stroke of STEM) await pen.draw(stroke);
  await page.getByRole('button', { name: 'Keep' }).click();
  const pictures: PNG[] = [];
  for (const style of STYLES) {
    // A tap on the chosen style would open its settings.
    const radio = page.getByRole('radio', { name: style });
    if ((await radio.getAttribute('aria-checked')) !== 'true') await radio.click();
    const { png } = await takePicture(page);
    const cut = crop(PNG.sync.read(png), 230, 66, 340, 440);
    writeFileSync(`${OUT}/pear-${style.toLowerCase()}.png`, PNG.sync.write(cut));
    pictures.push(cut);
  }
  writeFileSync(`${OUT}/pear.png`, PNG.sync.write(beside([pictures[0]!, pictures[1]!, pictures[2]!])));
});

/** CSS pixels. */
function crop(from: PNG, ...box: readonly [x: number, y: number, width: number, height: number]): PNG {
  const [x, y, width, height] = box.map((value) => Math.round(value * RATIO)) as [
    number,
    number,
    number,
    number,
  ];
  const to = new PNG({ width, height });
  PNG.bitblt(from, to, x, y, width, height, 0, 0);
  return to;
}

function beside(pictures: readonly PNG[]): PNG {
  const width = pictures.reduce((sum, picture) => sum + picture.width, 0);
  const to = new PNG({ width, height: pictures[0]!.height });
  let x = 0;
  for (const picture of pictures) {
    PNG.bitblt(picture, to, 0, 0, picture.width, picture.height, x, 0);
    x += picture.width;
  }
  return to;
}
