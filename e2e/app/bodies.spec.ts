/** Drawings with implicit bodies: opened, seen, taken in hand, exported, on both back ends and without a worker. */
import { readFileSync } from 'node:fs';
import { expect, type Page, test } from '@playwright/test';
import { makeBody } from '../../src/document/bodies.ts';
import { cellsOfBodies, finerCells } from '../../src/document/cells.ts';
import { isBody } from '../../src/document/document.ts';
import { parse } from '../../src/document/serialize.ts';
import { exporters, modelOf } from '../../src/export/index.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { bounds } from '../../src/mesh/measure.ts';
import { takePicture } from '../picture.ts';

const WHALE = readFileSync('public/samples/whale.rotund', 'utf8');

const ball = (radius: number) => ({ type: 'shape', shape: { type: 'sphere', radius }, colour: [0, 0.6, 0] });
const withBodies = (...nodes: readonly object[]): string =>
  JSON.stringify({
    format: 'rotund',
    version: 2,
    document: { parts: nodes.map((node) => ({ kind: 'body', node })) },
  });

const load = (page: Page, text: string) =>
  page.evaluate((drawing) => document.querySelector('rotund-sketch')!.load(drawing), text);

/** Nothing is being made any more. */
const made = (page: Page) =>
  expect
    .poll(
      () => page.evaluate(() => document.querySelector('rotund-sketch')!.session.bodies.making === null),
      {
        timeout: 60_000,
      },
    )
    .toBe(true);

async function open(page: Page, address: string, text: string): Promise<void> {
  await page.goto(address);
  await load(page, text);
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', /WebG/);
  await made(page);
}

const triangles = (page: Page) =>
  page.evaluate(() => document.querySelector('rotund-sketch')!.session.scene!.triangles);

/** Pixels in which one channel of the three stands out. */
async function coloured(page: Page, channel: 0 | 1 | 2): Promise<number> {
  const picture = await takePicture(page);
  let count = 0;
  for (let y = 0; y < picture.height; y += 2)
    for (let x = 0; x < picture.width; x += 2) {
      const rgb = picture.at(x, y);
      if (rgb[channel] - Math.min(...rgb) > 60 && rgb[channel] === Math.max(...rgb)) count++;
    }
  return count;
}

for (const [address, backend] of [
  ['/', 'WebGPU'],
  ['/?backend=webgl2', 'WebGL2'],
] as const) {
  test(`a whale is opened, seen and exported: ${backend}`, async ({ page }) => {
    test.setTimeout(180_000);
    const errors: string[] = [];
    page.on('pageerror', (error) => errors.push(error.message));
    await open(page, address, WHALE);
    await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', backend);
    // a good part of the picture is a blue whale
    expect(await coloured(page, 2)).toBeGreaterThan(4000);
    const base64 = await page.evaluate(async () => {
      const [file] = await document.querySelector('rotund-sketch')!.export('glb');
      let binary = '';
      for (const byte of file!.bytes) binary += String.fromCharCode(byte);
      return btoa(binary);
    });
    const opened = parse(WHALE, 'whale.rotund');
    const cellsOf = cellsOfBodies(opened.document);
    for (const { node } of opened.document.parts.filter(isBody)) {
      makeBody(node, finerCells(makeBody(node, cellsOf(node))));
    }
    const [expected] = await exporters.glb.write(modelOf(opened.document, opened.name));
    expect(Buffer.from(base64, 'base64').equals(expected!.bytes)).toBe(true);
    expect(errors).toEqual([]);
  });
}

