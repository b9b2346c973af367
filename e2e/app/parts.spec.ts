/** Parts in the hand: selected, named, coloured, hidden, moved, slid and deleted, with pen, fingers, mouse and keys. */
import AxeBuilder from '@axe-core/playwright';
import { expect, type Page, test } from '@playwright/test';
import { colourOf } from '../../src/document/document.ts';
import { middleOf } from '../../src/document/extent.ts';
import { PenDriver, type Point } from '../pen.ts';
import { takePicture } from '../picture.ts';

/** The picture is 600 px for 200 mm, its middle the origin. */
const PX = 3;
const RADIUS = 30;
const EYE: Point = [400 + 12 * PX, 300 - 9 * PX];

/** A ball of 30 mm around the origin and an eye of 6 mm on its surface, as kept parts. */
async function open(page: Page, address = '/'): Promise<void> {
  await page.goto(address);
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', /WebG/);
  await page.evaluate(
    ({ radius, eye }) => {
      const { session } = document.querySelector('rotund-sketch')!;
      const plane = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] } as const;
      const view = { pivot: [0, 0, 0], rotation: [0, 0, 0, 1], height: 200, fov: 0 } as const;
      const ball = (r: number, name: string, colour: string) => {
        session.setBrush({ colour });
        for (const side of [-1, 1]) {
          const samples = Array.from({ length: 60 }, (_, i) => {
            const angle = (Math.PI * i) / 59;
            const [x, y] = [side * r * Math.sin(angle), r * Math.cos(angle)];
            return { x, y, pressure: 0.5, tiltX: 0, tiltY: 0, time: 8 * i };
          });
          session.run({ type: 'addStroke', stroke: { samples, plane, view, pointer: 'pen', closed: false } });
        }
        session.keep();
        session.run({ type: 'renamePart', id: session.document.parts.at(-1)!.id, name });
      };
      ball(radius, 'Ball', '#d9cb4a');
      ball(6, 'Eye', '#c8402f');
      const [x, y] = [eye[0] - 400, 300 - eye[1]].map((px) => px / 3);
      const z = Math.sqrt(radius * radius - x! * x! - y! * y!);
      const by = { rotation: [0, 0, 0, 1], translation: [x!, y!, z] } as const;
      session.run({ type: 'moveParts', ids: ['part-2'], by });
    },
    { radius: RADIUS, eye: EYE },
  );
}

interface Facts {
  readonly names: readonly string[];
  readonly hidden: readonly boolean[];
  readonly colours: readonly (string | null)[];
  readonly selection: readonly string[];
  /** of the parts' boxes, mm */
  readonly middles: readonly (readonly number[])[];
  readonly steps: number;
}

async function facts(page: Page): Promise<Facts> {
  const { parts, selection, steps } = await page.evaluate(() => {
    const { session } = document.querySelector('rotund-sketch')!;
    return {
      parts: session.document.parts,
      selection: session.selection,
      steps: session.history.past.length,
    };
  });
  return {
    names: parts.map(({ name }) => name),
    hidden: parts.map(({ hidden }) => hidden),
    colours: parts.map(colourOf),
    selection,
    middles: parts.map((part) => middleOf(part)!),
    steps,
  };
}

const tap = async (page: Page, [x, y]: Point) => {
  const pen = await PenDriver.on(page);
  await pen.down([x, y]);
  await pen.up([x, y]);
};

const select = (page: Page) => page.getByRole('button', { name: 'Select', exact: true }).click();

async function drag(page: Page, name: string, by: Point): Promise<() => Promise<void>> {
  const box = (await page.getByRole('button', { name }).boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 5; i++) await page.mouse.move(x + (by[0] * i) / 5, y + (by[1] * i) / 5);
  return () => page.mouse.up();
}

/** Pixels of the blue pencil of light paper. */
async function pencil(page: Page): Promise<number> {
  const picture = await takePicture(page);
  let count = 0;
  for (let y = 0; y < picture.height; y++)
    for (let x = 0; x < picture.width; x++) {
      const [r, g, b] = picture.at(x, y);
      if (Math.max(Math.abs(r - 0x2b), Math.abs(g - 0x59), Math.abs(b - 0xc3)) < 16) count++;
    }
  return count;
}

