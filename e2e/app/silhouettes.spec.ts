/** Closed outlines in the hand: solids while they are drawn, holes, chips, what they start on, crossings, points. */
import AxeBuilder from '@axe-core/playwright';
import { expect, type Page, test } from '@playwright/test';
import { PenDriver, type Point } from '../pen.ts';

const ringAt = (x: number, y: number, rx: number, ry = rx, from = -1.2): Point[] =>
  Array.from({ length: 60 }, (_, i) => {
    const angle = from + (i / 60) * 2 * Math.PI;
    return [x + rx * Math.cos(angle), y + ry * Math.sin(angle)];
  });

const BODY = ringAt(400, 330, 130, 110);
const HOLE = ringAt(400, 330, 45);
const HEAD = ringAt(400, 190, 70, 70, 1.4);

async function open(page: Page): Promise<void> {
  await page.goto('/');
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', /WebG/);
}

const drawing = (page: Page) =>
  page.evaluate(() => {
    const { parts, draft } = document.querySelector('rotund-sketch')!.document;
    const groups = parts.map((part) =>
      part.kind === 'solid' ? part.components.map(({ groups }) => groups.map(({ form }) => form)) : part.kind,
    );
    return { groups, strokes: draft?.strokes.length ?? 0, form: draft?.form, joins: draft?.joins };
  });

/** Vertices, edges and faces of what is seen: V − E + F, which is 2 − 2 × holes. */
const euler = (page: Page) =>
  page.evaluate(async () => {
    const sketch = document.querySelector('rotund-sketch')!;
    await sketch.session.bodies.settled();
    const [file] = await sketch.export('obj');
    const text = new TextDecoder().decode(file!.bytes);
    const vertices = text.split('\n').filter((line) => line.startsWith('v ')).length;
    const faces = text.split('\n').filter((line) => line.startsWith('f ')).length;
    return vertices - faces / 2;
  });

test('an outline with a hole: to a plate and back, kept, undone, redone', async ({ page }) => {
  await open(page);
  const pen = await PenDriver.on(page);
  await pen.trace(BODY);
  await expect(page.getByRole('status')).toContainText('Soft solid, preview');
  await expect
    .poll(() => page.evaluate(() => document.querySelector('rotund-sketch')!.session.scene!.triangles), {
      message: 'it is seen before the pen is lifted',
    })
    .toBeGreaterThan(500);
  await pen.up(BODY.at(-1)!);
  await pen.draw(HOLE);
  expect(await drawing(page)).toMatchObject({ groups: [], strokes: 2 });
  const chip = page.getByRole('group', { name: 'Soft solid, preview' });
  await expect(chip).toContainText('1 hole');
  await expect(chip.getByRole('radio', { name: 'Soft' })).toBeChecked();
  await chip.getByRole('radio', { name: 'Plate' }).click();
  await expect(page.getByRole('status')).toContainText('Plate, preview');
  expect(await drawing(page)).toMatchObject({ form: 'plate', strokes: 2 });
  await page.getByRole('radio', { name: 'Plate' }).press('ArrowLeft');
  await expect(page.getByRole('radio', { name: 'Soft' })).toBeChecked();
  await page.keyboard.press('n');
  expect(await drawing(page)).toEqual({ groups: [[['soft']]], strokes: 0 });
  expect(await euler(page)).toBe(0);
  await page.keyboard.press('u');
  expect(await drawing(page)).toMatchObject({ groups: [], strokes: 2, form: 'soft' });
  // forms that were tried one after the other are one step
  await page.keyboard.press('u');
  await page.keyboard.press('u');
  expect(await drawing(page)).toMatchObject({ strokes: 1 });
  for (let i = 0; i < 3; i++) await page.keyboard.press('Shift+Z');
  expect(await drawing(page)).toEqual({ groups: [[['soft']]], strokes: 0 });
});

