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

test('rows of bends: length, eye, away, one undo step each', async ({ page }) => {
  await open(page);
  await page.evaluate(() => {
    const { session } = document.querySelector('rotund-sketch')!;
    const plane = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] } as const;
    const samples = Array.from({ length: 30 }, (_, i) => ({
      x: 0.02 * i * i,
      y: 30 - 2 * i,
      pressure: 0.5,
      tiltX: 0,
      tiltY: 0,
      time: 8 * i,
    }));
    const stroke = { samples, plane, view: session.view, pointer: 'pen', closed: false } as const;
    const bend = { stroke, keepsLength: true, isOff: false };
    session.run({ type: 'bend', id: session.document.parts[0]!.id, bend });
  });
  const bends = () =>
    page.evaluate(() => {
      const [first] = document.querySelector('rotund-sketch')!.session.document.parts;
      return first && 'bends' in first
        ? first.bends.map(({ keepsLength, isOff }) => [keepsLength, isOff])
        : [];
    });
  const length = page.getByRole('button', { name: /^Length kept, Bend 1/ });
  await expect(length).toHaveAttribute('aria-pressed', 'true');
  await length.click();
  await expect(length).toHaveAttribute('aria-pressed', 'false');
  expect((await length.boundingBox())!.height).toBeGreaterThanOrEqual(44);
  expect(await bends()).toEqual([[false, false]]);
  await page.getByRole('button', { name: 'Leave out Bend 1' }).click();
  expect(await bends()).toEqual([[false, true]]);
  await page.getByRole('button', { name: 'Put Bend 1 in force' }).click();
  await page.getByRole('button', { name: 'Remove Bend 1' }).click();
  expect(await bends()).toEqual([]);
  await page.getByRole('button', { name: 'Undo' }).click();
  expect(await bends()).toEqual([[false, false]]);
});

test('the radius of a tube is drawn', async ({ page }) => {
  await open(page);
  const before = await page.evaluate(
    () => document.querySelector('rotund-sketch')!.session.document.brush.radius,
  );
  await page.evaluate(() => document.querySelector('rotund-sketch')!.session.setTool('draw'));
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: /draw the radius/ }).click();
  const box = (await page.locator('rotund-sketch').boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x - 60, y);
  await page.mouse.down();
  for (let i = 1; i <= 8; i++) await page.mouse.move(x - 60 + 5 * i, y);
  await page.mouse.up();
  const after = await page.evaluate(() => {
    const { session } = document.querySelector('rotund-sketch')!;
    return { radius: session.document.brush.radius, mm: (40 * session.view.height) / session.size.height };
  });
  expect(after.radius).not.toBe(before);
  expect(Math.abs(after.radius - after.mm)).toBeLessThan(0.5);
  await page.keyboard.press('Control+z');
  expect(
    await page.evaluate(() => document.querySelector('rotund-sketch')!.session.document.brush.radius),
  ).toBe(before);
});

test('what a surface can become fits phones, names beside each other', async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: 'Close' }).click();
  for (const width of [390, 320]) {
    await page.setViewportSize({ width, height: 700 });
    const off = () =>
      page.evaluate(() => {
        const root = document.querySelector('rotund-sketch')!.shadowRoot!;
        const bar = root.querySelector('.acts')!.getBoundingClientRect();
        const names = [...root.querySelectorAll('.acts .name')]
          .map((name) => name.getBoundingClientRect())
          .filter((box) => box.width > 0);
        return names.filter(
          ({ left, right }, i) =>
            left < bar.left || right > bar.right || (i > 0 && left < names[i - 1]!.right + 2),
        ).length;
      });
    await expect.poll(off).toBe(0);
    for (const name of ['Bend', 'Redraw'])
      await expect(page.getByRole('button', { name, exact: true }).filter({ visible: true })).toHaveCount(1);
  }
});

test('no handle lies in the way while a radius is drawn', async ({ page }) => {
  await open(page);
  await expect(page.locator('.gizmo')).toHaveCount(1);
  await page.evaluate(() => {
    const { session } = document.querySelector('rotund-sketch')!;
    const [form] = session.document.parts;
    if (!form || !('brush' in form)) throw new Error('no surface');
    session.setTool('draw');
    session.run({ type: 'addStroke', stroke: form.strokes[0]! });
    session.keep();
    session.setTool('select');
    session.select([session.document.parts.at(-1)!.id]);
  });
  await expect(page.locator('.gizmo')).toHaveCount(1);
  await page.getByRole('button', { name: 'Draw it' }).click();
  await expect(page.locator('.gizmo')).toHaveCount(0);
  await page.locator('rotund-sketch .stage').focus();
  await page.keyboard.press('Escape');
  await expect(page.locator('.gizmo')).toHaveCount(1);
});
