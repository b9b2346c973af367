/** Bodies through forms made of triangles: the exact surface in the same picture, in every style, on both back ends. */
import { mkdirSync, writeFileSync } from 'node:fs';
import { expect, type Page, test } from '@playwright/test';
import { isBody } from '../../src/document/document.ts';
import { EMPTY_DRAWING, FRONT_VIEW } from '../../src/document/drawing.ts';
import { serialize } from '../../src/document/serialize.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { BALL, documentOf } from '../../tests/cli/drawings.ts';
import { takePicture } from '../picture.ts';

/** A ring that goes through the ball, turned and moved, with a blob on it. */
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

const text = (fov: number) =>
  serialize({
    ...EMPTY_DRAWING,
    name: 'Ball',
    document: {
      ...DOCUMENT,
      parts: DOCUMENT.parts.map((part) => (isBody(part) ? { ...part, placement: PLACEMENT } : part)),
    },
    view: { ...FRONT_VIEW, rotation: [-0.2, -0.3, 0, 0.9327379], fov },
  });

async function rested(page: Page): Promise<void> {
  await expect
    .poll(() => page.evaluate(() => document.querySelector('rotund-sketch')!.session.exact.isWhole), {
      timeout: 60_000,
    })
    .toBe(true);
}

for (const [address, backend] of [
  ['/', 'WebGPU'],
  ['/?backend=webgl2', 'WebGL2'],
] as const) {
  test(`exact, ${backend}`, async ({ page }) => {
    page.on('console', (m) => console.log(m.type(), m.text().slice(0, 1500)));
    page.on('pageerror', (e) => console.log(e));
    await page.setViewportSize({ width: 400, height: 300 });
    await page.goto(address);
    mkdirSync('/tmp/exactpics', { recursive: true });
    for (const fov of [0, 30]) {
      await page.evaluate((d) => document.querySelector('rotund-sketch')!.load(d, { fit: false }), text(fov));
      await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', backend);
      await expect
        .poll(
          () => page.evaluate(() => document.querySelector('rotund-sketch')!.session.bodies.making === null),
          { timeout: 60_000 },
        )
        .toBe(true);
      for (const style of ['toon', 'hbed-lines', 'hbed-ink', 'gouraud'] as const) {
        for (const mode of ['mesh', 'exact'] as const) {
          await page.evaluate(
            ([style, mode]) =>
              document.querySelector('rotund-sketch')!.session.setLook({ style, mode } as never),
            [style, mode],
          );
          if (mode === 'exact') await rested(page);
          const { png } = await takePicture(page);
          writeFileSync(`/tmp/exactpics/${backend}-${fov}-${style}-${mode}.png`, png);
        }
      }
    }
  });
}
