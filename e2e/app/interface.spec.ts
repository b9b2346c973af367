/** The interface in the hand: keys, fingers, cancel, panels, accessibility, the fallback. */
import AxeBuilder from '@axe-core/playwright';
import { expect, type Page, test } from '@playwright/test';
import { BODY } from '../pear.ts';
import { PenDriver, type Point } from '../pen.ts';
import { takePicture } from '../picture.ts';

const STROKE: readonly Point[] = Array.from({ length: 30 }, (_, i) => [300, 180 + 8 * i]);
const OTHER: readonly Point[] = STROKE.map(([x, y]) => [x + 160, y]);

async function open(page: Page, address = '/'): Promise<void> {
  await page.goto(address);
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', /WebG/);
}

const drawing = (page: Page) =>
  page.evaluate(() => {
    const { document: drawing, session } = document.querySelector('rotund-sketch')!;
    return {
      parts: drawing.parts.length,
      strokes: drawing.draft?.strokes.length ?? 0,
      brush: drawing.brush,
      view: session.view,
    };
  });

test('the hint steps aside for the first ink and comes back when the page is empty again', async ({
  page,
}) => {
  await open(page);
  const hint = page.getByRole('heading', { name: 'Draw a line, get a form.' });
  await expect(hint).toBeVisible();
  const pen = await PenDriver.on(page);
  await pen.draw(STROKE);
  await expect(hint).toBeHidden();
  await page.keyboard.press('Escape');
  await expect(hint).toBeVisible();
});

test('keep, drop and the meter', async ({ page }) => {
  await open(page);
  const pen = await PenDriver.on(page);
  await pen.draw(STROKE);
  await expect(page.getByRole('status')).toContainText('Tube, preview');
  await pen.draw(OTHER);
  await expect(page.getByRole('group', { name: 'Rotational surface, preview' })).toBeVisible();
  await page.getByRole('button', { name: '1 Tube' }).click();
  await expect(page.getByRole('group', { name: 'Tube, preview' })).toBeVisible();
  expect((await drawing(page)).strokes).toBe(2);
  await page.getByRole('button', { name: '2 Rotational' }).click();
  await page.getByRole('button', { name: 'Drop' }).click();
  expect(await drawing(page)).toMatchObject({ parts: 0, strokes: 0 });
  await page.getByRole('button', { name: 'Undo' }).click();
  expect((await drawing(page)).strokes).toBe(2);
  await page.locator('.stage').focus();
  await page.keyboard.press('n');
  expect(await drawing(page)).toMatchObject({ parts: 1, strokes: 0 });
});

test('Escape cancels the stroke under the pen, then drops the form', async ({ page }) => {
  await open(page);
  const pen = await PenDriver.on(page);
  await pen.draw(STROKE);
  await pen.trace(OTHER);
  await page.keyboard.press('Escape');
  expect(await drawing(page)).toMatchObject({ strokes: 1 });
  await pen.move([500, 500]);
  await pen.up([500, 500]);
  expect(await drawing(page)).toMatchObject({ strokes: 1 });
  await page.keyboard.press('Escape');
  expect(await drawing(page)).toMatchObject({ parts: 0, strokes: 0 });
});

test('the mouse draws with left, turns with right, zooms with the wheel; reset brings the front back', async ({
  page,
}) => {
  await open(page);
  const mouse = await PenDriver.on(page, 'mouse');
  await mouse.draw(STROKE);
  const before = await drawing(page);
  expect(before.strokes).toBe(1);
  await mouse.down([600, 300], 'right');
  for (let x = 600; x <= 680; x += 10) await mouse.move([x, 320], 0, 'right');
  await mouse.up([680, 320], 'right');
  const turned = await drawing(page);
  expect(turned.strokes).toBe(1);
  expect(turned.view.rotation).not.toEqual(before.view.rotation);
  await page.mouse.move(400, 300);
  await page.mouse.wheel(0, -300);
  expect((await drawing(page)).view.height).toBeLessThan(before.view.height);
  await page.keyboard.press('0');
  await expect(page.getByText('Front', { exact: true })).toBeVisible();
});

