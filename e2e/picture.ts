/** Pictures as numbers: what is dark, what is not paper, how far it is from a line. */
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import type { Point } from './pen.ts';

export interface Picture {
  readonly width: number;
  readonly height: number;
  /** 0–255 */
  at(x: number, y: number): readonly [r: number, g: number, b: number];
}

/** The drawing alone: controls, hint and ink are hidden, a settled frame is awaited. */
export async function takePicture(page: Page): Promise<Picture & { readonly png: Buffer }> {
  await page.evaluate(async () => {
    const sketch = document.querySelector('rotund-sketch')!;
    const hide = document.createElement('style');
    hide.id = 'picture';
    hide.textContent = '.chrome, .hint, .notice, .ink, .gizmo { visibility: hidden !important; }';
    sketch.shadowRoot!.append(hide);
    sketch.session.frames.wake();
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  });
  const png = await page.locator('rotund-sketch').screenshot();
  await page.evaluate(() =>
    document.querySelector('rotund-sketch')!.shadowRoot!.getElementById('picture')!.remove(),
  );
  return { ...readPicture(png), png };
}

export function readPicture(png: Buffer): Picture {
  const { width, height, data } = PNG.sync.read(png);
  return {
    width,
    height,
    at: (x, y) => {
      const i =
        4 *
        (Math.min(height - 1, Math.max(0, Math.round(y))) * width +
          Math.min(width - 1, Math.max(0, Math.round(x))));
      return [data[i]!, data[i + 1]!, data[i + 2]!];
    },
  };
}

/** Inside a polygon by the even-odd rule. */
export function inside(polygon: readonly Point[], x: number, y: number): boolean {
  let odd = false;
  for (let i = 0, j = polygon.length - 1; i < polygon.length; j = i++) {
    const [ax, ay] = polygon[i]!;
    const [bx, by] = polygon[j]!;
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) odd = !odd;
  }
  return odd;
}

/** Distance from a polyline, pixels. */
export function distanceTo(line: readonly Point[], x: number, y: number): number {
  let least = Number.POSITIVE_INFINITY;
  for (let i = 1; i < line.length; i++) {
    const [ax, ay] = line[i - 1]!;
    const [bx, by] = line[i]!;
    const length = (bx - ax) ** 2 + (by - ay) ** 2;
    const t = length ? Math.max(0, Math.min(1, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length)) : 0;
    least = Math.min(least, Math.hypot(x - ax - t * (bx - ax), y - ay - t * (by - ay)));
  }
  return least;
}