test('a body is selected, coloured, moved, hidden, deleted and brought back like any part', async ({
  page,
}) => {
  await open(page, '/', withBodies(ball(30)));
  expect(await coloured(page, 1)).toBeGreaterThan(4000);
  await page.getByRole('button', { name: 'Parts, 1' }).click();
  const row = page.getByRole('row', { name: /^Body 1, Body, shapes only/ });
  await row.click();
  await expect(row).toHaveAttribute('aria-selected', 'true');
  await expect(page.locator('.card-of-part')).toContainText('Several');
  await expect(page.locator('.card-of-part')).toContainText('Implicit body');
  await page.getByRole('radio', { name: 'Red' }).click();
  await expect.poll(() => coloured(page, 0)).toBeGreaterThan(4000);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(() => coloured(page, 1)).toBeGreaterThan(4000);
  await page.getByRole('button', { name: 'Move along X' }).focus();
  await page.keyboard.press('Shift+ArrowRight');
  const moved = await page.evaluate(
    () => document.querySelector('rotund-sketch')!.document.parts[0]!.placement,
  );
  expect(moved.translation[0]).toBeCloseTo(10, 9);
  await page.getByRole('button', { name: 'Hide Body 1' }).click();
  await expect.poll(() => coloured(page, 1)).toBe(0);
  await page.getByRole('button', { name: 'Undo' }).click();
  await row.click();
  await page.keyboard.press('Delete');
  await expect.poll(() => coloured(page, 1)).toBe(0);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(() => coloured(page, 1)).toBeGreaterThan(4000);
});

test('the fine body is what stays, after whatever was shown before it', async ({ page }) => {
  await page.goto('/');
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', /WebG/);
  const seen = await page.evaluate(
    async (text) => {
      const sketch = document.querySelector('rotund-sketch')!;
      const counts = new Set<number>();
      let on = true;
      const look = () => {
        counts.add(sketch.session.scene!.triangles);
        if (on) requestAnimationFrame(look);
      };
      look();
      await sketch.load(text);
      await sketch.session.bodies.settled();
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      on = false;
      return [...counts].filter((count) => count > 0);
    },
    withBodies(ball(30)),
  );
  expect(seen.length).toBeGreaterThan(0);
  expect(Math.max(...seen)).toBe(await triangles(page));
  // a draft of 28 cells has some 5,000
  expect(await triangles(page)).toBeGreaterThan(30_000);
});

test('what is replaced is no longer made', async ({ page }) => {
  await page.goto('/');
  await load(page, WHALE);
  await load(page, withBodies(ball(20)));
  await made(page);
  const { parts } = await page.evaluate(() => document.querySelector('rotund-sketch')!.document);
  expect(parts.map(({ name }) => name)).toEqual(['Body 1']);
  const [file] = await page.evaluate(() => document.querySelector('rotund-sketch')!.export('stl'));
  expect(Object.keys(file!.bytes).length).toBeGreaterThan(1000);
});

test('a body without a surface is told of, and stays in the drawing', async ({ page }) => {
  const hollow = { type: 'subtraction', form: 'hard', parts: [ball(10), ball(20)] };
  await open(page, '/', withBodies(ball(30), hollow));
  await expect(page.getByRole('alert')).toContainText(
    'Body 2 could not be made: Its field is nowhere above 0',
  );
  const { parts } = await page.evaluate(() => document.querySelector('rotund-sketch')!.document);
  expect(parts).toHaveLength(2);
  expect(await coloured(page, 1)).toBeGreaterThan(4000);
});

test('what the picture lacks of bodies is told: in the status line once, in the list and on the card of each', async ({
  page,
}) => {
  const needle = { type: 'shape', shape: { type: 'capsule', radius: 0.5, half: 50 } };
  const ground = { type: 'shape', shape: { type: 'halfSpace', normal: [0, 1, 0], offset: -60 } };
  await open(page, '/', withBodies(needle, ground));
  await expect(page.locator('.status [role=status]')).toContainText(
    /^Body 1: hardly thicker.* And another part: see Parts/,
  );
  await page.getByRole('button', { name: 'Parts, 2' }).click();
  await expect(page.getByRole('row', { name: /^Body 2.*cut off/ })).toBeVisible();
  await page.getByRole('row', { name: /^Body 1.*thin/ }).click();
  await expect(page.getByText('pieces may be missing')).toHaveCount(1);
  const flaws = await page.evaluate(() => document.querySelector('rotund-sketch')!.flaws);
  expect(flaws.map(({ name, what }) => [name, what])).toEqual([
    ['Body 1', 'thin'],
    ['Body 2', 'cut'],
  ]);
});

test('a file with a tree that makes no field is refused with its place', async ({ page }) => {
  await page.goto('/');
  const message = await page.evaluate(
    (text) =>
      document
        .querySelector('rotund-sketch')!
        .load(text, { name: 'bad.rotund' })
        .catch((error: Error) => error.message),
    withBodies({ type: 'union', form: 'hard', parts: [ball(3), ball(-1)] }),
  );
  expect(message).toBe(
    'bad.rotund, document.parts[0].node.parts[1].shape: makes no field: radius must be above 0 mm, got -1',
  );
});