test('fingers draw until a pen is seen, then turn the view; two fingers cancel, a tap with two undoes', async ({
  page,
}) => {
  await open(page);
  const session = await page.context().newCDPSession(page);
  const touch = (
    type: 'touchStart' | 'touchMove' | 'touchEnd',
    points: readonly Point[],
    timestamp?: number,
  ) =>
    session.send('Input.dispatchTouchEvent', {
      type,
      ...(timestamp === undefined ? {} : { timestamp }),
      touchPoints: points.map(([x, y], id) => ({ x, y, id })),
    });
  // Sent without waiting for each answer: the browser coalesces what a frame cannot take.
  const swipe = async (points: readonly Point[]) => {
    await touch('touchStart', [points[0]!]);
    await Promise.all(points.map((point) => touch('touchMove', [point])));
    await touch('touchEnd', []);
  };
  await swipe(STROKE);
  expect((await drawing(page)).strokes).toBe(1);

  await touch('touchStart', [[350, 200]]);
  for (let y = 200; y < 300; y += 10) await touch('touchMove', [[350, y]]);
  await touch('touchStart', [
    [350, 300],
    [450, 300],
  ]);
  await touch('touchMove', [
    [340, 300],
    [470, 300],
  ]);
  await touch('touchEnd', []);
  expect((await drawing(page)).strokes).toBe(1);
  expect((await drawing(page)).view.height).toBeLessThan(200);

  // With times of its own: a frame of the software adapter takes longer than a tap.
  const tap: readonly Point[] = [
    [560, 160],
    [660, 160],
  ];
  const now = Date.now() / 1000;
  await touch('touchStart', tap, now);
  await touch('touchEnd', [], now + 0.1);
  await expect.poll(async () => (await drawing(page)).strokes).toBe(0);

  const pen = await PenDriver.on(page);
  await pen.draw(STROKE);
  const { view } = await drawing(page);
  await swipe(OTHER);
  const after = await drawing(page);
  expect(after.strokes).toBe(1);
  expect(after.view.rotation).not.toEqual(view.rotation);
});

test('a drag of the radius is one undo step, and Q steps it', async ({ page }) => {
  await open(page);
  const pen = await PenDriver.on(page);
  await pen.draw(STROKE);
  const { brush } = await drawing(page);
  const box = (await page.getByRole('slider', { name: 'Tube radius' }).boundingBox())!;
  await page.mouse.move(box.x + box.width / 2, box.y + box.height * 0.5);
  await page.mouse.down();
  for (let i = 1; i <= 5; i++)
    await page.mouse.move(box.x + box.width / 2, box.y + box.height * (0.5 - 0.06 * i));
  await page.mouse.up();
  const dragged = (await drawing(page)).brush.radius;
  expect(dragged).toBeGreaterThan(brush.radius);
  await page.locator('.stage').focus();
  await page.keyboard.press('u');
  expect((await drawing(page)).brush.radius).toBe(brush.radius);
  await page.keyboard.press('q');
  expect((await drawing(page)).brush.radius).toBe(brush.radius + 0.5);
  await page.keyboard.press('Shift+Q');
  expect((await drawing(page)).brush.radius).toBe(brush.radius);
});

test('a colour paints the form in preview and the next one, and can be undone', async ({ page }) => {
  await open(page);
  const pen = await PenDriver.on(page);
  await pen.draw(STROKE);
  await page.getByRole('toolbar').getByRole('button', { name: 'Colour' }).click();
  await page.getByRole('radio', { name: 'Leaf' }).click();
  expect((await drawing(page)).brush.colour).toBe('#5f9e46');
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Undo' }).click();
  expect((await drawing(page)).brush.colour).toBe('#d9cb4a');
  await expect(page.getByRole('status')).toContainText('Undone: colour');
});

test('a stroke that starts on a part lies at the depth of its surface', async ({ page }) => {
  await open(page);
  const pen = await PenDriver.on(page);
  for (const stroke of BODY) await pen.draw(stroke);
  await page.getByRole('button', { name: 'Keep' }).click();
  await pen.draw(STROKE.map(([x, y]) => [x + 100, y + 120]));
  const depth = await page.evaluate(
    () => document.querySelector('rotund-sketch')!.document.draft!.strokes[0]!.plane.origin[2],
  );
  // The body is some 70 mm wide there: its front lies about half of that before the pivot's plane.
  expect(depth).toBeGreaterThan(15);
  expect(depth).toBeLessThan(45);
});

const THEMES = {
  light: {},
  dark: { colorScheme: 'dark' },
  contrast: { contrast: 'more' },
} as const;

