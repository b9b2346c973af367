/** Bending, redrawing and recreating a form, with pen, mouse and touch. */
import { expect, type Page, test } from '@playwright/test';
import { PenDriver, type Point } from '../pen.ts';

type Sketch = HTMLElementTagNameMap['rotund-sketch'];

/** A round form between two bows, and which point of the page is its middle. */
async function open(page: Page): Promise<Point> {
  await page.goto('/');
  const sketch = page.locator('rotund-sketch');
  await expect(sketch).toHaveAttribute('data-backend', /WebG/);
  await sketch.evaluate((element: Sketch) => {
    for (const side of [-1, 1]) {
      const samples = Array.from({ length: 41 }, (_, i) => ({
        x: side * 25 * Math.sin((i * Math.PI) / 40),
        y: 50 - 2.5 * i,
        pressure: 0.5,
        tiltX: 0,
        tiltY: 0,
        time: 8 * i,
      }));
      const plane = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] } as const;
      const stroke = { samples, plane, view: element.session.view, pointer: 'pen', closed: false } as const;
      element.session.run({ type: 'addStroke', stroke });
    }
    element.session.run({ type: 'keep' });
  });
  await page.locator('rotund-sketch .stage').focus();
  const box = (await sketch.boundingBox())!;
  return [box.x + box.width / 2, box.y + box.height / 2];
}

const part = (page: Page) =>
  page.evaluate(() => {
    const [first] = document.querySelector('rotund-sketch')!.document.parts;
    return first && 'bends' in first ? first : null;
  });

const still = (page: Page) =>
  page.waitForFunction(() => !document.querySelector('rotund-sketch')!.session.scene?.rig.moving);

const view = (page: Page) => page.evaluate(() => document.querySelector('rotund-sketch')!.session.view);

const bow = ([x, y]: Point): Point[] =>
  Array.from({ length: 21 }, (_, i) => [x + 4 * i * (i / 20), y + 150 - 15 * i]);

for (const pointer of ['pen', 'mouse'] as const)
  test(`bends from the side and back, with ${pointer}`, async ({ page }) => {
    const middle = await open(page);
    const home = await view(page);
    await page.keyboard.press('b');
    await expect(page.getByRole('status')).toContainText('Draw the new centre line');
    await still(page);
    expect((await view(page)).rotation).not.toEqual(home.rotation);
    const pen = await PenDriver.on(page, pointer);
    await pen.draw(bow(middle));
    const card = page.getByRole('group', { name: 'Bend' });
    await expect(card).toContainText('bent');
    await card.getByRole('radio', { name: 'Stretched' }).click();
    expect((await part(page))!.bends).toMatchObject([{ keepsLength: false }]);
    await card.getByRole('button', { name: 'Keep' }).click();
    await still(page);
    expect(await view(page)).toEqual(home);
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    expect((await part(page))!.bends).toHaveLength(0);
  });

test('Escape drops a bend and brings the camera back', async ({ page }) => {
  const middle = await open(page);
  const home = await view(page);
  await page.keyboard.press('b');
  await still(page);
  const pen = await PenDriver.on(page);
  await pen.draw(bow(middle));
  expect((await part(page))!.bends).toHaveLength(1);
  await page.keyboard.press('Escape');
  await still(page);
  expect((await part(page))!.bends).toHaveLength(0);
  expect(await view(page)).toEqual(home);
});

test('a section is lit where the pen hovers, and drawn over', async ({ page }) => {
  const [x, y] = await open(page);
  await page.keyboard.press('o');
  await page.mouse.move(x, y + 2);
  const card = page.getByRole('group', { name: 'Redraw' });
  await expect(card).toContainText('Draw over');
  await page.locator('rotund-sketch').evaluate((element: Sketch) => element.session.camera.orbit(0, 90));
  await page.mouse.move(x + 2, y + 4);
  await expect(card).toContainText('lit section');
  const pen = await PenDriver.on(page);
  const stroke = Array.from(
    { length: 15 },
    (_, i): Point => [x - 42 + 6 * i, y + 60 + 3 * Math.min(i, 14 - i)],
  );
  await pen.draw(stroke);
  expect(await part(page)).toMatchObject({ kind: 'crossSection', back: 'front' });
  await page.keyboard.press('Control+z');
  expect(await part(page)).toMatchObject({ kind: 'rotational' });
});

