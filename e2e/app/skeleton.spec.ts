/** The skeleton of a form in the hand: shown, dragged, split, deleted, undone; profiles. */
import AxeBuilder from '@axe-core/playwright';
import { expect, type Page, test } from '@playwright/test';

async function open(page: Page, form: string): Promise<void> {
  await page.goto('/');
  const sketch = page.locator('rotund-sketch');
  await expect(sketch).toHaveAttribute('data-backend', /WebG/);
  await sketch.evaluate((element: HTMLElementTagNameMap['rotund-sketch'], wanted) => {
    const samples = Array.from({ length: 41 }, (_, i) =>
      wanted === 'plate' || wanted === 'ring'
        ? { x: 45 * Math.cos((i * Math.PI) / 20), y: 35 * Math.sin((i * Math.PI) / 20) }
        : { x: 3 * i - 60, y: 20 * Math.sin(i / 6) },
    ).map((at, i) => ({ ...at, pressure: 0.5, tiltX: 0, tiltY: 0, time: 8 * i }));
    const plane = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] } as const;
    const closed = wanted === 'plate' || wanted === 'ring';
    const stroke = { samples, plane, view: element.session.view, pointer: 'pen', closed } as const;
    element.session.run({ type: 'addStroke', stroke, form: wanted as 'line' });
    element.session.run({ type: 'keep' });
    element.session.setTool('select');
    element.session.select(['part-1']);
  }, form);
}

const skeleton = (page: Page) =>
  page.evaluate(() => {
    const [part] = document.querySelector('rotund-sketch')!.document.parts;
    return part?.kind === 'solid' ? part.components[0]!.groups[0]!.skeleton : null;
  });

test('a node of a line is dragged, a link split, a node deleted; each is one step', async ({ page }) => {
  await open(page, 'line');
  await page.locator('rotund-sketch .stage').focus();
  await page.keyboard.press('k');
  const overlay = page.getByRole('group', { name: /^Skeleton of/ });
  await expect(overlay).toBeVisible();
  await expect(page.getByRole('status')).toContainText('Skeleton of Line');
  const joints = overlay.locator('.joint');
  const count = await joints.count();
  const box = (await joints.first().boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20, y + 40, { steps: 4 });
  await page.mouse.move(x + 20, y + 60);
  await page.mouse.up();
  const dragged = (await skeleton(page))!;
  expect(dragged.nodes).toHaveLength(count);
  const button = page.getByRole('button', { name: `Node 1 of ${count}` });
  await expect(button).toBeFocused();
  await page.keyboard.press('ArrowRight');
  expect((await skeleton(page))!.nodes[0]!.at[0]).toBeCloseTo(dragged.nodes[0]!.at[0] + 1, 6);
  await page.keyboard.press('Enter');
  expect((await skeleton(page))!.nodes).toHaveLength(count + 1);
  await page.keyboard.press('Delete');
  expect((await skeleton(page))!.nodes).toHaveLength(count);
  for (let i = 0; i < 4; i++) await page.keyboard.press('Control+z');
  expect(await skeleton(page)).toBeNull();
  // a neighbour of the deleted node is chosen: first that is let go of
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  await expect(overlay).toBeHidden();
});

test('the thickness of a curve is drawn along it', async ({ page }) => {
  await open(page, 'curve');
  await page.getByRole('button', { name: /^Parts/ }).click();
  const profile = page.getByRole('group', { name: /^Profile of/ });
  const middle = profile.getByRole('slider').nth(2);
  await middle.scrollIntoViewIfNeeded();
  const box = (await middle.boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y - 20, { steps: 3 });
  await page.mouse.up();
  const found = () =>
    page.evaluate(() => {
      const [part] = document.querySelector('rotund-sketch')!.document.parts;
      return part?.kind === 'solid' ? part.components[0]!.groups[0]!.shape.profile : [];
    });
  const drawn = await found();
  expect(drawn).toHaveLength(5);
  expect(drawn[2]).toBeGreaterThan(1.2);
  await middle.focus();
  await page.keyboard.press('Home');
  expect((await found())[2]).toBe(1);
  await page.keyboard.press('Control+z');
  expect(await found()).toEqual(drawn);
});

test('axe finds nothing in a skeleton and a profile', async ({ page }) => {
  await open(page, 'ring');
  await page.locator('rotund-sketch .stage').focus();
  await page.keyboard.press('k');
  await page.getByRole('button', { name: /^Parts/ }).click();
  const { violations } = await new AxeBuilder({ page }).include('rotund-sketch').analyze();
  expect(violations).toEqual([]);
});