test('without workers the page makes bodies itself', async ({ page }) => {
  await page.addInitScript(() => Reflect.deleteProperty(window, 'Worker'));
  await open(page, '/', withBodies(ball(30)));
  expect(await coloured(page, 1)).toBeGreaterThan(4000);
});

test('a body that a script adds is where the script says', async ({ page }) => {
  await page.goto('/');
  const script = [
    { type: 'addBody', node: ball(10), name: 'Ball', colour: '#4a7ab8' },
    { type: 'moveParts', ids: ['part-1'], by: { translation: [7, 0, 0] } },
  ];
  await load(page, JSON.stringify(script));
  await made(page);
  const { document } = await page.evaluate(() => window.document.querySelector('rotund-sketch')!.drawing);
  for (const { node } of document.parts.filter(isBody)) makeBody(node, 32);
  expect(bounds(modelOf(document, 'x').solids[0]!.mesh).max[0]).toBeCloseTo(17, 2);
  expect(await coloured(page, 2)).toBeGreaterThan(4000);
});

test('a file without a view fills the window, even with what no draft shows', async ({ page }) => {
  const plate = { type: 'shape', shape: { type: 'box', half: [300, 1.5, 300] }, colour: [0, 0.6, 0] };
  const far = { type: 'affine', matrix: [1, 0, 0, 5000, 0, 0.8, -0.6, 0, 0, 0.6, 0.8, 0], node: plate };
  await open(page, '/', withBodies(far));
  const view = await page.evaluate(() => document.querySelector('rotund-sketch')!.session.view);
  expect(view.height).toBeGreaterThan(400);
  expect(view.height).toBeLessThan(1200);
  expect(Math.abs(view.pivot[0] - 5000)).toBeLessThan(100);
  expect(await coloured(page, 1)).toBeGreaterThan(10_000);
  // 0.6 cells of 128, 1.3 of twice as many
  await page.getByRole('button', { name: 'Parts, 1' }).click();
  await page.getByRole('row', { name: /^Body 1/ }).click();
  await expect(page.getByText('Hardly thicker than a cell or two in 1 place')).toBeVisible();
});

test('a body whose tree is replaced is edited, undone and redone; files are of what is made at once', async ({
  page,
}) => {
  const limb = (x: number): FieldNode => ({
    type: 'affine',
    matrix: [1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0],
    node: { type: 'shape', shape: { type: 'sphere', radius: 6 }, colour: [0, 0.6, 0] },
  });
  const row = (last: number): FieldNode => ({
    type: 'union',
    form: 'hard',
    parts: [...Array.from({ length: 9 }, (_, i) => limb(10 * i)), limb(last)],
  });
  await open(page, '/', withBodies(row(90)));
  // the picture follows a frame later
  await expect.poll(() => triangles(page)).toBeGreaterThan(30_000);
  const full = await triangles(page);
  const after = await page.evaluate(async (node) => {
    const sketch = document.querySelector('rotund-sketch')!;
    const { bodies } = sketch.session;
    const counts: number[] = [];
    const next = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const see = async () => {
      // what was there before is there at once
      await next();
      counts.push(sketch.session.scene!.triangles);
      await bodies.settled();
      await next();
      counts.push(sketch.session.scene!.triangles);
    };
    sketch.run({ type: 'setBody', id: 'part-1', node });
    await see();
    sketch.undo();
    await see();
    sketch.redo();
    await see();
    const [file] = await sketch.export('stl');
    return { counts, bytes: Array.from(file!.bytes) };
  }, row(96));
  for (const count of after.counts) expect(count).toBeGreaterThan(0.8 * full);
  expect(after.counts.at(3)).toBe(full);
  const drawing = parse(withBodies(row(96)), 'row.rotund');
  for (const { node } of drawing.document.parts.filter(isBody)) makeBody(node);
  const [expected] = await exporters.stl.write(modelOf(drawing.document, drawing.name));
  expect(Buffer.from(after.bytes).equals(expected!.bytes)).toBe(true);
});
