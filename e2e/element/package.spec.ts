/** `npm pack`, installed into an empty Vite project: two lines of markup show a drawing. */
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, resolve } from 'node:path';
import { expect, test } from '@playwright/test';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { replay, serialize } from '../../src/document/serialize.ts';
import type { RotundSketch } from '../../src/element/rotundSketch.ts';
import type { Stroke } from '../../src/stroke/stroke.ts';
import { type Stage, stagePackage } from '../../tests/package/stage.ts';
import { readPicture } from '../picture.ts';

let stage: Stage;
let project: string;
let server: Server;

test.beforeAll(async () => {
  test.setTimeout(240_000);
  stage = stagePackage();
  project = join(stage.folder, '../project');
  mkdirSync(project);
  stage.run('npm', ['pack', '--ignore-scripts', '--pack-destination', '..']);
  const tarball = readdirSync(join(project, '..')).find((name) => name.endsWith('.tgz'))!;
  writeFileSync(join(project, 'package.json'), '{ "name": "page", "version": "1.0.0", "type": "module" }');
  const quietly = ['--prefer-offline', '--no-audit', '--no-fund', '--ignore-scripts', '--loglevel=error'];
  stage.run('npm', ['install', ...quietly, join('..', tarball)], project);
  mkdirSync(join(project, 'public'));
  writeFileSync(
    join(project, 'public/form.rotund'),
    serialize({ ...EMPTY_DRAWING, name: 'form', document: form() }),
  );
  writeFileSync(
    join(project, 'index.html'),
    `<!doctype html>
<link rel="icon" href="data:,">
<script type="module">import 'rotund/define';</script>
<rotund-sketch src="/form.rotund" alt="A form" readonly style="width: 320px; height: 320px"></rotund-sketch>`,
  );
  stage.run(
    process.execPath,
    [resolve('node_modules/vite/bin/vite.js'), 'build', '--logLevel', 'warn'],
    project,
  );
  server = serve(join(project, 'dist'));
  await new Promise<void>((done) => server.listen(0, '127.0.0.1', done));
});

test.afterAll(() => {
  server?.close();
  stage?.remove();
});

/** Two lines, 40 mm apart. */
function form() {
  const stroke = (x: number): Stroke => ({
    samples: Array.from({ length: 20 }, (_, i) => ({
      x,
      y: 5 * i - 50,
      pressure: 0.5,
      tiltX: 0,
      tiltY: 0,
      time: 8 * i,
    })),
    plane: { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] },
    view: EMPTY_DRAWING.view,
    pointer: 'pen',
    closed: false,
  });
  const add = (x: number) => ({ type: 'addStroke', stroke: stroke(x) }) as const;
  return replay([add(-20), add(20), { type: 'keep' }]);
}

const BALL = {
  type: 'addBody',
  node: { type: 'shape', shape: { type: 'sphere', radius: 30 }, colour: [0.7, 0.05, 0.02] },
} as const;

const TYPES: Readonly<Record<string, string>> = { '.html': 'text/html', '.js': 'text/javascript' };

function serve(folder: string): Server {
  return createServer((request, response) => {
    const path = new URL(request.url ?? '/', 'http://localhost').pathname;
    const file = join(folder, path === '/' ? 'index.html' : path);
    try {
      const body = readFileSync(file);
      response.setHeader('content-type', TYPES[extname(file)] ?? 'application/octet-stream').end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
}

test('an installed package draws a document', async ({ page }) => {
  const complaints: string[] = [];
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  const asked: string[] = [];
  page.on('request', (request) => asked.push(new URL(request.url()).hostname));
  await page.goto(`http://localhost:${(server.address() as AddressInfo).port}/`);
  const sketch = page.locator('rotund-sketch');
  await expect(sketch).toHaveAttribute('data-backend', 'WebGPU');
  // A yellow solid fills the middle of the picture, and none of its corners.
  const saturation = async (x: number, y: number) => {
    const rgb = readPicture(await sketch.screenshot()).at(x, y);
    return Math.max(...rgb) - Math.min(...rgb);
  };
  await expect.poll(() => saturation(160, 160)).toBeGreaterThan(60);
  expect(await saturation(40, 160)).toBeLessThan(40);
  // Bodies are made by the worker that the package brings along.
  const worker = page.waitForEvent('worker');
  await sketch.evaluate(
    async (element, text) => {
      const found = element as RotundSketch;
      await found.load(text);
      await found.export('stl');
    },
    serialize({ ...EMPTY_DRAWING, document: replay([BALL]) }),
  );
  await worker;
  await expect.poll(() => saturation(160, 160)).toBeGreaterThan(60);
  expect(complaints).toEqual([]);
  expect([...new Set(asked)]).toEqual(['localhost']);
});
