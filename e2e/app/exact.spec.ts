/** The exact surface of bodies in the application: switched on, seen where all rests, said, saved, picked, drawn into files. */
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, type Page, test } from '@playwright/test';
import { isBody } from '../../src/document/document.ts';
import { EMPTY_DRAWING, FRONT_VIEW } from '../../src/document/drawing.ts';
import { serialize } from '../../src/document/serialize.ts';
import { bindField } from '../../src/field/bind.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { sub3, unrotate3 } from '../../src/math/tuple.ts';
import { BALL, documentOf } from '../../tests/cli/drawings.ts';
import { readPicture, takePicture } from '../picture.ts';

/** A ring with a blob on it, turned and moved, through a ball of two strokes. */
const NODE: FieldNode = {
  type: 'union',
  form: 'smooth',
  parts: [
    { type: 'shape', shape: { type: 'torus', ring: 55, tube: 14 }, colour: [0.9, 0.3, 0.1] },
    {
      type: 'skels',
      kernel: 'gaussian',
      params: { s: 0.05 },
      threshold: 0.5,
      skels: [{ skel: { type: 'point', at: [50, 10, 0], radius: 22 }, colour: [0.1, 0.3, 0.9] }],
    },
  ],
};
const PLACEMENT = { rotation: [0.5, 0, 0, Math.sqrt(0.75)], translation: [10, -5, 0] } as const;
const DOCUMENT = documentOf([...BALL, { type: 'addBody', name: 'Ring', node: NODE }]);
const TEXT = serialize({
  ...EMPTY_DRAWING,
  name: 'Ring',
  document: {
    ...DOCUMENT,
    parts: DOCUMENT.parts.map((part) => (isBody(part) ? { ...part, placement: PLACEMENT } : part)),
  },
  view: { ...FRONT_VIEW, rotation: [-0.2, -0.3, 0, 0.9327379], fov: 30 },
});

const load = (page: Page, text: string) =>
  page.evaluate((drawing) => document.querySelector('rotund-sketch')!.load(drawing, { fit: false }), text);

/** Whether all that rays show is drawn, as the frame after this one has it. */
const isWhole = (page: Page) =>
  page.evaluate(async () => {
    const { session } = document.querySelector('rotund-sketch')!;
    session.frames.wake();
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    return session.exact.isWhole;
  });

const whole = (page: Page) => expect.poll(() => isWhole(page), { timeout: 90_000 }).toBe(true);

async function open(page: Page, address: string, text: string): Promise<void> {
  await page.setViewportSize({ width: 480, height: 360 });
  await page.goto(address);
  await load(page, text);
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', /WebG/);
  await expect
    .poll(
      () => page.evaluate(() => document.querySelector('rotund-sketch')!.session.bodies.making === null),
      { timeout: 60_000 },
    )
    .toBe(true);
}

type Shown = Pick<ReturnType<typeof readPicture>, 'width' | 'height' | 'at'>;

/** Pixels that differ by more than `least` of 255 in a channel. */
function differing(one: Shown, other: Shown, least: number): number {
  let count = 0;
  for (let y = 0; y < one.height; y++)
    for (let x = 0; x < one.width; x++) {
      const [a, b] = [one.at(x, y), other.at(x, y)];
      if (a.some((value, channel) => Math.abs(value - b[channel]!) > least)) count++;
    }
  return count;
}