test('what starts on a solid joins it: blends, sits on it, or is a part of its own', async ({ page }) => {
  await open(page);
  const pen = await PenDriver.on(page);
  await pen.draw(BODY);
  await page.keyboard.press('n');
  await page.evaluate(() => document.querySelector('rotund-sketch')!.session.bodies.settled());
  await page.evaluate(() => new Promise(requestAnimationFrame));
  await pen.draw(HEAD);
  await expect(page.getByRole('status')).toContainText('Soft solid, preview. Joins Solid 1');
  const how = page.getByRole('radiogroup', { name: 'How it goes with Solid 1' });
  await expect(how.getByRole('radio', { name: 'Blend' })).toBeChecked();
  await how.getByRole('radio', { name: 'Attach' }).click();
  expect((await drawing(page)).joins).toMatchObject({ component: null });
  await how.getByRole('radio', { name: 'Apart' }).click();
  expect((await drawing(page)).joins).toBeUndefined();
  await how.getByRole('radio', { name: 'Blend' }).click();
  const { violations } = await new AxeBuilder({ page }).include('rotund-sketch').analyze();
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target)}`)).toEqual([]);
  await page.getByRole('radio', { name: 'Carve' }).click();
  await expect(page.getByRole('status')).toContainText('Takes away from Solid 1');
  await page.getByRole('radio', { name: 'Soft' }).click();
  await page.getByRole('button', { name: 'Keep' }).click();
  await expect(page.getByRole('status')).toContainText('Soft solid added to Solid 1');
  expect((await drawing(page)).groups).toEqual([[['soft', 'soft']]]);
  expect(await euler(page)).toBe(2);
});

test('pulled away it is left open; Escape takes the stroke and then all of the form', async ({ page }) => {
  await open(page);
  const pen = await PenDriver.on(page);
  await pen.trace(BODY);
  await expect(page.getByRole('status')).toContainText('Soft solid, preview');
  await pen.move([600, 100]);
  await expect(page.getByRole('status')).toContainText('Tube, preview');
  await page.keyboard.press('Escape');
  await pen.up([600, 100]);
  expect(await drawing(page)).toMatchObject({ groups: [], strokes: 0 });
  await pen.draw(BODY);
  await pen.draw(HOLE);
  await page.getByRole('button', { name: 'Leave it open: tube' }).click();
  expect(await drawing(page)).toMatchObject({ form: 'tube', strokes: 2 });
  await page.keyboard.press('Escape');
  expect(await drawing(page)).toMatchObject({ groups: [], strokes: 0 });
});

test('an outline that crosses itself is told of, and nothing of it is lost', async ({ page }) => {
  await open(page);
  const pen = await PenDriver.on(page);
  const eight = Array.from({ length: 90 }, (_, i): Point => {
    const angle = 0.5 + (i / 90) * 2 * Math.PI;
    return [400 + 150 * Math.sin(angle), 320 + 90 * Math.sin(2 * angle)];
  });
  await pen.draw(eight);
  const notice = page.getByRole('alert');
  await expect(notice).toContainText('The outline crosses itself.');
  await notice.getByRole('button', { name: 'Join the parts' }).click();
  await expect(notice).toBeHidden();
  expect(await drawing(page)).toMatchObject({ strokes: 1 });
  await page.keyboard.press('Escape');
  await pen.draw(eight);
  await notice.getByRole('button', { name: 'Redraw' }).click();
  expect(await drawing(page)).toMatchObject({ strokes: 0 });
});

test('a tap offers a point', async ({ page }) => {
  await open(page);
  const pen = await PenDriver.on(page);
  await pen.draw([
    [400, 300],
    [401, 300],
  ]);
  await page.getByRole('alert').getByRole('button', { name: 'Point' }).click();
  await expect(page.getByRole('group', { name: 'Point, preview' })).toContainText('6 mm radius');
  await page.keyboard.press('n');
  expect((await drawing(page)).groups).toEqual([[['point']]]);
});
