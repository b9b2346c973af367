/** Sections across a form, with pen, finger and mouse: the guide, the card, the meter, a back, a patch. */
import { expect, type Page, test } from '@playwright/test';
import { draftSolids } from '../../src/document/build.ts';
import { topology } from '../../src/mesh/check.ts';
import { PenDriver, type Point } from '../pen.ts';

const line = (from: Point, to: Point, bulge: Point = [0, 0], steps = 24): Point[] =>
  Array.from({ length: steps + 1 }, (_, i) => {
    const t = i / steps;
    const out = 4 * t * (1 - t);
    return [
      from[0] + t * (to[0] - from[0]) + out * bulge[0],
      from[1] + t * (to[1] - from[1]) + out * bulge[1],
    ];
  });

/** Upwards, so that what bulges downwards is full. */
const LEFT = line([600, 560], [600, 160], [-110, 0]);
const RIGHT = line([600, 560], [600, 160], [110, 0]);
const ACROSS = line([492, 360], [708, 360], [0, 60]);

test.use({ viewport: { width: 1200, height: 720 } });

async function open(page: Page): Promise<void> {
  await page.goto('/');
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', /Web/);
  // what lies on the empty page is not under the pen
  await page.locator('rotund-sketch').evaluate((sketch) => sketch.removeAttribute('gallery'));
}

async function facts(page: Page) {
  const drawing = await page.evaluate(() => document.querySelector('rotund-sketch')!.document);
  const [solid] = draftSolids(drawing);
  return {
    kind: solid?.kind,
    sections: drawing.draft?.sections?.map(({ u }) => Math.round(100 * u)) ?? [],
    watertight: solid ? topology(solid.mesh).watertight : false,
    parts: drawing.parts.map(({ kind }) => kind),
  };
}

const said = (page: Page) => page.locator('.status');
const step = (page: Page, name: string) => page.locator('.meter').getByRole('button', { name });

test('a pen hovers, sees the guide, draws a section, a back and a second section', async ({ page }) => {
  await open(page);
  const pen = await PenDriver.on(page);
  await pen.draw(LEFT);
  await pen.draw(RIGHT);
  await step(page, '3 Section').click();
  await expect(page.getByRole('region', { name: 'Draw across' })).toBeVisible();
  await pen.move([494, 360], 0, 'none');
  await expect(said(page)).toContainText('Draw a section at 50 %');
  await pen.draw(ACROSS);
  await expect(step(page, '3 Section')).toHaveAttribute('aria-current', 'step');
  expect(await facts(page)).toMatchObject({ kind: 'crossSection', sections: [50], watertight: false });
  await page.getByRole('radio', { name: 'As front' }).click();
  expect((await facts(page)).watertight).toBe(true);
  await page.getByRole('radio', { name: 'Drawn' }).click();
  await pen.move([494, 360], 0, 'none');
  await expect(said(page)).toContainText('Draw the back at 50 %');
  await pen.draw(line([492, 360], [708, 360], [0, -20]));
  expect(await facts(page)).toMatchObject({ kind: 'crossSection', sections: [50], watertight: true });
  await pen.draw(line([519, 460], [681, 460], [0, 30]));
  expect((await facts(page)).kind).toBe('bspline');
  await expect(step(page, '4+ Patch')).toHaveAttribute('aria-current', 'step');
  await expect(page.getByRole('group', { name: 'Patch, preview, 2 sections' })).toBeVisible();
});

test('steps back and undo lose no stroke', async ({ page }) => {
  await open(page);
  const pen = await PenDriver.on(page);
  for (const stroke of [LEFT, RIGHT, ACROSS]) await pen.draw(stroke);
  expect(await facts(page)).toMatchObject({ kind: 'crossSection', parts: [] });
  await step(page, '2 Rotational').click();
  expect(await facts(page)).toMatchObject({ kind: 'rotational', sections: [50] });
  await step(page, '3 Section').click();
  expect((await facts(page)).kind).toBe('crossSection');
  // trying steps and coming back is nothing to undo
  for (const expected of ['rotational', 'tube']) {
    await page.getByRole('button', { name: 'Undo' }).click();
    expect((await facts(page)).kind).toBe(expected);
  }
});

