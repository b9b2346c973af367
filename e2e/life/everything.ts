/** Every style and every tool in the hand, for the back ends that are not the first choice. */
import { expect, type Page } from '@playwright/test';
import type { PenDriver } from '../pen.ts';
import {
  darkest,
  difference,
  drawVase,
  LEFT,
  ON_FORM,
  ON_PAPER,
  saturation,
  shown,
  strokes,
  TUBE,
} from './life.ts';

/** Keys of the styles; what the middle of a yellow form must look like in each, and its left outline. */
const STYLES = [
  { key: '2', lines: true, filled: false },
  { key: '3', lines: true, filled: false },
  { key: '4', lines: true, filled: true },
  { key: '1', lines: true, filled: true },
] as const;

export async function everyStyleAndTool(page: Page, pen: PenDriver): Promise<void> {
  await drawVase(page, pen);
  const pictures = [];
  for (const { key, lines, filled } of STYLES) {
    await page.keyboard.press(key);
    const picture = await shown(page);
    pictures.push(picture);
    const name = `style ${key}`;
    expect(saturation(picture, ON_FORM) > 60, `${name} fills`).toBe(filled);
    const middle = LEFT[12]!;
    if (lines) expect(darkest(picture, middle, 4), `${name} draws a line`).toBeLessThan(0.6);
    expect(darkest(picture, ON_PAPER, 4), `${name} leaves paper bare`).toBeGreaterThan(0.85);
  }
  for (const [i, picture] of pictures.entries()) {
    for (const other of pictures.slice(i + 1)) expect(difference(picture, other)).toBeGreaterThan(0.005);
  }
  await everyTool(page, pen);
}

async function everyTool(page: Page, pen: PenDriver): Promise<void> {
  const before = await shown(page);
  await pen.draw(TUBE);
  expect(await strokes(page)).toEqual({ parts: 1, draft: 1, wet: false });
  await page.keyboard.press('Escape');
  expect(difference(before, await shown(page))).toBe(0);
  await page.evaluate(() => document.querySelector('rotund-sketch')!.session.setTool('select'));
  await pen.down(ON_FORM);
  await pen.up(ON_FORM);
  await expect
    .poll(() => page.evaluate(() => document.querySelector('rotund-sketch')!.selection.length))
    .toBe(1);
  await page.evaluate(() => document.querySelector('rotund-sketch')!.session.setTool('draw'));
  expect(difference(before, await shown(page))).toBe(0);
  const { width, height } = await page.evaluate(async () => {
    const picture = await document.querySelector('rotund-sketch')!.picture({ width: 120, height: 90 });
    const bitmap = await createImageBitmap(picture);
    return { width: bitmap.width, height: bitmap.height };
  });
  expect([width, height]).toEqual([120, 90]);
  await page.keyboard.press('u');
  expect(await strokes(page), 'the dropped stroke is back').toEqual({ parts: 1, draft: 1, wet: false });
}
