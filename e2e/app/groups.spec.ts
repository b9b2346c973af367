/** What solids are made of, in the hand: the tree of the list, drags between components, the card, mirror and clipboard, each one undo step. */
import AxeBuilder from '@axe-core/playwright';
import { expect, type Locator, type Page, test } from '@playwright/test';
import { isSolid } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { middleOfParts, seenParts } from '../../src/document/extent.ts';
import { serialize } from '../../src/document/serialize.ts';
import { figure } from '../../tests/document/figure.ts';
import { PenDriver, type Point } from '../pen.ts';

const TEXT = serialize({ ...EMPTY_DRAWING, name: 'Figure', document: figure() });

async function open(page: Page): Promise<void> {
  await page.goto('/');
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', /WebG/);
  await page.evaluate((text) => document.querySelector('rotund-sketch')!.load(text), TEXT);
  await expect
    .poll(() => page.evaluate(() => document.querySelector('rotund-sketch')!.session.bodies.making === null))
    .toBe(true);
  await page.getByRole('button', { name: 'Parts, 2' }).click();
}

interface Facts {
  /** names of the groups, a list a component, those of a part after each other */
  readonly made: readonly (readonly string[])[][];
  readonly selection: readonly string[];
  readonly steps: number;
  readonly said: string;
}

async function facts(page: Page): Promise<Facts> {
  const { parts, selection, steps, said } = await page.evaluate(() => {
    const { session } = document.querySelector('rotund-sketch')!;
    const { selection, said } = session;
    return { parts: session.document.parts, selection, steps: session.history.past.length, said };
  });
  const made = parts
    .filter(isSolid)
    .map(({ components }) => components.map(({ groups }) => groups.map(({ name }) => name)));
  return { made, selection, steps, said };
}

const row = (page: Page, name: string): Locator => page.getByRole('row', { name: new RegExp(`^${name},`) });

async function middleOf(page: Page, name: string): Promise<readonly number[]> {
  const document = await page.evaluate(
    () => window.document.querySelector('rotund-sketch')!.session.document,
  );
  const groups = document.parts
    .filter(isSolid)
    .flatMap(({ components }) => components.flatMap((c) => c.groups));
  return middleOfParts(seenParts(document, [groups.find((group) => group.name === name)!.id]))!;
}

async function unfold(page: Page): Promise<void> {
  await page.getByRole('treegrid').focus();
  await page.keyboard.press('ArrowRight');
  await expect(row(page, 'Ear')).toBeVisible();
}

async function carry(page: Page, from: Locator, to: Locator, at = 0.5): Promise<() => Promise<void>> {
  const [a, b] = [(await from.boundingBox())!, (await to.boundingBox())!];
  await page.mouse.move(a.x + 60, a.y + a.height / 2);
  await page.mouse.down();
  for (let i = 1; i <= 4; i++)
    await page.mouse.move(
      a.x + 60,
      a.y + a.height / 2 + ((b.y + at * b.height - a.y - a.height / 2) * i) / 4,
    );
  return () => page.mouse.up();
}

test.beforeEach(async ({ page }) => {
  await page.setViewportSize({ width: 1200, height: 900 });
  await page.emulateMedia({ reducedMotion: 'reduce' });
});

test('the tree: keys open, go in and out, and close; what is selected in it has words', async ({ page }) => {
  await open(page);
  const solid = page.getByRole('row').first();
  await expect(solid).toHaveAttribute('aria-expanded', 'false');
  await unfold(page);
  await expect(solid).toHaveAttribute('aria-expanded', 'true');
  await expect(row(page, 'Ear')).toHaveAttribute('aria-level', '3');
  await expect(page.getByRole('row')).toHaveCount(8);
  for (let i = 0; i < 4; i++) await page.keyboard.press('ArrowDown');
  await expect(row(page, 'Ear')).toHaveAttribute('aria-selected', 'true');
  expect((await facts(page)).said).toMatch(/^Ear of .+ selected$/);
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowLeft');
  await expect(row(page, 'Ear')).toHaveCount(0);
  await page
    .getByRole('button', { name: /^Hide what/ })
    .first()
    .click();
  await expect(page.getByRole('row')).toHaveCount(2);
  await page.locator('.stage').focus();
  expect((await facts(page)).selection).toHaveLength(1);
});

test('a group is hidden, named and deleted as parts are', async ({ page }) => {
  await open(page);
  await unfold(page);
  await page.getByRole('button', { name: 'Hide Ear' }).click();
  expect((await facts(page)).said).toBe('Ear hidden');
  await page.getByRole('button', { name: 'Show Ear' }).click();
  await row(page, 'Ear').click();
  await page.getByRole('textbox', { name: 'Name' }).fill('Left ear');
  await page.keyboard.press('Enter');
  await expect(row(page, 'Left ear')).toBeVisible();
  await page.keyboard.press('Delete');
  expect((await facts(page)).said).toBe('Left ear deleted. Undo brings it back');
  expect((await facts(page)).made[0]).toEqual([['Body', 'Head'], ['Eye']]);
  await page.keyboard.press('Control+z');
  expect((await facts(page)).made[0]).toEqual([['Body', 'Head', 'Left ear'], ['Eye']]);
});

