/** A test's way to pictures: asks the page for one, decodes it, and knows where points of the model must appear. */
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { type Quat, type Vec3, vec3 } from '../../src/math/vec.ts';
import { FRONT_VIEW } from '../../src/scene/view.ts';
import type { View } from '../../src/stroke/stroke.ts';
import type { Picture } from './main.ts';

export type Rgb = readonly [red: number, green: number, blue: number];

export class Image {
  readonly png: PNG;
  readonly #picture: Picture;

  constructor(png: PNG, picture: Picture) {
    this.png = png;
    this.#picture = picture;
  }

  get pixelRatio(): number {
    return this.#picture.pixelRatio ?? 1;
  }

  /** Colour at a place in CSS pixels, 0–255. */
  at(x: number, y: number): Rgb {
    const column = Math.min(this.png.width - 1, Math.max(0, Math.floor(x * this.pixelRatio)));
    const row = Math.min(this.png.height - 1, Math.max(0, Math.floor(y * this.pixelRatio)));
    const i = 4 * (row * this.png.width + column);
    return [this.png.data[i] ?? 0, this.png.data[i + 1] ?? 0, this.png.data[i + 2] ?? 0];
  }

  /** 0 = white, 1 = black. */
  darkness(x: number, y: number): number {
    const [red, green, blue] = this.at(x, y);
    return 1 - (red + green + blue) / 765;
  }

  /** The darkest place within some CSS pixels. */
  darkest(x: number, y: number, reach: number): number {
    let most = 0;
    const step = 0.5 / this.pixelRatio;
    for (let dy = -reach; dy <= reach; dy += step) {
      for (let dx = -reach; dx <= reach; dx += step) most = Math.max(most, this.darkness(x + dx, y + dy));
    }
    return most;
  }

  /** Middles of all pixels, CSS pixels. */
  *places(): Iterable<readonly [x: number, y: number]> {
    for (let row = 0; row < this.png.height; row++) {
      for (let column = 0; column < this.png.width; column++) {
        yield [(column + 0.5) / this.pixelRatio, (row + 0.5) / this.pixelRatio];
      }
    }
  }

  /** Where a point of the model appears, CSS pixels; orthographic views only. */
  project(point: Vec3): readonly [x: number, y: number] {
    const view: View = { ...FRONT_VIEW, ...this.#picture.view };
    const [width, height] = this.#picture.size ?? [300, 300];
    const [qx, qy, qz, qw] = view.rotation;
    const back: Quat = [-qx, -qy, -qz, qw];
    const away = vec3.subtract([0, 0, 0], point, view.pivot);
    const [x = 0, y = 0] = vec3.transformQuat([0, 0, 0], away, back);
    return [width / 2 + (x * height) / view.height, height / 2 - (y * height) / view.height];
  }
}

export async function draw(page: Page, picture: Picture): Promise<Image> {
  await ready(page);
  const address = await page.evaluate((wanted) => window.drawPicture(wanted), picture);
  return decode(address, picture);
}

/** Pictures as for files, while another one is on the screen. */
export async function take(
  page: Page,
  shown: Picture,
  wanted: readonly Picture[],
): Promise<readonly Image[]> {
  await ready(page);
  const taken = await page.evaluate(([screen, pictures]) => window.takePictures(screen, pictures), [
    shown,
    wanted,
  ] as const);
  return taken.map((address, i) => decode(address, wanted[i] ?? shown));
}

function decode(address: string, picture: Picture): Image {
  return new Image(PNG.sync.read(Buffer.from(address.slice(address.indexOf(',') + 1), 'base64')), picture);
}

export async function openScenePage(page: Page): Promise<void> {
  await page.goto('/e2e/scene/index.html');
  await ready(page);
}

/** The development server may load the page anew when a file changes. */
async function ready(page: Page): Promise<void> {
  await page.waitForFunction(() => typeof window.drawPicture === 'function');
}

/** Distance from a place to a line between two others, CSS pixels. */
export function distanceToLine(
  [x, y]: readonly [number, number],
  [ax, ay]: readonly [number, number],
  [bx, by]: readonly [number, number],
): number {
  const along = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / ((bx - ax) ** 2 + (by - ay) ** 2);
  const t = Math.min(1, Math.max(0, along));
  return Math.hypot(x - ax - t * (bx - ax), y - ay - t * (by - ay));
}
