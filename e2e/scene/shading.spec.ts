import { expect, type Page, test } from '@playwright/test';
import pixelmatch from 'pixelmatch';
import { displayRgb } from '../../src/scene/look.ts';
import type { Picture } from './main.ts';
import { draw, type Image, openScenePage, type Rgb } from './picture.ts';

// One page for all: starting the software device costs more than a picture.
let page: Page;

test.beforeAll(async ({ browser }) => {
  page = await browser.newPage();
  await openScenePage(page);
});

test.afterAll(() => page.close());

const RADIUS = 70;
const COLOUR = '#d9cb4a';
const SPHERE: Picture = {
  things: [{ form: { kind: 'sphere', radius: RADIUS, rings: 128 }, colour: COLOUR }],
  look: { background: 'white', outline: false },
};

test('the page draws with WebGPU, and with WebGL2 when asked to', async () => {
  expect(await page.evaluate(() => window.backendOf('auto'))).toBe('WebGPU');
  expect(await page.evaluate(() => window.backendOf('webgl2'))).toBe('WebGL2');
});

for (const backend of ['auto', 'webgl2'] as const) {
  test(`toon's bands have exactly their display values, ${backend}`, async () => {
    const image = await draw(page, { ...SPHERE, backend });
    expectBands(image, (band) => band);
  });
}

test('a preview has the same bands at 86 %, no contour and no inside', async () => {
  const things = SPHERE.things.map((thing) => ({ ...thing, preview: true }));
  const image = await draw(page, { ...SPHERE, things, look: { background: 'white', outline: true } });
  expectBands(image, (band) => band.map((value) => 0.86 * value + 0.14 * 255) as unknown as Rgb);
  expect(Math.max(...[...image.places()].map((place) => image.darkness(...place)))).toBeLessThan(0.6);
});

/** Compares every pixel that is well inside a band with the band's colour. */
function expectBands(image: Image, shown: (band: Rgb) => Rgb): void {
  const [x0, y0] = image.project([0, 0, 0]);
  const radius = image.project([RADIUS, 0, 0])[0] - x0;
  const seen = new Set<string>();
  const wrong: string[] = [];
  for (const [x, y] of image.places()) {
    const [nx, ny] = [(x - x0) / radius, (y0 - y) / radius];
    if (Math.hypot(nx, ny) > 0.97) continue;
    const band = bandAt(nx, ny, Math.sqrt(1 - nx * nx - ny * ny));
    if (!band) continue;
    seen.add(band);
    const colour = shown(toonColour(band));
    const drawn = image.at(x, y);
    // half a step for rounding, half for the blending of eight bit values
    if (drawn.some((value, i) => Math.abs(value - (colour[i] ?? 0)) > 1))
      wrong.push(`${band}: ${drawn} at ${x}, ${y}`);
  }
  expect(wrong).toEqual([]);
  expect([...seen].sort()).toEqual(['0.1', '0.3', '0.5', '0.7', 'highlight']);
}

/** The band a normal falls into, null near a border. */
function bandAt(x: number, y: number, z: number): string | null {
  const facing = (-x + y + z) / Math.sqrt(3);
  const length = Math.hypot(-1, 1, 1 + Math.sqrt(3));
  const halfway = (-x + y + (1 + Math.sqrt(3)) * z) / length;
  const edge = 0.8 ** (1 / 40);
  if ([0.1, 0.2, 0.7].some((t) => Math.abs(facing - t) < 0.02) || Math.abs(halfway - edge) < 0.002)
    return null;
  if (halfway > edge) return 'highlight';
  return facing < 0.1 ? '0.1' : facing > 0.7 ? '0.7' : facing > 0.2 ? '0.5' : '0.3';
}

function toonColour(band: string): Rgb {
  const level = band === 'highlight' ? 0.7 : Number(band);
  const ambient = [0.43, 0.43, 0.5];
  const gain = [0.83, 0.82, 0.74];
  return displayRgb(COLOUR).map((value, i) => {
    const lit = Math.min(1, value * ((ambient[i] ?? 0) + (gain[i] ?? 0) * level));
    return 255 * (band === 'highlight' ? lit + 0.75 * (1 - lit) : lit);
  }) as unknown as Rgb;
}

