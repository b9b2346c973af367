/** What the tests of the scene's life share: a small application, a small drawing, and pictures told apart by numbers. */
import { expect, type Page } from '@playwright/test';
import { PenDriver, type Point } from '../pen.ts';
import { type Picture, takePicture } from '../picture.ts';

export const VIEWPORT = { width: 400, height: 480 };

/** Two sides of a vase, and a line that makes a tube, below the controls and between them. */
const side = (x: number, bow: number): readonly Point[] =>
  Array.from({ length: 24 }, (_, i) => [x + bow * Math.sin((Math.PI * i) / 23), 140 + 6 * i]);
export const LEFT = side(170, -20);
export const RIGHT = side(230, 20);
export const TUBE = side(300, 0);
/** on the vase, and on bare paper */
export const ON_FORM: Point = [200, 220];
export const ON_PAPER: Point = [120, 150];

/** Errors of the page: what nobody caught, and what was reported as an error. */
export function listen(page: Page): readonly string[] {
  const errors: string[] = [];
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  page.on('pageerror', (error) => errors.push(String(error)));
  return errors;
}

/** Lost and found again, a device makes no sound; a file that is not there does. */
export const serious = (errors: readonly string[]): readonly string[] =>
  errors.filter((text) => !text.includes('Failed to load resource'));

export async function open(
  page: Page,
  backend: 'WebGPU' | 'WebGL2' | 'none',
  address = '/',
): Promise<PenDriver> {
  await page.goto(address);
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', backend);
  return PenDriver.on(page);
}

/** A kept vase of two strokes. */
export async function drawVase(page: Page, pen: PenDriver): Promise<void> {
  await pen.draw(LEFT);
  await pen.draw(RIGHT);
  await page.locator('.stage').focus();
  await page.keyboard.press('n');
  expect(await strokes(page)).toEqual({ parts: 1, draft: 0, wet: false });
}

export const strokes = (page: Page) =>
  page.evaluate(() => {
    const { document: drawing, session } = document.querySelector('rotund-sketch')!;
    const draft = drawing.draft?.strokes.length ?? 0;
    return { parts: drawing.parts.length, draft, wet: Boolean(session.state.wet) };
  });

export type Shown = Awaited<ReturnType<typeof takePicture>>;

export const shown = (page: Page): Promise<Shown> => takePicture(page);

/** Share of pixels that differ by more than a step of 255 that eyes would not see. */
export function difference(one: Picture, other: Picture): number {
  expect([one.width, one.height]).toEqual([other.width, other.height]);
  let count = 0;
  for (let y = 0; y < one.height; y++) {
    for (let x = 0; x < one.width; x++) {
      const there = other.at(x, y);
      if (one.at(x, y).some((value, i) => Math.abs(value - there[i]!) > 8)) count++;
    }
  }
  return count / (one.width * one.height);
}

/** How far a pixel is from grey. */
export function saturation(picture: Picture, [x, y]: Point): number {
  const colour = picture.at(x, y);
  return Math.max(...colour) - Math.min(...colour);
}

/** The darkest pixel in a square around a place, 0 black to 1 white. */
export function darkest(picture: Picture, [x, y]: Point, reach: number): number {
  let least = 1;
  for (let dy = -reach; dy <= reach; dy++) {
    for (let dx = -reach; dx <= reach; dx++) {
      const sum = picture.at(x + dx, y + dy).reduce((total, value) => total + value, 0);
      least = Math.min(least, sum / 765);
    }
  }
  return least;
}