for (const address of ['/', '/?backend=webgl2']) {
  test(`a tap selects, with a blue contour; a tap on the paper lets go: ${address}`, async ({ page }) => {
    await open(page, address);
    expect(await pencil(page)).toBe(0);
    const draws = () =>
      page.evaluate(() => document.querySelector('rotund-sketch')!.session.scene!.drawCalls);
    const before = await draws();
    await select(page);
    await tap(page, [330, 330]);
    expect((await facts(page)).selection).toEqual(['part-1']);
    await expect(page.getByRole('status')).toContainText('Ball selected, 1 of 2');
    // All around the ball, some 3 px wide, of which the middle is of full colour.
    const around = 2 * Math.PI * RADIUS * PX;
    const blue = await pencil(page);
    expect(blue).toBeGreaterThan(around);
    expect(blue).toBeLessThan(4 * around);
    await tap(page, EYE);
    expect((await facts(page)).selection).toEqual(['part-2']);
    await tap(page, [700, 200]);
    await expect(page.getByRole('status')).toContainText('Nothing selected');
    expect(await pencil(page)).toBe(0);
    expect(await draws()).toBe(before);
  });
}

test('the list selects, deletes and hides; undo brings back', async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: 'Parts, 2' }).click();
  const eye = page.getByRole('row', { name: /^Eye/ });
  await eye.click();
  await expect(eye).toHaveAttribute('aria-selected', 'true');
  await page.getByRole('row', { name: /^Ball/ }).click({ modifiers: ['Shift'] });
  await expect(page.getByRole('status')).toContainText('2 parts selected');
  await eye.click();
  await page.getByRole('button', { name: 'Hide Eye' }).click();
  expect((await facts(page)).hidden).toEqual([false, true]);
  await expect(page.getByRole('status')).toContainText('Eye hidden');
  const [r, g] = (await takePicture(page)).at(...EYE);
  // The ball's yellow, no longer the eye's red.
  expect(g).toBeGreaterThan(0.6 * r);
  await page.getByRole('button', { name: 'Show Eye' }).click();
  await page.getByRole('button', { name: 'Delete' }).click();
  expect((await facts(page)).names).toEqual(['Ball']);
  await expect(page.getByRole('status')).toContainText('Eye deleted. Undo brings it back');
  await page.getByRole('button', { name: 'Undo' }).click();
  expect((await facts(page)).names).toEqual(['Ball', 'Eye']);
});

test('a name is text, whatever it looks like; Enter renames, Escape does not', async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: 'Parts, 2' }).click();
  await page.getByRole('row', { name: /^Eye/ }).click();
  const { steps } = await facts(page);
  const field = page.getByRole('textbox', { name: 'Name' });
  await field.fill('no');
  await page.keyboard.press('Escape');
  await expect(field).toHaveValue('Eye');
  const wild = '<img src=x onerror=alert(1)> & "so"';
  await field.fill(wild);
  await page.keyboard.press('Enter');
  const after = await facts(page);
  expect(after.names[1]).toBe(wild);
  expect(after.steps).toBe(steps + 1);
  const row = page.getByRole('row', { name: wild });
  await expect(row.locator('b')).toHaveText(wild);
  expect(await page.locator('rotund-sketch img').count()).toBe(0);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(field).toHaveValue('Eye');
});

