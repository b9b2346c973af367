/** `rotund render` gives the picture that the element gives, of the size, from the side and in the style that is asked for. */
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, type Page, test } from '@playwright/test';
import pixelmatch from 'pixelmatch';
import { PNG } from 'pngjs';
import { EMPTY_DRAWING, FRONT_VIEW } from '../../src/document/drawing.ts';
import { serialize } from '../../src/document/serialize.ts';
import type { Shot } from '../../src/element/shot.ts';
import { BALL, documentOf, kept, UNFINISHED } from '../../tests/cli/drawings.ts';
import { line } from '../../tests/document/strokes.ts';
import { readPicture } from '../picture.ts';

/** A ball with a tube of 160 mm through it, seen from above the left, 30 mm off the middle; a stroke that is not kept. */
const TEXT = serialize({
  ...EMPTY_DRAWING,
  name: 'Ball',
  document: documentOf([
    ...BALL,
    { type: 'setBrush', change: { radius: 5, caps: false } },
    ...kept(line(0, 160)),
    UNFINISHED,
  ]),
  view: { ...FRONT_VIEW, pivot: [30, 0, 0], rotation: [-0.2, -0.3, 0, 0.9327379], height: 260 },
  look: { ...EMPTY_DRAWING.look, style: 'hbed-ink' },
});

let folder = '';
test.beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'rotund-render-'));
  writeFileSync(join(folder, 'ball.rotund'), TEXT);
});
test.afterAll(() => rmSync(folder, { recursive: true, force: true }));

const rendered = (...options: readonly string[]) => renderedFile(join(folder, 'ball.rotund'), ...options);

function renderedFile(file: string, ...options: readonly string[]) {
  const out = join(folder, 'out.png');
  const args = ['scripts/rotund.mjs', 'render', file, '-o', out, ...options];
  const stdout = execFileSync(process.execPath, args, {
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'ignore'],
  });
  expect(stdout).toMatch(/^\{.*\}\n$/);
  return { json: JSON.parse(stdout), png: readFileSync(out) };
}

async function ofElement(page: Page, shot: Shot): Promise<Buffer> {
  await page.goto('/');
  const base64 = await page.evaluate(
    async ([text, wanted]) => {
      const sketch = document.querySelector('rotund-sketch')!;
      await sketch.load(text, { fit: false });
      const bytes = new Uint8Array(await (await sketch.picture(wanted)).arrayBuffer());
      let binary = '';
      for (const byte of bytes) binary += String.fromCharCode(byte);
      return btoa(binary);
    },
    [TEXT, shot] as const,
  );
  return Buffer.from(base64, 'base64');
}

function differing(a: Buffer, b: Buffer): number {
  const [one, other] = [PNG.sync.read(a), PNG.sync.read(b)];
  expect([one.width, one.height]).toEqual([other.width, other.height]);
  return pixelmatch(one.data, other.data, undefined, one.width, one.height, { threshold: 0.05 });
}

const CASES: readonly (readonly [string, readonly string[], Shot])[] = [
  ['as it was looked at', ['--size', '320x240'], { width: 320, height: 240 }],
  [
    'from angles',
    ['--size', '256x256', '--camera', '-30,20,45', '--style', 'phong'],
    { width: 256, height: 256, camera: { yaw: -30, pitch: 20, roll: 45 }, style: 'phong' },
  ],
];

for (const [name, options, shot] of CASES) {
  test(`a picture is that of the element: ${name}`, async ({ page }) => {
    test.setTimeout(240_000);
    const { json, png } = rendered(...options);
    const { width, height } = shot;
    expect(json).toMatchObject({ width, height, backend: 'WebGPU' });
    expect(json.milliseconds).toBeGreaterThan(0);
    const expected = await ofElement(page, shot);
    expect(differing(png, expected)).toBeLessThan(0.001 * width! * height!);
  });
}

test('a side is what is seen, the whole is framed, and the element has the same picture', async ({
  page,
}) => {
  test.setTimeout(240_000);
  const { png } = rendered('--size', '400x200', '--camera', 'front', '--style', 'toon', '--mode', 'mesh');
  const picture = readPicture(png);
  const paper = picture.at(3, 3);
  const drawn = (x: number, y: number) =>
    picture.at(x, y).some((value, k) => Math.abs(value - paper[k]!) > 60);
  // 160 mm are eight tenths of the height, in the middle; the ball is 100 mm wide.
  const column = Array.from({ length: 200 }, (_, y) => drawn(200, y));
  const row = Array.from({ length: 400 }, (_, x) => drawn(x, 100));
  const length = (line: readonly boolean[]) => line.lastIndexOf(true) - line.indexOf(true) + 1;
  expect(Math.abs(length(column) - 160)).toBeLessThanOrEqual(4);
  expect(Math.abs(length(row) - 100)).toBeLessThanOrEqual(4);
  expect(Math.abs(row.indexOf(true) + row.lastIndexOf(true) - 399)).toBeLessThanOrEqual(2);
  const expected = await ofElement(page, { width: 400, height: 200, camera: 'front', style: 'toon' });
  expect(differing(png, expected)).toBeLessThan(0.001 * 400 * 200);
});

test('bodies are in the picture', () => {
  test.setTimeout(240_000);
  const { png } = renderedFile('public/samples/whale.rotund', '--size', '320x240', '--camera', 'front');
  const picture = readPicture(png);
  let blue = 0;
  for (let y = 0; y < 240; y++)
    for (let x = 0; x < 320; x++) {
      const [r, , b] = picture.at(x, y);
      if (b - r > 60) blue++;
    }
  // its side fills a good part of the frame
  expect(blue).toBeGreaterThan(0.1 * 320 * 240);
});

test('a browser that is not there is asked for by name', () => {
  test.setTimeout(240_000);
  const args = ['scripts/rotund.mjs', 'render', join(folder, 'ball.rotund'), '-o', join(folder, 'none.png')];
  const env = { ...process.env, CHROMIUM: '/nowhere/chromium' };
  const { status, stdout, stderr } = spawnSync(process.execPath, args, { env, encoding: 'utf8' });
  expect(stderr).toContain('CHROMIUM names /nowhere/chromium, which does not exist');
  expect([status, stdout, existsSync(join(folder, 'none.png'))]).toEqual([2, '', false]);
});