for (const [address, backend] of [
  ['/', 'WebGPU'],
  ['/?backend=webgl2', 'WebGL2'],
] as const) {
  test(`X shows the surface itself where all rests: ${backend}`, async ({ page }) => {
    test.setTimeout(300_000);
    const errors: string[] = [];
    page.on('pageerror', (error) => errors.push(error.message));
    await open(page, address, TEXT);
    await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', backend);
    await page.evaluate(() => {
      const sketch = document.querySelector('rotund-sketch')!;
      sketch.addEventListener('mode', ({ detail: { mode } }) => (document.title = `mode ${mode}`));
      sketch.shadowRoot!.querySelector<HTMLElement>('.stage')!.focus();
    });
    for (const style of ['toon', 'hbed-lines', 'hbed-ink'] as const) {
      await page.evaluate(
        (name) => document.querySelector('rotund-sketch')!.session.setLook({ style: name }),
        style,
      );
      const mesh = await takePicture(page);
      await page.keyboard.press('x');
      await expect(page).toHaveTitle('mode exact');
      await whole(page);
      const exact = await takePicture(page);
      // the same to the eye; where it is not to the bit, rays were cast
      expect(differing(mesh, exact, 100)).toBeLessThan(30);
      expect(differing(mesh, exact, 2)).toBeGreaterThan(200);
      await page.keyboard.press('x');
      await expect(page).toHaveTitle('mode mesh');
      expect(differing(mesh, await takePicture(page), 2)).toBe(0);
    }
    await page.keyboard.press('x');
    await whole(page);
    expect(await page.locator('.status .seen').textContent()).toMatch(
      /exact · [\d.]+ evaluations per pixel · [\d.]+ m?s/,
    );
    const text = await page.evaluate(() => document.querySelector('rotund-sketch')!.save());
    expect(JSON.parse(text)).toMatchObject({ version: 3, look: { mode: 'exact' } });
    // a turn ends it, and after it rays are cast anew
    await page.keyboard.press('ArrowRight');
    expect(await isWhole(page)).toBe(false);
    await whole(page);
    expect(errors).toEqual([]);
  });

  test(`pictures of their own are exact as well: ${backend}`, async ({ page }) => {
    test.setTimeout(300_000);
    await open(page, address, TEXT);
    const picture = async (mode: 'mesh' | 'exact') => {
      const base64 = await page.evaluate(async (wanted) => {
        const sketch = document.querySelector('rotund-sketch')!;
        const png = await sketch.picture({ width: 240, height: 180, mode: wanted, style: 'toon' });
        let binary = '';
        for (const byte of new Uint8Array(await png.arrayBuffer())) binary += String.fromCharCode(byte);
        return btoa(binary);
      }, mode);
      return readPicture(Buffer.from(base64, 'base64'));
    };
    const [mesh, exact] = [await picture('mesh'), await picture('exact')];
    expect(differing(mesh, exact, 110)).toBeLessThan(20);
    expect(differing(mesh, exact, 2)).toBeGreaterThan(50);
  });
}

test('the graphics device casts the picture of the workers, and while the view turns', async ({ page }) => {
  test.setTimeout(300_000);
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(error.message));
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  await open(page, '/?rays=device', TEXT);
  await page.setViewportSize({ width: 240, height: 180 });
  const look = (change: { readonly style?: 'toon' | 'hbed-ink'; readonly mode?: 'mesh' | 'exact' }) =>
    page.evaluate((wanted) => document.querySelector('rotund-sketch')!.session.setLook(wanted), change);
  const exact = async (): Promise<Shown> => {
    await whole(page);
    return takePicture(page);
  };
  /** bands of rays since the last time */
  const cast = () => page.evaluate(() => document.body.dataset.cast);
  await page.evaluate(() => {
    const { device } = document.querySelector('rotund-sketch')!.session.scene!;
    const encoder = device!.createCommandEncoder.bind(device);
    let count = 0;
    device!.createCommandEncoder = (what) => {
      if (what?.label === 'raycast') document.body.dataset.cast = String(++count);
      return encoder(what);
    };
  });
  await look({ style: 'toon', mode: 'exact' });
  const toon = await exact();
  const before = Number(await cast());
  expect(before).toBeGreaterThan(4);
  // of the same images, and so is a file as large
  await look({ style: 'hbed-ink' });
  const ink = await exact();
  await page.evaluate(async () => {
    const sketch = document.querySelector('rotund-sketch')!;
    await sketch.picture(sketch.session.scene!.pixels);
  });
  expect(Number(await cast())).toBe(before);
  await look({ mode: 'mesh' });
  await page.evaluate(() => {
    document.querySelector('rotund-sketch')!.session.rays.choice = 'worker';
  });
  await look({ mode: 'exact' });
  expect(differing(ink, await exact(), 60)).toBeLessThan(10);
  await look({ style: 'toon' });
  expect(differing(toon, await exact(), 40)).toBeLessThan(10);
  // while something moves
  const isLive = await page.evaluate(async () => {
    const { session } = document.querySelector('rotund-sketch')!;
    session.rays.choice = 'device';
    const { exact: seen } = session;
    const live = seen.live.bind(seen);
    const told: boolean[] = [];
    seen.live = (now) => told[told.push(live(now)) - 1]!;
    const view = session.scene!.rig.view();
    // the first frame asks for room
    for (const height of [1.01 * view.height, 1.02 * view.height]) {
      session.scene!.rig.setView({ ...view, height }, false);
      session.frames.wake();
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      await session.scene!.device!.queue.onSubmittedWorkDone();
    }
    return told;
  });
  expect(isLive.at(-1)).toBe(true);
  const turned = await takePicture(page);
  await look({ mode: 'mesh' });
  expect(differing(turned, await takePicture(page), 110)).toBeLessThan(30);
  expect(errors).toEqual([]);
});

