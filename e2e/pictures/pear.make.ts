/** The application while the pear is being drawn with a pen: the body is a preview, its strokes are its contour. */
import { mkdirSync } from 'node:fs';
import { expect, test } from '@playwright/test';
import { BODY } from '../pear.ts';
import { PenDriver } from '../pen.ts';

const OUT = 'docs/pictures';

/** Device pixels a CSS pixel: sharp enough for a page, small enough for a repository. */
test.use({ deviceScaleFactor: 1.5 });

test('a pear, half drawn', async ({ page }) => {
  mkdirSync(OUT, { recursive: true });
  await page.goto('/?quality=fine');
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', /WebG/);
  const pen = await PenDriver.on(page);
  for (const stroke of BODY) await pen.draw(stroke);
  await page.screenshot({ path: `${OUT}/drawing.png` });
});
