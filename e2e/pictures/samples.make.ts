/** The gallery's drawings: each in every style, all of them on one sheet, and their thumbnails. */
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { expect, type Page, test } from '@playwright/test';
import { PNG } from 'pngjs';
import type { Style } from '../../src/document/look.ts';
import { parse } from '../../src/document/serialize.ts';
import { rotate3 } from '../../src/math/tuple.ts';
import type { View } from '../../src/stroke/stroke.ts';
import { boxOf, column, cutOut, decoded, sheet, shrunk } from './raster.ts';
import type { Wanted } from './samples.page.ts';

const FROM = 'public/samples';
const OUT = 'docs/pictures';
/** the interface's styles and what their files are called */
const STYLES: Readonly<Record<string, Style>> = {
  toon: 'toon',
  lines: 'hbed-lines',
  ink: 'hbed-ink',
  shaded: 'gouraud',
};
/** Everything is drawn at twice its resolution, so that all edges are smooth. */
const FINE = 2;

interface Entry {
  readonly file: string;
  readonly name: string;
  readonly thumbnail: string;
}

const all = JSON.parse(readFileSync(`${FROM}/index.json`, 'utf8')) as Entry[];
/** SAMPLES=rabbit,mouse: thumbnails of these alone */
const only = process.env.SAMPLES?.split(',');
const save = (path: string, picture: PNG): void => writeFileSync(path, PNG.sync.write(picture));

async function open(page: Page): Promise<void> {
  mkdirSync(OUT, { recursive: true });
  await page.goto('/e2e/pictures/samples.html');
  await page.waitForFunction(() => typeof window.drawFile === 'function');
}

const draw = async (page: Page, wanted: Wanted): Promise<PNG> =>
  decoded(await page.evaluate((w) => window.drawFile(w), wanted));

test('every sample in every style', async ({ page }) => {
  test.setTimeout(1_200_000);
  await open(page);
  const small: PNG[][] = Object.keys(STYLES).map(() => []);
  for (const { file } of all) {
    const text = readFileSync(`${FROM}/${file}`, 'utf8');
    for (const [i, [word, style]] of Object.entries(STYLES).entries()) {
      // Grain would be most of the file and is hardly seen.
      const look = { style, grain: false };
      const fine = await draw(page, { text, look, size: [480, 360], pixelRatio: (FINE * 4) / 3 });
      save(`${OUT}/${file.replace('.rotund', '')}-${word}.png`, shrunk(fine, FINE));
      small[i]!.push(shrunk(fine, 2 * FINE));
    }
  }
  save(`${OUT}/samples.png`, sheet(small));
  const pear = Object.keys(STYLES)
    .slice(0, 3)
    .map((word) => PNG.sync.read(readFileSync(`${OUT}/pear-${word}.png`)));
  save(`${OUT}/pear.png`, sheet([pear.map((picture) => column(picture, 140, 360))]));
});

/** pixels, and the part of them that the drawing fills */
const THUMBNAIL = 320;
const FILLED = 0.9;

test('thumbnails', async ({ page }) => {
  test.setTimeout(1_200_000);
  await open(page);
  const wanted = all.filter(({ file }) => !only || only.includes(file.replace('.rotund', '')));
  for (const { file, thumbnail } of wanted) {
    const text = readFileSync(`${FROM}/${file}`, 'utf8');
    const at = async (view: Partial<View>): Promise<PNG> => {
      const on = (background: 'white' | 'paper'): Promise<PNG> =>
        draw(page, {
          text,
          view,
          look: { style: 'toon', background, grain: false },
          size: [240, 240],
          pixelRatio: 16 / 3,
        });
      return cutOut(await on('white'), await on('paper'));
    };
    const { pivot, rotation, height } = parse(text, file).view;
    const wide = { pivot, rotation, height: 1.5 * height };
    const picture = await at(closer(wide, await at(wide)));
    const { left, top, right, bottom } = boxOf(picture);
    expect(Math.min(left, top, picture.width - right, picture.height - bottom)).toBeGreaterThan(0);
    save(`${FROM}/${thumbnail}`, shrunk(picture, picture.width / THUMBNAIL));
  }
});

/** The view in which what the picture shows is in the middle and fills it. */
function closer(view: Pick<View, 'pivot' | 'rotation' | 'height'>, picture: PNG): Partial<View> {
  const { left, top, right, bottom } = boxOf(picture);
  const pixel = view.height / picture.height;
  const [x, y, z] = rotate3(view.rotation, [
    pixel * ((left + right) / 2 - picture.width / 2),
    pixel * (picture.height / 2 - (top + bottom) / 2),
    0,
  ]);
  const [px, py, pz] = view.pivot;
  const size = pixel * Math.max(right - left, bottom - top);
  return { pivot: [px + x, py + y, pz + z], height: size / FILLED };
}