test('an undo while the device casts shows what was before, and nothing of what was begun', async ({
  page,
}) => {
  test.setTimeout(300_000);
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(error.message));
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  await open(page, '/?rays=device', TEXT);
  await page.setViewportSize({ width: 240, height: 180 });
  await page.evaluate(() => document.querySelector('rotund-sketch')!.session.setMode('exact'));
  await whole(page);
  const first = await takePicture(page);
  const move = (by: number) =>
    page.evaluate((x) => {
      const { session } = document.querySelector('rotund-sketch')!;
      const ids = session.document.parts.filter(({ kind }) => kind === 'body').map(({ id }) => id);
      const moved = { rotation: [0, 0, 0, 1], translation: [x, 0, 0] } as const;
      session.commit([{ type: 'moveParts', ids, by: moved }]);
    }, by);
  await move(60);
  // rays of the moved body are on their way
  await page.evaluate(async () => {
    const { session } = document.querySelector('rotund-sketch')!;
    while (session.exact.evaluationsAPixel === null && session.exact.share === null)
      await new Promise((done) => requestAnimationFrame(done));
    session.undo();
  });
  await whole(page);
  expect(differing(first, await takePicture(page), 2)).toBe(0);
  expect(errors).toEqual([]);
});

test('the field page by the graphics device shows what it shows by workers', async ({ page }) => {
  test.setTimeout(300_000);
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(error.message));
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  // beside the panel there is room for the point
  await page.setViewportSize({ width: 800, height: 400 });
  const shown = async (rays: 'device' | 'worker') => {
    await page.goto(`/field.html?rays=${rays}#skeleton=point&surface=exact`);
    await expect
      .poll(
        () =>
          page.evaluate(() => {
            const { stage } = document.querySelector('rotund-field')!;
            stage.wake();
            return stage.cast !== null && stage.exact.evaluationsAPixel !== null && stage.exact.isWhole;
          }),
        { timeout: 90_000 },
      )
      .toBe(true);
    // the body alone: the status beside it says other numbers, in three lines or in four
    return readPicture(await page.screenshot({ clip: { x: 150, y: 80, width: 190, height: 212 } }));
  };
  const byDevice = await shown('device');
  expect(differing(byDevice, await shown('worker'), 40)).toBeLessThan(12);
  let seen = 0;
  for (let y = 0; y < byDevice.height; y++)
    for (let x = 0; x < byDevice.width; x++) {
      const [red, , blue] = byDevice.at(x, y);
      if (red - blue > 60) seen++;
    }
  expect(seen).toBeGreaterThan(1000);
  expect(errors).toEqual([]);
});

test('a pen points at the surface itself', async ({ page }) => {
  await open(page, '/', TEXT);
  const places = await page.evaluate(() => {
    const { session } = document.querySelector('rotund-sketch')!;
    session.setMode('exact');
    const found: (readonly number[])[] = [];
    for (let y = 20; y < 340; y += 10)
      for (let x = 20; x < 460; x += 10) {
        const hit = session.pick(x, y);
        if (hit && session.document.parts.some(({ id, kind }) => id === hit.id && kind === 'body'))
          found.push(hit.point);
      }
    return found;
  });
  expect(places.length).toBeGreaterThan(50);
  const field = bindField(NODE);
  const off = places.filter((place) => {
    const [x, y, z] = unrotate3(
      PLACEMENT.rotation,
      sub3(place as [number, number, number], PLACEMENT.translation),
    );
    return Math.abs(field.value(x, y, z)) > 1e-6;
  });
  // beside an outline the triangles may be hit where the surface is not
  expect(off.length).toBeLessThan(0.05 * places.length);
});

