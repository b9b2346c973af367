/** Zhu et al.'s bounding volumes over the picture, and their rays beside ours on the field page. */
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, type Page, test } from '@playwright/test';
import { EMPTY_DRAWING, FRONT_VIEW } from '../../src/document/drawing.ts';
import { serialize } from '../../src/document/serialize.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { BALL, documentOf } from '../../tests/cli/drawings.ts';
import { readPicture, takePicture } from '../picture.ts';

const NODE: FieldNode = {
  type: 'skels',
  kernel: 'cauchy',
  params: { s: 0.05 },
  threshold: 1,
  skels: [
    { skel: { type: 'segment', a: [-40, 0, 0], b: [40, 20, 0], radii: [14, 20] } },
    { skel: { type: 'point', at: [40, -30, 0], radius: 18 } },
  ],
};
const text = serialize({
  ...EMPTY_DRAWING,
  name: 'Bone',
  document: documentOf([{ type: 'addBody', name: 'Bone', node: NODE }]),
  view: { ...FRONT_VIEW, rotation: [-0.2, -0.3, 0, 0.9327379], fov: 30 },
});

/** Pixels of blue pencil. */
async function pencil(page: Page): Promise<number> {
  const { width, height, at } = await takePicture(page);
  let count = 0;
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const [red, , blue] = at(x, y);
      if (blue - red > 40) count++;
    }
  return count;
}

const whole = (page: Page) =>
  expect
    .poll(
      () =>
        page.evaluate(async () => {
          const { session } = document.querySelector('rotund-sketch')!;
          session.frames.wake();
          await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
          return session.exact.isWhole;
        }),
      { timeout: 90_000 },
    )
    .toBe(true);

for (const address of ['/', '/?backend=webgl2'])
  test(`M shows them over triangles and over rays, the attribute follows: ${address}`, async ({ page }) => {
    test.setTimeout(240_000);
    await page.setViewportSize({ width: 480, height: 360 });
    await page.goto(address);
    const sketch = page.locator('rotund-sketch');
    await expect(sketch).toHaveAttribute('data-backend', /WebG/);
    await sketch.evaluate(
      (element: HTMLElementTagNameMap['rotund-sketch'], drawing) => element.load(drawing),
      text,
    );
    await expect
      .poll(
        () =>
          sketch.evaluate(
            (element: HTMLElementTagNameMap['rotund-sketch']) => element.session.bodies.making === null,
          ),
        { timeout: 60_000 },
      )
      .toBe(true);
    for (const mode of ['mesh', 'exact'] as const) {
      await sketch.evaluate((element: HTMLElementTagNameMap['rotund-sketch'], wanted) => {
        element.session.setMode(wanted);
        element.shadowRoot!.querySelector<HTMLElement>('.stage')!.focus();
      }, mode);
      if (mode === 'exact') await whole(page);
      const without = await pencil(page);
      await page.keyboard.press('m');
      await expect(sketch).toHaveAttribute('volumes', '');
      if (mode === 'exact') await whole(page);
      expect(await pencil(page)).toBeGreaterThan(without + 500);
      await page.keyboard.press('m');
      await expect(sketch).not.toHaveAttribute('volumes');
      if (mode === 'exact') await whole(page);
      expect(await pencil(page)).toBe(without);
    }
    await sketch.evaluate((element) => element.setAttribute('volumes', ''));
    expect(
      await sketch.evaluate((element: HTMLElementTagNameMap['rotund-sketch']) => element.session.volumes),
    ).toBe(true);
  });

test('where there is no body they are off, and it is said why', async ({ page }) => {
  await page.setViewportSize({ width: 800, height: 600 });
  await page.goto('/');
  const drawing = serialize({ ...EMPTY_DRAWING, document: documentOf(BALL) });
  await page.evaluate((wanted) => document.querySelector('rotund-sketch')!.load(wanted), drawing);
  await page.click('[aria-label=Settings]');
  const toggle = page.getByRole('switch', { name: 'Bounding volumes' });
  await expect(toggle).toHaveAttribute('aria-disabled', 'true');
  await expect(toggle).toHaveAttribute('title', /no implicit body/);
});

test('rotund render --rays zhu says what both cost and missed, and draws the same picture', () => {
  test.setTimeout(240_000);
  const folder = mkdtempSync(join(tmpdir(), 'rotund-zhu-'));
  try {
    writeFileSync(join(folder, 'bone.rotund'), text);
    const rendered = (...more: readonly string[]) => {
      const files = [join(folder, 'bone.rotund'), '-o', join(folder, 'bone.png')];
      const args = [
        'scripts/rotund.mjs',
        'render',
        ...files,
        '--size',
        '120x90',
        '--mode',
        'raycast',
        ...more,
      ];
      const said = execFileSync(process.execPath, args, {
        encoding: 'utf8',
        stdio: ['ignore', 'pipe', 'ignore'],
      });
      return { said: JSON.parse(said), picture: readPicture(readFileSync(join(folder, 'bone.png'))) };
    };
    const [zhu, ours] = [rendered('--rays', 'zhu'), rendered()];
    const { hits, ...both } = zhu.said.rays;
    expect(hits).toBeGreaterThan(500);
    for (const { evaluationsPerPixel, missed } of [both.zhu, both.bricks]) {
      expect(evaluationsPerPixel).toBeGreaterThan(0.1);
      expect(missed).toBeLessThan(0.02 * hits);
    }
    expect(ours.said.rays).toBeUndefined();
    let differing = 0;
    for (let y = 0; y < 90; y++)
      for (let x = 0; x < 120; x++) {
        const [a, b] = [zhu.picture.at(x, y), ours.picture.at(x, y)];
        if (a.some((value, channel) => Math.abs(value - b[channel]!) > 60)) differing++;
      }
    expect(differing).toBeLessThan(20);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});

test('on the field page Zhu’s rays are counted beside ours', async ({ page }) => {
  test.setTimeout(240_000);
  await page.setViewportSize({ width: 800, height: 480 });
  await page.goto('/field.html#skeleton=segment&resolution=32&surface=exact&rays=zhu&volumes=shown');
  await expect(page.locator('rotund-field')).toHaveAttribute('data-backend', /WebG/);
  await expect(page.locator('.status')).toContainText(
    /Zhu’s rays, [\d.]+ evaluations a pixel, \d+ of \d+( k)? hits missed · by bricks [\d.]+ evaluations a pixel, 0 missed/,
    { timeout: 120_000 },
  );
  await expect(page.getByRole('radio', { name: 'Zhu’s, compared' })).toBeChecked();
  await page.getByRole('radio', { name: 'By bricks' }).click();
  await expect(page.locator('.status')).toContainText(/exact.*evaluations/, { timeout: 60_000 });
  // what they are not for is said
  await page.evaluate(() => {
    location.hash = '#skeleton=segment&resolution=32&operation=union&surface=exact&rays=zhu';
  });
  await expect(page.locator('.status')).toContainText(/sums of skels/, { timeout: 60_000 });
});
