/** Pictures for files: what the canvas shows at the same size, and nothing of it on the screen. */
import { expect, type Page, test } from '@playwright/test';
import type { Picture } from './main.ts';
import { draw, type Image, openScenePage, take } from './picture.ts';

// One page for all: starting the software device costs more than a picture.
let page: Page;

test.beforeAll(async ({ browser }) => {
  page = await browser.newPage();
  await openScenePage(page);
});

test.afterAll(() => page.close());

const WANTED: Picture = {
  things: [{ form: { kind: 'pear' } }, { form: { kind: 'stem' }, colour: '#7a5236' }],
  look: { grid: true },
  view: { pivot: [5, 10, 0], height: 150, fov: 30 },
  size: [320, 240],
};

const SCREEN: Picture = {
  things: [{ form: { kind: 'leaf' }, preview: true }, { form: { kind: 'cube', side: 60 } }],
  look: { style: 'hbed-ink', background: 'blue' },
  view: { rotation: [0.2, 0.4, 0, Math.sqrt(0.8)] },
  size: [200, 160],
  pixelRatio: 1.5,
};

/** Share of the pixels that differ by more than one step of 255 in any channel. */
function differing(one: Image, other: Image): number {
  expect([one.png.width, one.png.height]).toEqual([other.png.width, other.png.height]);
  let count = 0;
  for (let i = 0; i < one.png.data.length; i += 4) {
    const far = [0, 1, 2, 3].some((k) => Math.abs(one.png.data[i + k]! - other.png.data[i + k]!) > 1);
    if (far) count++;
  }
  return count / (one.png.width * one.png.height);
}

for (const backend of ['auto', 'webgl2'] as const) {
  const screen = { ...SCREEN, backend };

  test(`equals the canvas in every style and leaves the screen alone, ${backend}`, async () => {
    const before = await draw(page, screen);
    for (const style of ['toon', 'hbed-lines', 'hbed-ink', 'gouraud', 'phong'] as const) {
      const wanted = { ...WANTED, backend, look: { ...WANTED.look, style } };
      const [taken] = await take(page, screen, [wanted]);
      expect(differing(taken!, await draw(page, wanted)), style).toBeLessThan(1e-4);
    }
    expect(differing(before, await draw(page, screen))).toBe(0);
  });

  test(`of any shape, several at once, ${backend}`, async () => {
    const sizes = [
      [17, 23],
      [1000, 16],
      [16, 300],
    ] as const;
    const wanted = sizes.map((size) => ({ ...WANTED, backend, size }));
    const taken = await take(page, screen, wanted);
    for (const [i, image] of taken.entries()) {
      expect(differing(image, await draw(page, wanted[i]!)), String(sizes[i])).toBeLessThan(1e-4);
    }
  });

  test(`leaves out what is not kept, ${backend}`, async () => {
    const preview = { form: { kind: 'leaf' }, preview: true } as const;
    const [taken] = await take(page, screen, [{ ...WANTED, backend, things: [...WANTED.things, preview] }]);
    expect(differing(taken!, await draw(page, { ...WANTED, backend }))).toBeLessThan(1e-4);
  });

  test(`refuses a size it cannot draw, in words, ${backend}`, async () => {
    for (const size of [
      [15, 100],
      [100, 8193],
      [100.5, 100],
      [Number.NaN, 100],
    ] as const) {
      const refused = take(page, screen, [{ ...WANTED, backend, size }]);
      await expect(refused).rejects.toThrow(/A picture has 16 to 8192 pixels a side/);
    }
  });
}
