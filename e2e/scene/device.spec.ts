/** Buffers that compute passes wrote are drawn as they are: the pictures of a mesh of arrays, and nothing goes up. */
import { expect, type Page, test } from '@playwright/test';
import { PNG } from 'pngjs';
import { countDevice } from '../life/count.ts';
import { listen, serious } from '../life/life.ts';
import type { DeviceStage } from './device.ts';
import type { Picture } from './main.ts';

type Look = NonNullable<Picture['look']>;

// One page for all: starting the software device costs more than a picture.
let page: Page;
let errors: readonly string[];

test.beforeAll(async ({ browser }) => {
  page = await browser.newPage();
  errors = listen(page);
  await page.addInitScript(countDevice);
  await page.goto('/e2e/scene/index.html');
  await page.waitForFunction(() => typeof window.openDeviceStage === 'function');
  await page.evaluate(async () => void (await window.openDeviceStage()));
});

test.afterAll(() => page.close());
test.afterEach(() => expect(serious(errors)).toEqual([]));

const STYLES = ['toon', 'gouraud', 'phong', 'hbed-lines', 'hbed-ink'] as const;

const read = (address: string): PNG =>
  PNG.sync.read(Buffer.from(address.slice(address.indexOf(',') + 1), 'base64'));

const picture = async (look: Look): Promise<PNG> =>
  read(await page.evaluate((wanted) => window.stage.picture(wanted), look));

const show = (...how: Parameters<DeviceStage['show']>) =>
  page.evaluate((of) => window.stage.show(...of), how);

/** Share of the pixels that differ by more than a step of 255 in any channel. */
function differing(one: PNG, other: PNG): number {
  let count = 0;
  for (let i = 0; i < one.data.length; i += 4) {
    if ([0, 1, 2].some((k) => Math.abs(one.data[i + k]! - other.data[i + k]!) > 1)) count++;
  }
  return count / (one.width * one.height);
}

for (const style of STYLES) {
  for (const more of [{}, { preview: true }, { selected: true }]) {
    test(`${style}, ${JSON.stringify(more)}: the picture of arrays`, async () => {
      await show('arrays', more);
      const arrays = await picture({ style });
      await page.evaluate(() => window.stage.clear());
      expect(differing(await picture({ style }), arrays), 'without the body').toBeGreaterThan(0.01);
      await show('buffers', more);
      expect(differing(await picture({ style }), arrays)).toBeLessThan(1e-4);
    });
  }
}

test('wires: the picture of arrays, also of as many triangles as only the GPU knows', async () => {
  const look = { style: 'gouraud', wireframe: true } as const;
  await show('arrays');
  const arrays = await picture(look);
  expect(differing(await picture({ ...look, wireframe: false }), arrays)).toBeGreaterThan(0.1);
  await show('buffers');
  expect(differing(await picture(look), arrays)).toBeLessThan(1e-4);
  await page.evaluate(() => window.stage.showHalf());
  const expected = await picture(look);
  const before = await page.evaluate(() => window.count.resources);
  await page.evaluate(() => window.stage.grow());
  await page.evaluate(() => window.stage.halve());
  expect(differing(await picture(look), expected)).toBeLessThan(1e-4);
  expect(differing(await picture({ style: 'gouraud' }), expected)).toBeGreaterThan(0.1);
  await page.evaluate(() => window.stage.showHalf());
  await picture(look);
  expect(await page.evaluate(() => window.count.resources)).toBe(before);
  // the whole of it again, for those that come
  await page.evaluate(() => window.stage.grow());
});

test('a picture for a file, while the same buffers are on the screen', async () => {
  const look = { style: 'hbed-ink' } as const;
  await show('arrays');
  const expected = await picture(look);
  await show('buffers');
  const file = read(await page.evaluate((wanted) => window.stage.file(wanted), look));
  expect(differing(file, expected)).toBeLessThan(1e-4);
  expect(differing(await picture(look), expected)).toBeLessThan(1e-4);
});

test('a buffer that cannot be drawn is refused by name', async () => {
  await show('arrays');
  expect(await page.evaluate(() => window.stage.refusal())).toContain('“indices”');
});