test('a row dropped on a form blends with it, on a solid it is attached, below all it is on its own', async ({
  page,
}) => {
  await open(page);
  await unfold(page);
  const before = await facts(page);
  const at = await middleOf(page, 'Eye');
  const drop = await carry(page, row(page, 'Eye'), row(page, 'Head'));
  await expect(page.locator('.drag-tag')).toHaveText('Blend with Head');
  await page.keyboard.press('Escape');
  await expect(page.locator('.drag-tag')).toHaveCount(0);
  await drop();
  expect(await facts(page)).toEqual({ ...before, selection: expect.anything(), said: expect.anything() });

  await (await carry(page, row(page, 'Eye'), row(page, 'Head')))();
  expect((await facts(page)).made[0]).toEqual([['Body', 'Head', 'Ear', 'Eye']]);
  expect((await facts(page)).steps).toBe(before.steps + 1);
  await (await carry(page, row(page, 'Ear'), page.getByRole('row').first()))();
  expect((await facts(page)).made[0]).toEqual([['Body', 'Head', 'Eye'], ['Ear']]);
  // below the last row, which opens under a hand that is slow
  await (await carry(page, row(page, 'Ear'), page.getByRole('row').last(), 1.3))();
  expect((await facts(page)).made).toHaveLength(3);
  expect((await facts(page)).made).toContainEqual([['Ear']]);
  for (const [i, value] of (await middleOf(page, 'Eye')).entries()) expect(value).toBeCloseTo(at[i]!, 9);
  for (let i = 0; i < 3; i++) await page.keyboard.press('Control+z');
  expect((await facts(page)).made).toEqual(before.made);
});

test('a finger drags after it rested on a row, and scrolls before', async ({ page }) => {
  await open(page);
  await unfold(page);
  const [eye, head] = [(await row(page, 'Eye').boundingBox())!, (await row(page, 'Head').boundingBox())!];
  const cdp = await page.context().newCDPSession(page);
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', y: number) =>
    cdp.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: type === 'touchEnd' ? [] : [{ x: eye.x + 80, y }],
    });
  const middle = (box: { y: number; height: number }) => box.y + box.height / 2;
  await touch('touchStart', middle(eye));
  await expect(page.locator('.part-list')).toHaveClass(/dragging/);
  for (const part of [0.3, 0.6, 1])
    await touch('touchMove', middle(eye) + part * (middle(head) - middle(eye)));
  await expect(row(page, 'Head')).toHaveAttribute('data-drop', 'on');
  await touch('touchEnd', 0);
  expect((await facts(page)).made[0]).toEqual([['Body', 'Head', 'Ear', 'Eye']]);
});

test('the card: form, depth, kernel, threshold and place, each one undo step', async ({ page }) => {
  await open(page);
  await unfold(page);
  await row(page, 'Ear').click();
  const { steps } = await facts(page);
  await page.getByRole('radio', { name: 'Ring' }).click();
  await expect(row(page, 'Ear')).toContainText('Ring');
  const depth = page.getByRole('slider', { name: 'Depth of Ear' });
  await depth.focus();
  await page.keyboard.press('ArrowRight');
  await page.getByRole('radio', { name: 'Extrusion' }).click();
  await expect(page.getByRole('slider', { name: 'Corners of Ear' })).toBeVisible();
  await page.getByRole('combobox', { name: 'Kernel of Ear' }).selectOption('quartic');
  await page.getByRole('combobox', { name: 'Belongs to' }).selectOption('On its own');
  const after = await facts(page);
  expect(after.steps).toBe(steps + 5);
  expect(after.made).toHaveLength(3);
  const ear = await page.evaluate(() => {
    const { session } = document.querySelector('rotund-sketch')!;
    const part = session.document.parts.at(-1)!;
    return part.kind === 'solid' ? part.components[0]! : null;
  });
  expect(ear!.kernel).toBe('quartic');
  expect(ear!.groups[0]!.shape.depth).toBeGreaterThan(1);
  for (let i = 0; i < 5; i++) await page.keyboard.press('Control+z');
  expect((await facts(page)).made).toHaveLength(2);
  await expect(row(page, 'Ear')).toContainText('Soft');
});

test('a drag of the depth is only shown until it ends', async ({ page }) => {
  await open(page);
  await unfold(page);
  await row(page, 'Ear').click();
  const { steps } = await facts(page);
  const slider = page.getByRole('slider', { name: 'Depth of Ear' });
  await slider.scrollIntoViewIfNeeded();
  const box = (await slider.boundingBox())!;
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  for (let i = 1; i <= 4; i++)
    await page.mouse.move(box.x + box.width * (0.5 + 0.05 * i), box.y + box.height / 2);
  expect((await facts(page)).steps).toBe(steps);
  await expect(slider).not.toHaveAttribute('aria-valuetext', '100 %');
  await page.mouse.up();
  expect((await facts(page)).steps).toBe(steps + 1);
});