test('colour and radius of what is selected; a drag of the slider is one undo step', async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: 'Parts, 2' }).click();
  await page.getByRole('row', { name: /^Eye/ }).click();
  await page.getByRole('row', { name: /^Ball/ }).click({ modifiers: ['Control'] });
  await page.getByRole('radio', { name: 'Leaf' }).click();
  expect((await facts(page)).colours).toEqual(['#5f9e46', '#5f9e46']);
  await page.getByRole('button', { name: 'Undo' }).click();
  expect((await facts(page)).colours).toEqual(['#d9cb4a', '#c8402f']);
  await page.evaluate(() => {
    const { session } = document.querySelector('rotund-sketch')!;
    const [part] = session.document.parts;
    if (part?.kind === 'tube' || part?.kind === 'rotational')
      session.run({ type: 'addStroke', stroke: part.strokes[0]! });
    session.keep();
  });
  await page.getByRole('row', { name: /^Tube/ }).click();
  const { steps } = await facts(page);
  const radius = () =>
    page.evaluate(() => {
      const part = document.querySelector('rotund-sketch')!.document.parts[2];
      return part?.kind === 'tube' ? part.brush.radius : 0;
    });
  const before = await radius();
  const slider = page.getByRole('slider', { name: /^Radius of/ });
  await slider.scrollIntoViewIfNeeded();
  const box = (await slider.boundingBox())!;
  await page.mouse.move(box.x + box.width * 0.52, box.y + box.height / 2);
  await page.mouse.down();
  for (let i = 1; i <= 5; i++)
    await page.mouse.move(box.x + box.width * (0.52 + 0.05 * i), box.y + box.height / 2);
  expect(await radius()).toBe(before);
  await page.mouse.up();
  expect(await radius()).toBeGreaterThan(before);
  expect((await facts(page)).steps).toBe(steps + 1);
});

test('the square moves a part by the dragged pixels, as one undo step; Escape in mid-drag puts it back', async ({
  page,
}) => {
  await open(page);
  await select(page);
  await tap(page, EYE);
  const before = await facts(page);
  const drop = await drag(page, 'Move in the view plane', [150, 60]);
  await page.keyboard.press('Escape');
  await drop();
  expect(await facts(page)).toEqual(before);

  await (await drag(page, 'Move in the view plane', [150, 60]))();
  const after = await facts(page);
  expect(after.steps).toBe(before.steps + 1);
  const [a, b] = [before.middles[1]!, after.middles[1]!];
  expect(Math.abs((b[0]! - a[0]!) * PX - 150)).toBeLessThan(1);
  expect(Math.abs((a[1]! - b[1]!) * PX - 60)).toBeLessThan(1);
  expect(b[2]).toBeCloseTo(a[2]!, 6);
  // And it is really there: red where it was dragged to.
  const [r, g] = (await takePicture(page)).at(EYE[0] + 150, EYE[1] + 60);
  expect(r).toBeGreaterThan(2 * g);
  await page.getByRole('button', { name: 'Undo' }).click();
  expect((await facts(page)).middles).toEqual(before.middles);
});

test('the keys still answer when what had the focus is gone', async ({ page }) => {
  await open(page);
  await select(page);
  await page.keyboard.press('Control+a');
  await page.locator('.acts').getByRole('button', { name: 'Delete' }).click();
  expect((await facts(page)).names).toEqual([]);
  await page.keyboard.press('Control+z');
  expect((await facts(page)).names).toHaveLength(2);
  await page.keyboard.press('Control+a');
  await page.getByRole('button', { name: 'Move in the view plane' }).focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Delete');
  expect((await facts(page)).names).toEqual([]);
  await page.keyboard.press('Control+z');
  expect((await facts(page)).names).toHaveLength(2);
});

test('a handle dragged out of the picture is still in the hand, and lets go there', async ({ page }) => {
  await open(page);
  await select(page);
  await tap(page, EYE);
  const before = await facts(page);
  const drop = await drag(page, 'Move in the view plane', [500, 0]);
  expect(
    await page.evaluate(() => Boolean(document.querySelector('rotund-sketch')!.session.state.carried)),
  ).toBe(true);
  await drop();
  const after = await facts(page);
  expect(after.steps).toBe(before.steps + 1);
  expect(
    await page.evaluate(() => Boolean(document.querySelector('rotund-sketch')!.session.state.carried)),
  ).toBe(false);
  await page.keyboard.press('Control+z');
  expect((await facts(page)).middles).toEqual(before.middles);
});

