/** The application and the command line write the same files from the same drawing, byte for byte, in every format. */
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, type Page, test } from '@playwright/test';
import { apply, type Command } from '../../src/document/command/index.ts';
import { type Document, EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { serialize } from '../../src/document/serialize.ts';
import { exporters, type Format } from '../../src/export/index.ts';
import { halfCircle, strokeAlong } from '../../tests/document/strokes.ts';
import { drawings } from '../../tests/fixtures/drawings.ts';

const NAME = 'all sorts';
const FORMATS = Object.keys(exporters) as Format[];

/** Strokes with hooks, tremble and corners, open and closed; a ball, turned about no axis of its own; one form not kept. */
function commands(): readonly Command[] {
  const plain = halfCircle(1, 1);
  const tubes = Object.values(drawings).flatMap(({ samples, closed }): Command[] => [
    { type: 'setBrush', change: { colour: '#c83c28', radius: 3.3, pressure: true } },
    { type: 'addStroke', stroke: { ...plain, samples, closed } },
    { type: 'keep' },
  ]);
  const half = Math.SQRT1_2;
  const by = { rotation: [half, 0, 0.5, 0.5], translation: [31.7, -12.3, 5.1] } as const;
  return [
    ...tubes,
    { type: 'addStroke', stroke: halfCircle(33, -1) },
    { type: 'addStroke', stroke: halfCircle(31, 1) },
    { type: 'keep' },
    { type: 'moveParts', ids: ['part-7', 'part-3'], by },
    { type: 'renamePart', id: 'part-1', name: '<b>a wave</b> #1' },
    { type: 'showParts', ids: ['part-2'], visible: false },
    { type: 'addStroke', stroke: strokeAlong((t) => [50 * t, 20]) },
  ];
}

const file = (): string => {
  const document = commands().reduce<Document>(apply, EMPTY_DOCUMENT);
  expect(document.parts).toHaveLength(7);
  return serialize({ ...EMPTY_DRAWING, name: NAME, document });
};

/** Names and bytes of the files that the element exports. */
const fromPage = (page: Page, text: string, format: Format) =>
  page.evaluate(
    async ([drawing, id]) => {
      const sketch = document.querySelector('rotund-sketch')!;
      await sketch.load(drawing);
      const files = await sketch.export(id);
      return files.map(({ name, bytes }) => {
        let binary = '';
        for (const byte of bytes) binary += String.fromCharCode(byte);
        return { name, base64: btoa(binary) };
      });
    },
    [text, format] as const,
  );

test('application and command line write the same bytes', async ({ page }) => {
  test.setTimeout(240_000);
  const folder = mkdtempSync(join(tmpdir(), 'rotund-exports-'));
  try {
    const text = file();
    const input = join(folder, 'in.rotund');
    writeFileSync(input, text);
    await page.goto('/');
    for (const format of FORMATS) {
      const out = join(folder, `${NAME}.${format}`);
      execFileSync(process.execPath, ['scripts/rotund.mjs', 'mesh', input, '-o', out], { stdio: 'pipe' });
      const files = await fromPage(page, text, format);
      expect(files[0]!.name).toBe(`${NAME}.${format}`);
      for (const { name, base64 } of files) {
        const written = readFileSync(join(folder, name));
        expect(written.length).toBeGreaterThan(50);
        expect(Buffer.from(base64, 'base64').equals(written), name).toBe(true);
      }
    }
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});