test('both backends draw the same pictures', async () => {
  for (const style of ['toon', 'gouraud', 'phong', 'hbed-lines', 'hbed-ink'] as const) {
    const picture: Picture = {
      things: [
        { form: { kind: 'pear' } },
        { form: { kind: 'stem' }, colour: '#7a5236' },
        { form: { kind: 'leaf' }, colour: '#5da046', preview: true },
      ],
      look: { style, grid: true },
      size: [256, 256],
    };
    const one = await draw(page, picture);
    const other = await draw(page, { ...picture, backend: 'webgl2' });
    const { width, height, data } = one.png;
    const differing = pixelmatch(data, other.png.data, undefined, width, height, { threshold: 0.1 });
    expect(differing / (width * height), style).toBeLessThan(0.005);
  }
});

test('the outline can be switched off', async () => {
  const darkest = async (outline: boolean) => {
    const image = await draw(page, { ...SPHERE, look: { background: 'white', outline } });
    return Math.max(...[...image.places()].map((place) => image.darkness(...place)));
  };
  expect(await darkest(true)).toBeGreaterThan(0.8);
  expect(await darkest(false)).toBeLessThan(0.7);
});

test('papers have their colours, and grain stays within 1.5 %', async () => {
  const corner = async (look: Picture['look']) =>
    draw(page, { things: [], look: look ?? {}, size: [128, 128] });
  expect((await corner({ background: 'white' })).at(5, 5)).toEqual([255, 255, 255]);
  expect((await corner({ background: 'blue' })).at(5, 5)).toEqual([0x19, 0x1e, 0x2b]);
  expect((await corner({ background: 'black' })).at(5, 5)).toEqual([0, 0, 0]);
  expect((await corner({ background: 'paper', grain: false })).at(5, 5)).toEqual([0xf6, 0xf1, 0xe6]);
  const grained = await corner({ background: 'paper' });
  const greens = [...grained.places()].map((place) => grained.at(...place)[1]);
  const mean = greens.reduce((sum, value) => sum + value) / greens.length;
  expect(Math.abs(mean - 0xf1)).toBeLessThan(1.5);
  expect(Math.max(...greens)).toBeLessThanOrEqual(Math.ceil(0xf1 * 1.015));
  expect(Math.min(...greens)).toBeGreaterThanOrEqual(Math.floor(0xf1 * 0.985));
  expect(new Set(greens).size).toBeGreaterThan(3);
});

test('a perspective view has no bright rims', async () => {
  // In the upper left corner of a wide view the form is seen from its lower right: there its normals point away
  // from the plane of the screen, though not from the eye, and must not be flipped into the light.
  for (const style of ['toon', 'phong', 'gouraud'] as const) {
    const image = await draw(page, {
      things: [{ form: { kind: 'sphere', radius: 30, centre: [-60, 60, 0], rings: 128 }, colour: COLOUR }],
      look: { style, background: 'black', outline: false },
      view: { fov: 90 },
    });
    const bright = (away: number) => 1 - image.darkness(60 + away * Math.SQRT1_2, 60 + away * Math.SQRT1_2);
    const shade = bright(35);
    expect(shade, 'the shade of the form').toBeGreaterThan(0.02);
    for (let away = 35; away < 80; away += 0.5) {
      expect(bright(away), `${style} at ${away}`).toBeLessThan(shade + 0.02);
    }
    expect(bright(80), 'the paper').toBe(0);
  }
});

test('a pick finds the point, the normal and the part', async () => {
  const picture: Picture = {
    things: [
      { form: { kind: 'sphere', radius: 50, rings: 96 } },
      { form: { kind: 'sphere', radius: 10, centre: [0, 0, 60] }, preview: true },
    ],
  };
  const preview = await pickIn(page, picture, 150, 150);
  expect(preview?.id).toBe('1');
  expect(preview?.point[2]).toBeCloseTo(70, 1);
  const kept = await pickIn(page, picture, 150 + 60, 150);
  expect(kept?.id).toBe('0');
  expect(kept?.point[0]).toBeCloseTo(40, 1);
  expect(kept?.point[2]).toBeCloseTo(30, 0);
  expect(kept?.normal[0]).toBeCloseTo(0.8, 2);
  expect(await pickIn(page, picture, 5, 5)).toBeNull();
  const perspective = await pickIn(page, { ...picture, view: { fov: 30 } }, 150, 150);
  expect(perspective?.point[2]).toBeCloseTo(70, 1);
});

async function pickIn(page: Page, picture: Picture, x: number, y: number) {
  return page.evaluate(([p, px, py]) => window.pickIn(p, px, py), [picture, x, y] as const);
}