test('an eye slides over a ball: it stays on it and looks out', async ({ page }) => {
  await open(page);
  await select(page);
  await tap(page, EYE);
  const before = await facts(page);
  await (await drag(page, 'Slide over the surface', [-75, 45]))();
  const after = await facts(page);
  expect(after.steps).toBe(before.steps + 1);
  const at = after.middles[1]!;
  expect((at[0]! - before.middles[1]![0]!) * PX).toBeCloseTo(-75, 0);
  // A mesh of 64 × 64 lies up to a tenth of a millimetre inside the ball.
  expect(Math.abs(Math.hypot(...at) - RADIUS)).toBeLessThan(0.2);
  const turned = await page.evaluate(
    () => document.querySelector('rotund-sketch')!.document.parts[1]!.placement.rotation,
  );
  const between = (a: readonly number[], b: readonly number[]) =>
    Math.acos(a.reduce((sum, value, i) => sum + value * b[i]!, 0) / (Math.hypot(...a) * Math.hypot(...b)));
  expect(2 * Math.acos(Math.abs(turned[3]))).toBeCloseTo(between(before.middles[1]!, at), 1);
  await page.getByRole('button', { name: 'Undo' }).click();
  expect((await facts(page)).middles).toEqual(before.middles);
});

test('a drag from a part moves it at once, and one over the paper takes what it goes around', async ({
  page,
}) => {
  await open(page);
  await select(page);
  const pen = await PenDriver.on(page);
  await pen.draw(Array.from({ length: 9 }, (_, i) => [EYE[0] + 20 * i, EYE[1]] as const));
  const moved = await facts(page);
  expect(moved.selection).toEqual(['part-2']);
  expect(moved.middles[1]![0]).toBeCloseTo(12 + 160 / PX, 3);
  await tap(page, [700, 500]);
  await pen.draw(Array.from({ length: 9 }, (_, i) => [280 + 30 * i, 180 + 30 * i] as const));
  expect((await facts(page)).selection).toEqual(['part-1']);
  await pen.draw(Array.from({ length: 9 }, (_, i) => [280 + 50 * i, 180 + 30 * i] as const));
  expect((await facts(page)).selection).toEqual(['part-1', 'part-2']);
  expect((await facts(page)).steps).toBe(moved.steps);
});

test('by keys alone: the list selects, a handle moves, Delete deletes, Escape lets go and then closes', async ({
  page,
}) => {
  await open(page);
  await page.getByRole('button', { name: 'Parts, 2' }).focus();
  await page.keyboard.press('Enter');
  await page.getByRole('treegrid').focus();
  await page.keyboard.press('ArrowDown');
  await expect(page.getByRole('row', { name: /^Eye/ })).toHaveAttribute('aria-selected', 'true');
  const before = await facts(page);
  await page.getByRole('button', { name: 'Move along X' }).focus();
  for (const key of ['ArrowRight', 'ArrowRight', 'Shift+ArrowRight']) await page.keyboard.press(key);
  const after = await facts(page);
  expect(after.middles[1]![0]! - before.middles[1]![0]!).toBeCloseTo(12, 6);
  expect(after.steps).toBe(before.steps + 3);
  // A key that stays down is one move.
  await page.keyboard.down('ArrowUp');
  await page.keyboard.down('ArrowUp');
  await page.keyboard.up('ArrowUp');
  expect((await facts(page)).steps).toBe(before.steps + 4);
  await page.locator('.stage').focus();
  await page.keyboard.press('Escape');
  expect((await facts(page)).selection).toEqual([]);
  await expect(page.getByRole('treegrid')).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(page.getByRole('treegrid')).toBeHidden();
  await page.keyboard.press('Control+a');
  await page.keyboard.press('h');
  expect((await facts(page)).hidden).toEqual([true, true]);
  await page.keyboard.press('h');
  await page.keyboard.press('Delete');
  expect((await facts(page)).names).toEqual([]);
  await page.keyboard.press('u');
  expect((await facts(page)).names).toEqual(['Ball', 'Eye']);
});