test('a second tap takes the group under the pen, Escape goes up; the ring turns and scales it', async ({
  page,
}) => {
  await open(page);
  await page.getByRole('button', { name: 'Close' }).click();
  await page.getByRole('button', { name: 'Select', exact: true }).click();
  const pen = await PenDriver.on(page);
  const tap = async (at: Point) => {
    await pen.down(at);
    await pen.up(at);
  };
  const on: Point = await page.evaluate(() => {
    const { session } = document.querySelector('rotund-sketch')!;
    const { width, height } = session.size;
    for (let y = 0; y < height; y += 4) {
      const hit = session.pick(width / 2 - 20, y);
      if (hit?.id === 'part-1') return [width / 2 - 20, y + 12] as const;
    }
    throw new Error('nothing is there');
  });
  await tap(on);
  expect((await facts(page)).selection).toEqual(['part-1']);
  // the second tap is none of a double tap
  await page.evaluate(() => new Promise((done) => setTimeout(done, 450)));
  await tap(on);
  const { selection, said } = await facts(page);
  expect(selection[0]).toMatch(/^group-/);
  const name = said.split(' of ')[0]!;
  const { steps } = await facts(page);
  const middle = await middleOf(page, name);
  for (const [handle, key] of [
    ['Turn about', 'Shift+ArrowUp'],
    ['Make it larger', 'Shift+ArrowUp'],
  ] as const) {
    await page.getByRole('button', { name: new RegExp(`^${handle}`) }).focus();
    await page.keyboard.press(key);
  }
  expect((await facts(page)).steps).toBe(steps + 2);
  for (const [i, value] of (await middleOf(page, name)).entries()) expect(value).toBeCloseTo(middle[i]!, 6);
  const knob = (await page.getByRole('button', { name: /^Turn about/ }).boundingBox())!;
  await page.mouse.move(knob.x + 20, knob.y + 20);
  await page.mouse.down();
  await page.mouse.move(knob.x, knob.y + 40);
  await page.mouse.move(knob.x - 40, knob.y + 60);
  await expect(page.locator('.value-tag')).toHaveText(/^−?\d+°$/);
  await page.mouse.up();
  expect((await facts(page)).steps).toBe(steps + 3);
  await page.locator('.stage').focus();
  await page.keyboard.press('Escape');
  expect((await facts(page)).selection).toEqual(['part-1']);
  await page.keyboard.press('Escape');
  expect((await facts(page)).selection).toEqual([]);
});

test('mirror copy, duplicate, copy, cut and paste', async ({ page }) => {
  await open(page);
  await unfold(page);
  await row(page, 'Ear').click();
  const { steps } = await facts(page);
  await page.getByRole('button', { name: 'Mirror copy' }).click();
  expect((await facts(page)).made[0]![0]).toEqual(['Body', 'Head', 'Ear', 'Ear 2']);
  expect((await middleOf(page, 'Ear 2'))[0]).toBeCloseTo(14, 6);
  await page.keyboard.press('Shift+M');
  expect((await middleOf(page, 'Ear 2'))[0]).toBeCloseTo(-14, 6);
  await page.keyboard.press('Control+d');
  expect((await facts(page)).made[0]![0]).toHaveLength(5);
  expect((await facts(page)).steps).toBe(steps + 3);
  await page.keyboard.press('Control+c');
  expect((await facts(page)).said).toMatch(/copied$/);
  await page.keyboard.press('Control+x');
  expect((await facts(page)).made[0]![0]).toEqual(['Body', 'Head', 'Ear', 'Ear 2']);
  await page.keyboard.press('Control+v');
  const after = await facts(page);
  expect(after.made).toHaveLength(3);
  expect(after.made[2]).toEqual([['Ear 3']]);
  expect(after.steps).toBe(steps + 5);
});

for (const colorScheme of ['light', 'dark'] as const)
  test(`tree, card and ring are accessible and large enough, ${colorScheme}`, async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce', colorScheme });
    await open(page);
    await unfold(page);
    await row(page, 'Ear').click();
    const { violations } = await new AxeBuilder({ page }).analyze();
    const told = violations.flatMap(({ id, nodes }) =>
      nodes.map(({ target, failureSummary }) => `${id}: ${target} ${failureSummary}`),
    );
    expect(told).toEqual([]);
    for (const [width, height] of [
      [1280, 900],
      [390, 844],
    ] as const) {
      await page.setViewportSize({ width, height });
      const small = await page.evaluate(() => {
        const all = document
          .querySelector('rotund-sketch')!
          .shadowRoot!.querySelectorAll('button, input, select');
        const boxes = [...all].map(
          (b) => [b.getAttribute('aria-label') ?? b.textContent, b.getBoundingClientRect()] as const,
        );
        return boxes
          .filter(([, { width: w, height: h }]) => w > 0 && (w < 43.5 || h < 43.5))
          .map(([name]) => name);
      });
      expect(small).toEqual([]);
    }
  });