test('strokes are in hand again where the part was drawn from, and go one by one', async ({ page }) => {
  await open(page);
  const home = await view(page);
  await page.locator('rotund-sketch').evaluate((element: Sketch) => {
    element.session.camera.orbit(120, 40);
    element.session.setTool('select');
    element.session.select(['part-1']);
  });
  await page.getByRole('button', { name: 'Recreate' }).click();
  await still(page);
  const { rotation } = await view(page);
  for (const [i, q] of rotation.entries()) expect(q).toBeCloseTo(home.rotation[i]!, 6);
  await page.getByRole('button', { name: 'Remove stroke 2' }).click();
  await page.getByRole('button', { name: 'Keep' }).click();
  expect(await part(page)).toMatchObject({ kind: 'tube', id: 'part-1' });
});

async function drawWithFinger(page: Page, points: readonly Point[]): Promise<void> {
  const session = await page.context().newCDPSession(page);
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', at?: Point) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: at ? [{ x: at[0], y: at[1] }] : [] });
  await touch('touchStart', points[0]);
  for (const at of points.slice(1)) await touch('touchMove', at);
  await touch('touchEnd');
}

/** Across the middle, below it: over the near half of the section there. */
const across = ([x, y]: Point): Point[] =>
  Array.from({ length: 15 }, (_, i) => [x - 42 + 6 * i, y + 60 + 3 * Math.min(i, 14 - i)]);

const seenFromAbove = (page: Page) =>
  page.locator('rotund-sketch').evaluate((element: Sketch) => {
    element.session.camera.orbit(0, 90);
  });

test('a mouse redraws, too', async ({ page }) => {
  const middle = await open(page);
  await seenFromAbove(page);
  await still(page);
  await page.keyboard.press('o');
  const mouse = await PenDriver.on(page, 'mouse');
  await mouse.draw(across(middle));
  await expect.poll(async () => (await part(page))!.kind).toBe('crossSection');
});

test('the other end of the pen redraws once, and the tool in hand is the one before', async ({ page }) => {
  const middle = await open(page);
  await seenFromAbove(page);
  await still(page);
  const before = await page.evaluate(() => document.querySelector('rotund-sketch')!.session.tool);
  const points = across(middle);
  await page.locator('rotund-sketch .stage').evaluate((stage, places) => {
    const send = (type: string, [clientX, clientY]: readonly [number, number], buttons: number) =>
      stage.dispatchEvent(
        new PointerEvent(type, {
          pointerId: 7,
          pointerType: 'pen',
          isPrimary: true,
          bubbles: true,
          composed: true,
          cancelable: true,
          clientX,
          clientY,
          pressure: buttons ? 0.5 : 0,
          button: type === 'pointermove' ? -1 : 5,
          buttons,
        }),
      );
    // no such pointer is known to the browser
    stage.setPointerCapture = () => {};
    send('pointerdown', places[0]!, 32);
    for (const place of places.slice(1)) send('pointermove', place, 32);
    send('pointerup', places.at(-1)!, 0);
  }, points);
  await expect.poll(async () => (await part(page))!.kind).toBe('crossSection');
  expect(await page.evaluate(() => document.querySelector('rotund-sketch')!.session.tool)).toBe(before);
});

test.describe('with a finger', () => {
  test.use({ hasTouch: true });
  test('bends', async ({ page }) => {
    const middle = await open(page);
    await page.keyboard.press('b');
    await still(page);
    await drawWithFinger(page, bow(middle));
    await expect.poll(async () => (await part(page))!.bends.length).toBe(1);
  });

  test('redraws', async ({ page }) => {
    const middle = await open(page);
    await seenFromAbove(page);
    await still(page);
    await page.keyboard.press('o');
    await drawWithFinger(page, across(middle));
    await expect.poll(async () => (await part(page))!.kind).toBe('crossSection');
  });

  test('takes strokes in hand again, and one of them away', async ({ page }) => {
    await open(page);
    await page.locator('rotund-sketch').evaluate((element: Sketch) => {
      element.session.setTool('select');
      element.session.select(['part-1']);
    });
    await page.getByRole('button', { name: 'Recreate' }).tap();
    await page.getByRole('button', { name: 'Remove stroke 2' }).tap();
    await page.getByRole('button', { name: 'Keep' }).tap();
    expect(await part(page)).toMatchObject({ kind: 'tube', id: 'part-1' });
  });
});