test('a finger sees the guide where it touches; what ends outside is nothing', async ({ browser }) => {
  // many touches, each waited for: a busy machine is no failure
  test.setTimeout(180_000);
  const page = await browser.newPage({ hasTouch: true, viewport: { width: 1200, height: 720 } });
  await open(page);
  const session = await page.context().newCDPSession(page);
  const touch = async (points: readonly Point[], lift = true) => {
    const at = ([x, y]: Point) => ({ touchPoints: [{ x, y }] });
    await session.send('Input.dispatchTouchEvent', { type: 'touchStart', ...at(points[0]!) });
    for (const point of points.slice(1))
      await session.send('Input.dispatchTouchEvent', { type: 'touchMove', ...at(point) });
    if (lift) await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  };
  await touch(LEFT);
  await touch(RIGHT);
  await page.locator('.stage').focus();
  await page.keyboard.press('l');
  await touch([[494, 360]], false);
  await expect(said(page)).toContainText('Draw a section at 50 %');
  await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await touch(line([492, 360], [860, 360]));
  expect((await facts(page)).sections).toEqual([]);
  await expect(said(page)).toContainText('Draw a section at 50 %');
  await touch(ACROSS);
  expect((await facts(page)).sections).toEqual([50]);
  await page.close();
});

test('the mouse draws across a kept part, and is told what is missing', async ({ page }) => {
  await open(page);
  const mouse = await PenDriver.on(page, 'mouse');
  await page.locator('.stage').focus();
  await page.keyboard.press('l');
  await expect(said(page)).toContainText('Draw a tube or two sides first');
  await page.keyboard.press('d');
  await mouse.draw(LEFT);
  await mouse.draw(RIGHT);
  await page.keyboard.press('n');
  await page.keyboard.press('l');
  await mouse.draw(ACROSS);
  expect((await facts(page)).parts).toEqual(['crossSection']);
  await page.getByRole('button', { name: 'Undo' }).click();
  expect((await facts(page)).parts).toEqual(['rotational']);
});

for (const pointer of ['pen', 'mouse'] as const)
  test(`across a tube a stroke is its section, with ${pointer}`, async ({ page }) => {
    await open(page);
    const pen = await PenDriver.on(page, pointer);
    await pen.draw(LEFT);
    await page.locator('.stage').focus();
    await page.keyboard.press('l');
    await pen.move([490, 360], 0, 'none');
    await expect(said(page)).toContainText('Draw a section at 50 %');
    await pen.draw(line([470, 360], [512, 360], [0, 14]));
    expect(await facts(page)).toMatchObject({ kind: 'crossSection', sections: [50] });
    await page.getByRole('button', { name: 'Undo' }).click();
    expect((await facts(page)).kind).toBe('tube');
  });

test.describe('on the smallest phone', () => {
  test.use({ viewport: { width: 320, height: 640 }, hasTouch: true });

  test('drop and keep are in one row, the view ball is clear, nothing is cut off', async ({ page }) => {
    await open(page);
    // a pen would be greeted by a notice
    const pen = await PenDriver.on(page, 'mouse');
    await pen.draw(line([70, 260], [230, 260]));
    const box = async (selector: string) => (await page.locator(selector).boundingBox())!;
    const finger = async () => {
      const [rail, toggle] = [await box('.rail'), await box('.rail .toggle')];
      expect(toggle.x + toggle.width).toBeLessThanOrEqual(rail.x + rail.width);
    };
    await finger();
    await step(page, '3 Section').click();
    await pen.draw(line([150, 230], [150, 290], [20, 0]));
    await expect(page.locator('.chip')).toContainText('Tube with a section');
    await finger();
    const drop = await box('.chip [aria-label="Drop"]');
    const keep = await box('.chip .primary');
    expect(Math.abs(drop.y + drop.height / 2 - keep.y - keep.height / 2)).toBeLessThan(1);
    const [ball, chip] = [await box('.view'), await box('.chip')];
    expect(ball.y + ball.height).toBeLessThanOrEqual(chip.y);
    const [pill, word] = [await box('.meter [aria-current]'), await box('.meter [aria-current] .long')];
    expect(word.x + word.width).toBeLessThanOrEqual(pill.x + pill.width - 6);
  });
});