test('the actions duplicate and focus, and a drawing tool lets go', async ({ page }) => {
  await open(page);
  await select(page);
  await tap(page, EYE);
  await page.getByRole('button', { name: 'Duplicate' }).click();
  const copied = await facts(page);
  expect(copied.names).toEqual(['Ball', 'Eye', 'Eye 2']);
  expect(copied.selection).toEqual(['part-3']);
  await page.getByRole('button', { name: 'Focus' }).click();
  await expect
    .poll(() => page.evaluate(() => document.querySelector('rotund-sketch')!.session.view.height))
    .toBeLessThan(30);
  await page.getByRole('button', { name: 'Draw', exact: true }).click();
  expect((await facts(page)).selection).toEqual([]);
  await expect(page.getByRole('button', { name: 'Draw', exact: true })).toHaveAttribute(
    'aria-pressed',
    'true',
  );
});

test('once a pen was seen a finger still selects with a tap, and turns the view with a drag', async ({
  page,
}) => {
  await open(page);
  await select(page);
  await tap(page, [700, 200]);
  const session = await page.context().newCDPSession(page);
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: readonly Point[]) =>
    session.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: points.map(([x, y], id) => ({ x, y, id })),
    });
  await touch('touchStart', [EYE]);
  await touch('touchEnd', []);
  expect((await facts(page)).selection).toEqual(['part-2']);
  const view = () => page.evaluate(() => document.querySelector('rotund-sketch')!.session.view.rotation);
  const before = await view();
  await touch('touchStart', [[330, 330]]);
  for (let x = 330; x < 400; x += 10) await touch('touchMove', [[x, 330]]);
  await touch('touchEnd', []);
  expect(await view()).not.toEqual(before);
  expect((await facts(page)).selection).toEqual(['part-2']);
});

test('two strokes in one place are no part: the chip says so and offers the ways on', async ({ page }) => {
  await page.goto('/');
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', /WebG/);
  const pen = await PenDriver.on(page);
  const stroke: readonly Point[] = Array.from({ length: 30 }, (_, i) => [300, 180 + 8 * i]);
  await pen.draw(stroke);
  await expect(page.locator('.stage')).toHaveAttribute('aria-label', /unfinished form of 1 stroke$/);
  await pen.draw(stroke);
  const chip = page.getByRole('group', { name: 'Rotational surface, preview' });
  await expect(chip).toContainText('encloses nothing');
  await page.keyboard.press('n');
  expect((await facts(page)).names).toEqual([]);
  await expect(page.getByRole('status')).toContainText('nothing to keep');
  await page.getByRole('button', { name: 'Two tubes' }).click();
  await page.getByRole('button', { name: 'Keep' }).click();
  expect((await facts(page)).names).toHaveLength(2);
});

for (const [theme, media] of Object.entries({
  light: {},
  dark: { colorScheme: 'dark' },
  contrast: { contrast: 'more' },
} as const)) {
  test(`list, card, handles and actions are accessible and large enough, ${theme}`, async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce', ...media });
    await open(page);
    await page.getByRole('button', { name: 'Parts, 2' }).click();
    await page.getByRole('row', { name: /^Eye/ }).click();
    await page.getByRole('button', { name: 'Hide Ball' }).click();
    const { violations } = await new AxeBuilder({ page }).analyze();
    expect(
      violations.flatMap(({ id, nodes }) =>
        nodes.map(({ target, failureSummary }) => `${id}: ${target} ${failureSummary}`),
      ),
    ).toEqual([]);
    for (const [width, height] of [
      [1280, 900],
      [390, 844],
    ] as const) {
      await page.setViewportSize({ width, height });
      const small = await page.evaluate(() => {
        const all = document.querySelector('rotund-sketch')!.shadowRoot!.querySelectorAll('button, input');
        const boxes = [...all].map((b) => [b.getAttribute('aria-label'), b.getBoundingClientRect()] as const);
        return boxes
          .filter(([, { width: w, height: h }]) => w > 0 && (w < 43.5 || h < 43.5))
          .map(([name]) => name);
      });
      expect(small).toEqual([]);
    }
  });
}
