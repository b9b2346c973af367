/** The card of a surface: its finish and its detail, set live, one undo step each. */
import { expect, type Page, test } from '@playwright/test';

async function open(page: Page): Promise<void> {
  await page.goto('/');
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', /WebG/);
  await page.evaluate(() => {
    const { session } = document.querySelector('rotund-sketch')!;
    const plane = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] } as const;
    const view = { pivot: [0, 0, 0], rotation: [0, 0, 0, 1], height: 200, fov: 0 } as const;
    for (const side of [-1, 1]) {
      const samples = Array.from({ length: 60 }, (_, i) => {
        const angle = (Math.PI * i) / 59;
        const [x, y] = [side * 30 * Math.sin(angle), 30 * Math.cos(angle)];
        return { x, y, pressure: 0.5, tiltX: 0, tiltY: 0, time: 8 * i };
      });
      session.run({ type: 'addStroke', stroke: { samples, plane, view, pointer: 'pen', closed: false } });
    }
    session.keep();
    session.setTool('select');
    session.select(session.document.parts.map(({ id }) => id));
  });
  await page.getByRole('button', { name: /^Parts/ }).click();
}

const part = (page: Page) =>
  page.evaluate(() => {
    const [first] = document.querySelector('rotund-sketch')!.session.document.parts;
    if (!first || !('brush' in first)) throw new Error('no surface');
    return { finish: first.brush.finish, colour: first.brush.colour, detail: first.detail };
  });

test('a sphere sets the finish and keeps the colour; a drag of Shine is one undo step', async ({ page }) => {
  await open(page);
  const before = await part(page);
  await page.getByText('More light').click();
  await page.getByRole('radio', { name: 'Gloss' }).click();
  const gloss = await part(page);
  expect(gloss.finish.specular).toBeGreaterThan(before.finish.specular);
  expect(gloss.colour).toBe(before.colour);

  const shine = page.getByRole('slider', { name: /^Shine of/ });
  await shine.scrollIntoViewIfNeeded();
  const box = (await shine.boundingBox())!;
  await page.mouse.move(box.x + box.width * 0.8, box.y + box.height / 2);
  await page.mouse.down();
  for (const share of [0.6, 0.4, 0.2])
    await page.mouse.move(box.x + box.width * share, box.y + box.height / 2);
  // only shown until the hand lets go
  expect((await part(page)).finish).toEqual(gloss.finish);
  await page.mouse.up();
  const dull = await part(page);
  expect(dull.finish.specular).toBeLessThan(0.4);
  expect(dull.finish.shininess).toBe(gloss.finish.shininess);
  await page.getByRole('button', { name: 'Undo' }).click();
  expect((await part(page)).finish).toEqual(gloss.finish);
});

test('detail goes by steps, rows and columns by the editor, and the strokes stay', async ({ page }) => {
  await open(page);
  const before = await part(page);
  await page.getByRole('button', { name: 'Finer' }).click();
  expect((await part(page)).detail).toMatchObject({ u: before.detail.u + 1, v: before.detail.v + 1 });
  await page.getByText('Edit detail').click();
  await page.getByRole('switch', { name: 'As many rows as it needs' }).click();
  const rows = page.getByRole('slider', { name: /^Rows of/ });
  await rows.focus();
  await page.keyboard.press('ArrowRight');
  expect((await part(page)).detail.rows).toBeGreaterThan(16);
});