test('a stroke that starts on a body starts on its surface itself, whatever is seen', async ({ page }) => {
  await open(page, '/', TEXT);
  const field = bindField(NODE);
  for (const mode of ['mesh', 'exact'] as const) {
    const { origin, paths } = await page.evaluate((wanted) => {
      const sketch = document.querySelector('rotund-sketch')!;
      const { session } = sketch;
      session.setMode(wanted);
      session.setTool('draw');
      const bodies = session.document.parts.filter(({ kind }) => kind === 'body').map(({ id }) => id);
      const paths = new Set<string>();
      let start: readonly [number, number] | null = null;
      for (let y = 20; y < 340; y += 8)
        for (let x = 20; x < 460; x += 8) {
          const hit = sketch.pick(x, y);
          if (!hit || !bodies.includes(hit.id)) continue;
          paths.add(hit.skel!.path);
          // well within it
          if (bodies.includes(sketch.pick(x + 8, y + 8)?.id ?? '')) start ??= [x, y];
        }
      const [x, y] = start!;
      const pen = { pressure: 0.5, tiltX: 0, tiltY: 0, pointer: 'pen', adds: false } as const;
      session.down({ ...pen, x, y, time: 0 });
      session.move([1, 2, 3, 4].map((i) => ({ ...pen, x: x + 10 * i, y, time: 10 * i })));
      session.up();
      const { origin } = session.document.draft!.strokes[0]!.plane;
      session.undo();
      return { origin, paths: [...paths].sort() };
    }, mode);
    const { rotation, translation } = PLACEMENT;
    const [x, y, z] = unrotate3(rotation, sub3(origin, translation));
    expect(Math.abs(field.value(x, y, z))).toBeLessThan(1e-6);
    expect(paths).toEqual(['parts[0]', 'parts[1].skels[0]']);
  }
});

test('where there is no body the switch says why it is off', async ({ page }) => {
  await open(page, '/', serialize({ ...EMPTY_DRAWING, document: documentOf(BALL) }));
  // narrow ones have no settings
  await page.setViewportSize({ width: 800, height: 600 });
  await page.click('[aria-label=Settings]');
  const toggle = page.getByRole('switch', { name: 'Exact surface' });
  await expect(toggle).toHaveAttribute('aria-disabled', 'true');
  await expect(toggle).toHaveAttribute('title', /no implicit body/);
  await toggle.dispatchEvent('click');
  await expect(toggle).toHaveAttribute('aria-checked', 'false');
  await expect(page.locator('.status [role=status]')).toHaveText(/no implicit body/);
  await load(page, TEXT);
  await expect(toggle).not.toHaveAttribute('aria-disabled', 'true');
  await toggle.click();
  await expect(toggle).toHaveAttribute('aria-checked', 'true');
});

test('the attribute says it, and follows what is chosen', async ({ page }) => {
  await open(page, '/', TEXT);
  const sketch = page.locator('rotund-sketch');
  await sketch.evaluate((element) => element.setAttribute('mode', 'exact'));
  expect(await page.evaluate(() => document.querySelector('rotund-sketch')!.session.look.mode)).toBe('exact');
  await page.evaluate(() => document.querySelector('rotund-sketch')!.session.setMode('mesh'));
  await expect(sketch).toHaveAttribute('mode', 'mesh');
});

test('rotund render --mode raycast draws it', () => {
  test.setTimeout(240_000);
  const folder = mkdtempSync(join(tmpdir(), 'rotund-exact-'));
  try {
    writeFileSync(join(folder, 'ring.rotund'), TEXT);
    const rendered = (mode: string) => {
      const out = join(folder, `${mode}.png`);
      const args = [
        'scripts/rotund.mjs',
        'render',
        join(folder, 'ring.rotund'),
        '-o',
        out,
        '--size',
        '240x180',
        '--mode',
        mode,
      ];
      execFileSync(process.execPath, args, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });
      return readPicture(readFileSync(out));
    };
    const [mesh, exact] = [rendered('mesh'), rendered('raycast')];
    expect(differing(mesh, exact, 110)).toBeLessThan(20);
    expect(differing(mesh, exact, 2)).toBeGreaterThan(50);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});
