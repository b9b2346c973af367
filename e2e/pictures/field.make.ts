/** The field page as docs/fields.md shows it. */
import { expect, test } from '@playwright/test';

test('the field page', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 720 });
  await page.goto('/field.html#resolution=96');
  await expect(page.getByRole('status')).toHaveText('Body made', { timeout: 60_000 });
  await expect(page.getByText('Preparing the picture')).toBeHidden();
  await page.evaluate(() => new Promise((done) => setTimeout(done, 1500)));
  await page.screenshot({ path: 'docs/pictures/field.png' });
});