for (const [theme, media] of Object.entries(THEMES)) {
  test(`every panel is accessible, ${theme}`, async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce', ...media });
    await open(page);
    await expect(page.locator('rotund-sketch')).toHaveAttribute('data-theme', theme);
    const pen = await PenDriver.on(page);
    const check = async () => {
      const { violations } = await new AxeBuilder({ page }).analyze();
      const found = violations.flatMap(({ id, nodes }) =>
        nodes.map(({ target, failureSummary }) => `${id}: ${target} ${failureSummary}`),
      );
      expect(found).toEqual([]);
    };
    await check();
    await pen.draw(STROKE);
    await check();
    await page.getByRole('button', { name: 'Settings' }).click();
    await check();
    await page.keyboard.press('?');
    await check();
  });
}

test('every target is at least 44 px, also on a phone', async ({ page }) => {
  await open(page);
  const pen = await PenDriver.on(page);
  await pen.draw(STROKE);
  for (const size of [
    { width: 1180, height: 820 },
    { width: 800, height: 600 },
    { width: 390, height: 844 },
    { width: 320, height: 640 },
  ]) {
    await page.setViewportSize(size);
    await expect
      .poll(() =>
        page.evaluate(() => {
          const sketch = document.querySelector('rotund-sketch')!;
          const buttons = [...sketch.shadowRoot!.querySelectorAll('button, input')];
          const boxes = buttons.map((b) => ({
            name: b.getAttribute('aria-label') ?? b.textContent,
            box: b.getBoundingClientRect(),
          }));
          const shown = boxes.filter(({ box }) => box.width > 0);
          const small = shown
            .filter(({ box }) => box.width < 43.5 || box.height < 43.5)
            .map(({ name }) => `small: ${name}`);
          const { width, height } = sketch.getBoundingClientRect();
          const outside = shown
            .filter(
              ({ box }) =>
                box.left < -0.5 || box.top < -0.5 || box.right > width + 0.5 || box.bottom > height + 0.5,
            )
            .map(({ name }) => `outside: ${name}`);
          return [...small, ...outside];
        }),
      )
      .toEqual([]);
  }
});

test('tools lie between the top bar and the status line, whatever the height', async ({ page }) => {
  await open(page);
  for (const height of [760, 681, 680, 600, 561, 560, 420]) {
    await page.setViewportSize({ width: 800, height });
    const box = async (name: string) => (await page.locator(`[part="${name}"]`).boundingBox())!;
    const [bar, tools] = [await box('toolbar'), await box('tools')];
    expect(tools.y, `at ${height}`).toBeGreaterThanOrEqual(bar.y + bar.height);
    const status = await box('status');
    const beside = status.x >= tools.x + tools.width;
    if (!beside) expect(tools.y + tools.height, `at ${height}`).toBeLessThanOrEqual(status.y);
  }
});

test('without WebGPU three’s WebGL2 backend draws the same, and the status line says so', async ({
  page,
}) => {
  await open(page, '/?backend=webgl2');
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', 'WebGL2');
  const pen = await PenDriver.on(page);
  await pen.draw(STROKE);
  await pen.draw(OTHER);
  await page.getByRole('button', { name: 'Keep' }).click();
  await expect(page.locator('.status')).toContainText('WebGL2, slower');
  // there is no room for what is usual; this is not
  await page.setViewportSize({ width: 900, height: 700 });
  await expect(page.locator('.status .aside')).toBeVisible();
  expect((await drawing(page)).parts).toBe(1);
});

for (const moment of ['between strokes', 'in mid-stroke']) {
  test(`a lost device loses nothing, ${moment}`, async ({ page }) => {
    await open(page);
    const pen = await PenDriver.on(page);
    await pen.draw(STROKE);
    if (moment === 'in mid-stroke') await pen.trace(OTHER);
    await page.evaluate(async () => {
      const { session } = document.querySelector('rotund-sketch')!;
      const before = session.scene!;
      before.device!.destroy();
      await before.lost;
      const renewed = () => session.scene !== null && session.scene !== before;
      while (!renewed()) await new Promise(requestAnimationFrame);
    });
    await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', 'WebGPU');
    if (moment === 'in mid-stroke') await pen.up(OTHER.at(-1)!);
    else await pen.draw(OTHER);
    await expect.poll(async () => (await drawing(page)).strokes).toBe(2);
    await page.getByRole('button', { name: 'Keep' }).click();
    const picture = await takePicture(page);
    const [r, g, b] = picture.at(380, 300);
    expect(Math.max(r, g, b) - Math.min(r, g, b)).toBeGreaterThan(60);
  });
}
