/** The thesis' pear with a real pen on software WebGPU: parts, volumes, undo, back end, and the picture itself. */
import { expect, type Page, test } from '@playwright/test';
import { solids } from '../../src/document/build.ts';
import { strokesOf } from '../../src/document/document.ts';
import { topology } from '../../src/mesh/check.ts';
import { volume } from '../../src/mesh/measure.ts';
import { BODY, STEM } from '../pear.ts';
import { PenDriver, type Point } from '../pen.ts';
import { distanceTo, inside, takePicture } from '../picture.ts';

/** The picture is 600 px for 200 mm. */
const MM = 200 / 600;

async function drawPear(page: Page): Promise<void> {
  await page.goto('/');
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', 'WebGPU');
  const pen = await PenDriver.on(page);
  for (const stroke of [...BODY, ...STEM]) await pen.draw(stroke);
  await page.getByRole('button', { name: 'Keep' }).click();
}

interface PartFacts {
  readonly kind: string;
  readonly strokes: number;
  readonly volume: number;
  readonly watertight: boolean;
  readonly genus: number;
}

async function facts(page: Page): Promise<PartFacts[]> {
  const drawing = await page.evaluate(() => document.querySelector('rotund-sketch')!.document);
  return solids(drawing).map(({ mesh, kind }, i) => {
    const { watertight, genus } = topology(mesh);
    return { kind, strokes: strokesOf(drawing.parts[i]!).length, volume: volume(mesh), watertight, genus };
  });
}

/** Slices between the two outlines, each a circle on its chord: the solid without its program. */
function volumeBetween([left, right]: readonly (readonly Point[])[]): number {
  const ys = left!.map(([, y]) => y);
  const top = Math.min(...ys);
  const bottom = Math.max(...ys);
  const steps = 2000;
  let sum = 0;
  for (let i = 0; i < steps; i++) {
    const y = top + ((bottom - top) * (i + 0.5)) / steps;
    sum += Math.PI * ((crossing(right!, y) - crossing(left!, y)) / 2) ** 2;
  }
  return ((sum * (bottom - top)) / steps) * MM ** 3;
}

function crossing(line: readonly Point[], y: number): number {
  for (let i = 1; i < line.length; i++) {
    const [ax, ay] = line[i - 1]!;
    const [bx, by] = line[i]!;
    if (ay !== by && (ay - y) * (by - y) <= 0) return ax + ((bx - ax) * (y - ay)) / (by - ay);
  }
  return line[0]![0];
}

const outlineOf = ([left, right]: readonly (readonly Point[])[]): Point[] => [
  ...left!,
  ...[...right!].reverse(),
];

test('two strokes and two more make a pear', async ({ page }) => {
  const errors: string[] = [];
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  page.on('pageerror', (error) => errors.push(String(error)));
  await drawPear(page);
  const [body, stem, ...more] = await facts(page);
  expect(more).toEqual([]);
  expect(body).toMatchObject({ kind: 'rotational', strokes: 2, watertight: true, genus: 0 });
  expect(stem).toMatchObject({ kind: 'rotational', strokes: 2, watertight: true, genus: 0 });
  const expected = volumeBetween(BODY);
  expect(Math.abs(body!.volume / expected - 1)).toBeLessThan(0.02);
  expect(stem!.volume).toBeGreaterThan(0);
  expect(stem!.volume).toBeLessThan(expected / 50);
  await expect(page.getByRole('status')).toContainText('Rotational surface added, part 2');
  expect(errors).toEqual([]);
});

test('undo takes every step back and redo brings it again', async ({ page }) => {
  await drawPear(page);
  const state = () =>
    page.evaluate(() => {
      const { parts, draft } = document.querySelector('rotund-sketch')!.document;
      return `${parts.length} parts, ${draft?.strokes.length ?? 0} strokes`;
    });
  const seen = [await state()];
  for (let i = 0; i < 7; i++) {
    await page.keyboard.press('u');
    seen.push(await state());
  }
  const steps = [
    '2 parts, 0 strokes',
    '1 parts, 2 strokes',
    '1 parts, 1 strokes',
    '1 parts, 0 strokes',
    '0 parts, 2 strokes',
    '0 parts, 1 strokes',
    '0 parts, 0 strokes',
  ];
  expect(seen).toEqual([...steps, '0 parts, 0 strokes']);
  await expect(page.getByRole('status')).toContainText('Nothing to undo');
  for (let i = 0; i < 6; i++) await page.keyboard.press('Control+Shift+z');
  expect(await state()).toBe('2 parts, 0 strokes');
});

test('its silhouette is what the strokes enclose', async ({ page }) => {
  await drawPear(page);
  // On black: a highlight is nearly as light as paper.
  await page.getByRole('button', { name: 'Settings' }).click();
  await page.getByRole('radio', { name: 'Black' }).click();
  const picture = await takePicture(page);
  const masks = [outlineOf(BODY), outlineOf(STEM)];
  const paper = picture.at(40, 300);
  expect(paper).toEqual([0, 0, 0]);
  let wrong = 0;
  let area = 0;
  for (let y = 0; y < picture.height; y++) {
    for (let x = 0; x < picture.width; x++) {
      const drawn = picture.at(x, y).some((value, i) => Math.abs(value - paper[i]!) > 24);
      const expected = masks.some((mask) => inside(mask, x + 0.5, y + 0.5));
      if (expected) area++;
      // The contour straddles the outline: 2.4 px wide, and strokes are smoothed by less than a pixel.
      const near = () => masks.some((mask) => distanceTo(mask, x + 0.5, y + 0.5) < 3.5);
      if (drawn !== expected && !near()) wrong++;
    }
  }
  expect(area).toBeGreaterThan(30_000);
  expect(wrong).toBe(0);
});

test('lines are where they must be and nowhere else', async ({ page }) => {
  await drawPear(page);
  await page.getByRole('radio', { name: 'Lines' }).click();
  const picture = await takePicture(page);
  const body = outlineOf(BODY);
  const stem = outlineOf(STEM);
  const dark = (x: number, y: number) => picture.at(x, y).reduce((sum, value) => sum + value, 0) < 560;
  const lineNear = (x: number, y: number) => {
    for (let dy = -3; dy <= 3; dy++) for (let dx = -3; dx <= 3; dx++) if (dark(x + dx, y + dy)) return true;
    return false;
  };
  // Where the stem stands on the body the body's own outline is behind it.
  const missing = body.filter(
    ([x, y]) => !inside(stem, x, y) && distanceTo(stem, x, y) > 8 && !lineNear(x, y),
  );
  expect(missing).toEqual([]);
  const stray: Point[] = [];
  for (let y = 0; y < picture.height; y++) {
    for (let x = 0; x < picture.width; x++) {
      if (!dark(x, y)) continue;
      if (Math.min(distanceTo(body, x, y), distanceTo([...stem, stem[0]!], x, y)) > 4) stray.push([x, y]);
    }
  }
  expect(stray).toEqual([]);
});