test('colours are linear on the device and display values on the screen', async () => {
  await show('buffers');
  const { data, width } = await picture({ style: 'toon', outline: false });
  // towards the viewer the colour is (.5, .5, 1), and N·L is 1/√3: the band .5
  const at = 4 * ((width / 2) * width + width / 2);
  const half = 1.055 * 0.5 ** (1 / 2.4) - 0.055;
  const lit = [half * (0.43 + 0.83 * 0.5), half * (0.43 + 0.82 * 0.5), 0.5 + 0.74 * 0.5];
  for (const [i, value] of lit.entries()) expect(Math.abs(data[at + i]! - 255 * value)).toBeLessThan(2);
});

test('no vertex, index or count goes up or is made anew', async () => {
  const bytes = await page.evaluate((styles) => {
    const { stage } = window;
    stage.show('arrays');
    const draw = () => {
      for (const style of styles) stage.picture({ style });
    };
    draw();
    stage.clear();
    const arrays = stage.upwards(() => {
      stage.show('arrays');
      draw();
    });
    stage.clear();
    stage.show('buffers');
    stage.clear();
    const buffers = stage.upwards(() => {
      stage.show('buffers');
      draw();
      stage.show('buffers', { selected: true });
      draw();
      stage.show('buffers', { preview: true });
      draw();
    });
    return { arrays, buffers };
  }, STYLES);
  // the count counts: 65 × 129 vertices of nine floats at least
  expect(bytes.arrays).toBeGreaterThan(65 * 129 * 36);
  expect(bytes.buffers).toBe(0);
});

test('the GPU says how much is drawn, and nobody else has to know', async () => {
  await page.evaluate(() => window.stage.showHalf());
  const expected = await picture({ style: 'toon' });
  await page.evaluate(() => window.stage.grow());
  const whole = await picture({ style: 'toon' });
  expect(differing(whole, expected)).toBeGreaterThan(0.1);
  await page.evaluate(() => window.stage.halve());
  expect(differing(await picture({ style: 'toon' }), expected)).toBeLessThan(1e-4);
});

test('larger buffers take the place of others, which may be destroyed', async () => {
  await show('arrays');
  const expected = await picture({ style: 'toon' });
  await show('buffers');
  await picture({ style: 'toon' });
  const counts = await page.evaluate(() => {
    const resources: number[] = [];
    for (let i = 0; i < 6; i++) {
      window.stage.grow();
      window.stage.picture({ style: 'toon' });
      resources.push(window.count.resources);
    }
    return resources;
  });
  expect(differing(await picture({ style: 'toon' }), expected)).toBeLessThan(1e-4);
  expect(counts).toEqual(counts.map(() => counts[0]));
});

test('the scene destroys no buffer that is not its own, and leaves none', async () => {
  await show('buffers');
  await picture({ style: 'hbed-ink' });
  const before = await page.evaluate(() => window.count.resources);
  await page.evaluate(() => window.stage.clear());
  expect(await page.evaluate(() => window.stage.areAlive())).toBe(true);
  await show('buffers');
  await picture({ style: 'hbed-ink' });
  expect(await page.evaluate(() => window.count.resources)).toBe(before);
  const left = await page.evaluate(async () => {
    window.stage.keep();
    window.stage.dispose();
    await new Promise((done) => setTimeout(done));
    return { ...window.count };
  });
  expect(left).toMatchObject({ resources: 0, bytes: 0, devices: 0 });
  await page.evaluate(async () => void (await window.openDeviceStage()));
});

test('a pick finds the box', async () => {
  await show('buffers');
  await picture({});
  const middle = await page.evaluate(() => window.stage.pick(128, 128));
  expect(middle).toMatchObject({ id: 'body', normal: [0, 0, 1] });
  expect(middle!.point[2]).toBeCloseTo(60, 3);
  // the box's corner: nothing of the sphere is there
  expect(await page.evaluate(() => window.stage.pick(128 + 75, 128 - 75))).not.toBeNull();
  expect(await page.evaluate(() => window.stage.pick(128 + 78, 128))).toBeNull();
});

test('WebGL2 refuses it in words, and what is there stays', async () => {
  const found = await page.evaluate(async () => {
    const kept = window.stage;
    const stage = await window.openDeviceStage('webgl2');
    stage.show('arrays');
    const before = stage.picture({});
    let message = '';
    try {
      stage.show('buffers');
    } catch (error) {
      message = (error as Error).message;
    }
    const same = stage.picture({}) === before;
    stage.dispose();
    window.stage = kept;
    return { message, same };
  });
  expect(found.message).toContain('needs WebGPU');
  expect(found.same).toBe(true);
});
