/** Surfaces from images of rays: the same picture as triangles in every style, and everywhere what is really nearest. */
import { expect, type Page, test } from '@playwright/test';
import { PNG } from 'pngjs';
import { length3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { FRONT_VIEW } from '../../src/scene/view.ts';
import { rayAt } from '../../src/stroke/plane.ts';
import { listen, serious } from '../life/life.ts';
import { BALLS, type ExactPicture, SIZE } from './exactScene.ts';

const STYLES = ['toon', 'gouraud', 'phong', 'hbed-lines', 'hbed-ink'] as const;
const [WIDTH, HEIGHT] = SIZE;
const WHITE = { background: 'white', outline: false } as const;

const read = (address: string): PNG =>
  PNG.sync.read(Buffer.from(address.slice(address.indexOf(',') + 1), 'base64'));

/** −1: nothing, 0: the ball of triangles, 1: that of rays; in the middle of a pixel. */
function nearest(x: number, y: number, { fov = 0, height = 200 }: ExactPicture): number {
  const view = { ...FRONT_VIEW, fov, height };
  const { origin, direction } = rayAt(view, { width: WIDTH, height: HEIGHT }, x + 0.5, y + 0.5);
  const ways = BALLS.map(({ centre, radius }) => toBall(origin, direction, centre, radius));
  const least = Math.min(...ways);
  return least === Infinity ? -1 : ways.indexOf(least);
}

function toBall(from: Vec3, along: Vec3, centre: Vec3, radius: number): number {
  const to = sub3(centre, from);
  const middle = to[0] * along[0] + to[1] * along[1] + to[2] * along[2];
  const off = radius ** 2 - (length3(to) ** 2 - middle ** 2);
  return off > 0 ? middle - Math.sqrt(off) : Infinity;
}

/** Pixels farther than `reach` from any border of what is nearest. */
function* inner(
  picture: ExactPicture,
  reach: number,
): Iterable<readonly [x: number, y: number, what: number]> {
  const what = Array.from({ length: WIDTH * HEIGHT }, (_, i) =>
    nearest(i % WIDTH, Math.floor(i / WIDTH), picture),
  );
  const at = (x: number, y: number) =>
    what[Math.min(Math.max(y, 0), HEIGHT - 1) * WIDTH + Math.min(Math.max(x, 0), WIDTH - 1)]!;
  for (let y = 0; y < HEIGHT; y++)
    for (let x = 0; x < WIDTH; x++) {
      let isInner = true;
      for (let dy = -reach; dy <= reach && isInner; dy++)
        for (let dx = -reach; dx <= reach && isInner; dx++) isInner = at(x + dx, y + dy) === at(x, y);
      if (isInner) yield [x, y, at(x, y)];
    }
}

const rgb = (png: PNG, x: number, y: number): readonly [number, number, number] => {
  const i = 4 * (y * png.width + x);
  return [png.data[i]!, png.data[i + 1]!, png.data[i + 2]!];
};

const apart = (one: PNG, other: PNG, x: number, y: number): number => {
  const [a, b] = [rgb(one, x, y), rgb(other, x, y)];
  return Math.max(...a.map((value, channel) => Math.abs(value - b[channel]!)));
};

/** Yellow, blue or paper. */
function whatIs([red, green, blue]: readonly [number, number, number]): number {
  if (Math.max(red, green, blue) - Math.min(red, green, blue) < 12) return -1;
  return red > blue ? 0 : 1;
}

for (const backend of ['auto', 'webgl2'] as const) {
  test.describe(backend, () => {
    // One page for all: starting the software device costs more than a picture.
    let page: Page;
    let errors: readonly string[];

    test.beforeAll(async ({ browser }) => {
      page = await browser.newPage();
      errors = listen(page);
      await page.goto('/e2e/scene/index.html');
      await page.waitForFunction(() => typeof window.openExactStage === 'function');
      await page.evaluate(async (choice) => void (await window.openExactStage(choice)), backend);
    });
    test.afterAll(() => page.close());
    test.afterEach(() => expect(serious(errors)).toEqual([]));

    const draw = async (picture: ExactPicture): Promise<readonly [mesh: PNG, exact: PNG]> => {
      const [mesh, exact] = await page.evaluate((wanted) => window.exactStage.draw(wanted), picture);
      return [read(mesh), read(exact)];
    };

    for (const fov of [0, 40]) {
      test(`what is nearest is seen in every pixel but at borders, opening ${fov}°`, async () => {
        const picture = { look: { ...WHITE, style: 'phong' }, fov } as const;
        const [, exact] = await draw(picture);
        const wrong = [...inner(picture, 1)].filter(
          ([x, y, what]) => whatIs(rgb(exact, x, y)) !== what && !isShine(exact, x, y),
        );
        expect(wrong).toEqual([]);
      });

      for (const style of STYLES) {
        test(`${style}: the picture of triangles but at borders, opening ${fov}°`, async () => {
          const picture = { look: { background: 'white', style }, fov } as const;
          const [mesh, exact] = await draw(picture);
          let [worst, large] = [0, 0];
          // lines reach as far as their kernels
          for (const [x, y] of inner(picture, 3)) {
            const difference = apart(mesh, exact, x, y);
            worst = Math.max(worst, difference);
            if (difference > 12) large++;
          }
          // a border of bands may move by a part of a pixel
          expect(worst).toBeLessThan(90);
          expect(large).toBeLessThan(60);
          let off = 0;
          for (let y = 0; y < HEIGHT; y++)
            for (let x = 0; x < WIDTH; x++) if (apart(mesh, exact, x, y) > 110) off++;
          expect(off).toBeLessThan(12);
        });
      }
    }

    test('edges are as smooth as those of triangles', async () => {
      const picture = { look: { ...WHITE, style: 'gouraud' } } as const;
      const [mesh, exact] = await draw(picture);
      // between the ball of rays and the paper, and where it goes through the other
      const between = (png: PNG) => {
        let count = 0;
        for (let y = 0; y < HEIGHT; y++) for (let x = 150; x < WIDTH; x++) if (isBetween(png, x, y)) count++;
        return count;
      };
      expect(between(mesh)).toBeGreaterThan(40);
      expect(between(exact)).toBeGreaterThan(0.7 * between(mesh));
    });

    test('a picture for a file is that of the screen', async () => {
      const picture = { look: { style: 'hbed-ink' }, fov: 30 } as const;
      const [, exact] = await draw(picture);
      const file = read(await page.evaluate((wanted) => window.exactStage.file(wanted), picture));
      let off = 0;
      for (let y = 0; y < HEIGHT; y++)
        for (let x = 0; x < WIDTH; x++) if (apart(file, exact, x, y) > 2) off++;
      expect(off).toBeLessThan(20);
    });

    test('an image with fewer pixels covers the same of the picture', async () => {
      const picture = { look: { ...WHITE, style: 'phong' }, cast: [100, 80] } as const;
      const [, exact] = await draw(picture);
      const wrong = [...inner(picture, 3)].filter(
        ([x, y, what]) => whatIs(rgb(exact, x, y)) !== what && !isShine(exact, x, y),
      );
      expect(wrong).toEqual([]);
    });

    test('what is selected has its contour, whatever it is made of', async () => {
      for (const selected of [['rays'], ['triangles'], ['rays', 'triangles']] as const) {
        const [mesh, exact] = await draw({ look: { ...WHITE, style: 'gouraud' }, selected });
        let [pencil, off] = [0, 0];
        for (let y = 0; y < HEIGHT; y++)
          for (let x = 0; x < WIDTH; x++) {
            const [red, , blue] = rgb(mesh, x, y);
            if (blue - red > 120) pencil++;
            if (apart(mesh, exact, x, y) > 110) off++;
          }
        expect(pencil).toBeGreaterThan(200);
        expect(off).toBeLessThan(12);
      }
    });

    test('what is there of an image is seen between the triangles of the rest', async () => {
      const look = { ...WHITE, style: 'phong' } as const;
      const [mesh, exact] = await draw({ look, known: [0.25, 0.5] });
      const rows = Array.from({ length: HEIGHT }, (_, y) => {
        let most = 0;
        for (let x = 0; x < WIDTH; x++) most = Math.max(most, apart(mesh, exact, x, y));
        return most;
      });
      expect(Math.max(...rows.slice(HEIGHT / 2))).toBeLessThan(2);
      expect(rows.slice(60, HEIGHT / 2 - 3).filter((most) => most > 2).length).toBeGreaterThan(20);
    });

    if (backend === 'auto') {
      test('an image in buffers of the device is drawn like one of arrays', async () => {
        const picture = { look: { style: 'toon' } } as const;
        const [, arrays] = await draw(picture);
        const [, buffers] = await draw({ ...picture, from: 'buffers' });
        expect(Buffer.compare(arrays.data, buffers.data)).toBe(0);
      });
    }
  });
}

/** White light on either ball. */
const isShine = (png: PNG, x: number, y: number): boolean => Math.min(...rgb(png, x, y)) > 150;

/** Neither of the colours beside it, but between them. */
function isBetween(png: PNG, x: number, y: number): boolean {
  const [left, here, right] = [x - 1, x, x + 1].map((at) => rgb(png, Math.min(at, WIDTH - 1), y)[0]);
  const [low, high] = [Math.min(left!, right!), Math.max(left!, right!)];
  return high - low > 60 && here! > low + 0.15 * (high - low) && here! < high - 0.15 * (high - low);
}
