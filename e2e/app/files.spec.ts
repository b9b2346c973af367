/** Files in the hand: opened, dropped, saved, kept over a reload, guarded, exported. */
import { readFile } from 'node:fs/promises';
import AxeBuilder from '@axe-core/playwright';
import { type Download, expect, type Page, test } from '@playwright/test';
import { solids } from '../../src/document/build.ts';
import { parse } from '../../src/document/serialize.ts';
import { screenBox } from '../../src/element/place.ts';
import { exporters, modelOf } from '../../src/export/index.ts';
import { PenDriver, type Point } from '../pen.ts';
import { readPicture, takePicture } from '../picture.ts';

const SAMPLES = 'public/samples';
const STROKE: readonly Point[] = Array.from({ length: 30 }, (_, i) => [420, 180 + 7 * i]);
const OTHER: readonly Point[] = STROKE.map(([x, y]) => [x + 160, y]);

/** Without the browser's own dialogs: a file input and downloads, which a test can answer. */
async function open(page: Page, dialogs: 'inputs' | 'own' = 'inputs'): Promise<void> {
  if (dialogs === 'inputs')
    await page.addInitScript(() => {
      for (const name of ['showOpenFilePicker', 'showSaveFilePicker']) Reflect.deleteProperty(window, name);
    });
  await page.goto('/');
  await expect(page.getByRole('button', { name: 'Drawings' })).toBeVisible();
}

/** Files need none; it comes when it comes. */
const pictured = (page: Page) =>
  expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', /WebG/);

/** As autosave does it, at any moment. */
const updated = (page: Page) =>
  page.evaluate(async () => {
    const sketch = document.querySelector('rotund-sketch')!;
    sketch.requestUpdate();
    await sketch.updateComplete;
  });

const drawing = (page: Page) => page.evaluate(() => document.querySelector('rotund-sketch')!.drawing);
const status = (page: Page) => page.getByRole('status');
const title = (page: Page) => page.getByRole('button', { name: /: file$/ });
const alert = (page: Page) => page.getByRole('alert');
const kept = (page: Page) => expect(title(page)).toContainText('Kept');

async function draw(page: Page, ...strokes: readonly (readonly Point[])[]): Promise<void> {
  const pen = await PenDriver.on(page);
  for (const stroke of strokes) await pen.draw(stroke);
}

async function textOf(download: Download): Promise<string> {
  return readFile(await download.path(), 'utf8');
}

interface Dropped {
  readonly name: string;
  readonly text: string;
}

/** `hold`: they hang over the page, which hears of it many times a second, as from a hand that waits. */
async function drag(page: Page, what: 'hold' | 'drop', files: readonly Dropped[]): Promise<void> {
  await page.locator('rotund-sketch').evaluate(
    (sketch, { what, files }) => {
      const send = (type: string) => {
        const dataTransfer = new DataTransfer();
        for (const { name, text } of files) dataTransfer.items.add(new File([text], name));
        sketch.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
      };
      clearInterval(Number(sessionStorage.getItem('drag')));
      if (what === 'drop') send('drop');
      else sessionStorage.setItem('drag', String(setInterval(() => send('dragover'), 50)));
    },
    { what, files },
  );
}

/** What the page complains of, in the console or by an exception. */
function complaints(page: Page): string[] {
  const found: string[] = [];
  page.on('console', (message) => message.type() === 'error' && found.push(message.text()));
  page.on('pageerror', (error) => found.push(String(error)));
  return found;
}

test('a file is opened over a drawing, all of it is seen, and undo brings the drawing back', async ({
  page,
}) => {
  await open(page);
  await pictured(page);
  await draw(page, STROKE);
  const before = await drawing(page);
  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'Drawings' }).click();
  await page.getByRole('button', { name: 'Open a file' }).click();
  await (await chooser).setFiles(`${SAMPLES}/candle.rotund`);
  await expect(status(page)).toContainText('Candle opened. Undo brings back your drawing');
  const file = parse(await readFile(`${SAMPLES}/candle.rotund`, 'utf8'), 'candle.rotund');
  expect((await drawing(page)).document).toEqual(file.document);
  await expect(page).toHaveTitle(/^Candle/);
  await expect(title(page)).toContainText('Saved');
  await expect.poll(() => frame(page)).toMatchObject({ inside: true, large: true });
  await page.getByRole('button', { name: 'Undo' }).click();
  expect(await drawing(page)).toMatchObject({ name: before.name, document: before.document });
  await page.getByRole('button', { name: 'Redo' }).click();
  expect((await drawing(page)).name).toBe('Candle');
});

/** Is every form within the picture, and does it fill it? Measured by projecting the vertices. */
async function frame(page: Page) {
  const { shown, view, size } = await page.evaluate(() => {
    const { document: shown, session } = document.querySelector('rotund-sketch')!;
    return { shown, view: session.view, size: session.size };
  });
  const meshes = solids(shown).map(({ mesh }) => mesh);
  const { left, right, top, bottom } = screenBox(meshes, view, size)!;
  return {
    inside: left >= 0 && top >= 0 && right <= size.width && bottom <= size.height,
    large: Math.max((right - left) / size.width, (bottom - top) / size.height) > 0.4,
  };
}

test('files are dropped: a veil, then the first of them', async ({ page }) => {
  await open(page);
  const text = await readFile(`${SAMPLES}/pear.rotund`, 'utf8');
  await drag(page, 'hold', [{ name: 'a.rotund', text }]);
  await expect(page.getByText('Drop a drawing to open it')).toBeVisible();
  await drag(page, 'drop', [
    { name: 'a.rotund', text },
    { name: 'b.rotund', text: 'not this one' },
  ]);
  await expect(status(page)).toContainText('a.rotund opened, the first of 2 files');
  await expect(page.getByText('Drop a drawing to open it')).toBeHidden();
  expect((await drawing(page)).document).toEqual(parse(text, 'a.rotund').document);
});

test('what is no drawing changes nothing: a message, and no exception', async ({ page }) => {
  const errors = complaints(page);
  await open(page);
  await draw(page, STROKE);
  const before = await drawing(page);
  const bad: readonly Dropped[] = [
    { name: 'photo.png', text: '\u0089PNG\r\n\u001a\n' },
    { name: 'empty.rotund', text: '' },
    { name: 'newer.rotund', text: '{"format":"rotund","version":9}' },
    { name: '<img src=x onerror=alert(1)>.rotund', text: '[{"type":"<b>none</b>"}]' },
  ];
  for (const file of bad) {
    await drag(page, 'drop', [file]);
    await expect(alert(page)).toContainText(file.name);
    await expect(alert(page).getByRole('button', { name: 'Open another' })).toBeVisible();
    expect(await drawing(page)).toEqual(before);
    await alert(page).getByRole('button', { name: 'Close' }).click();
  }
  expect(
    await page.evaluate(
      () => document.querySelector('rotund-sketch')!.shadowRoot!.querySelectorAll('img[src=x]').length,
    ),
  ).toBe(0);
  expect(errors).toEqual([]);
});

test('a name is text, whatever it says', async ({ page }) => {
  const errors = complaints(page);
  await open(page);
  const pear = JSON.parse(await readFile(`${SAMPLES}/pear.rotund`, 'utf8'));
  const name = '<img src=x onerror="document.title=1">';
  await drag(page, 'drop', [{ name: 'pear.rotund', text: JSON.stringify({ ...pear, name }) }]);
  await expect(title(page)).toContainText(name);
  await expect(page).toHaveTitle(`${name} – Rotund`);
  expect(errors).toEqual([]);
});

test('saving writes what is drawn, under its name, and says where it is', async ({ page }) => {
  await open(page);
  await draw(page, STROKE, OTHER);
  await title(page).click();
  await page.getByRole('textbox', { name: 'Name' }).fill('Plum/pear');
  await updated(page);
  await page.keyboard.press('Enter');
  await expect(page.getByRole('dialog')).toBeHidden();
  const download = page.waitForEvent('download');
  await page.locator('.stage').focus();
  await page.keyboard.press('Control+s');
  const file = await download;
  expect(file.suggestedFilename()).toBe('Plum-pear.rotund');
  expect(parse(await textOf(file), 'plum.rotund')).toEqual(await drawing(page));
  await expect(title(page)).toContainText('Plum/pear Saved');
  await page.getByRole('button', { name: 'Keep' }).click();
  await expect(title(page)).not.toContainText('Saved');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(title(page)).toContainText('Saved');
  const script = page.waitForEvent('download');
  await title(page).click();
  await page.getByRole('button', { name: 'Save the way it was drawn' }).click();
  expect((await script).suggestedFilename()).toBe('Plum-pear.script.rotund');
  expect(parse(await textOf(await script), 'script').document).toEqual((await drawing(page)).document);
});

test('saving again writes the same file, also after a reload', async ({ page }) => {
  // Files of the browser's private folder: real ones, without a dialog to answer.
  await page.addInitScript(() => {
    const pick = async () => {
      const asked = Number(sessionStorage.getItem('asked')) + 1;
      sessionStorage.setItem('asked', String(asked));
      const folder = await navigator.storage.getDirectory();
      return folder.getFileHandle('Quince.rotund', { create: true });
    };
    Object.assign(window, { showSaveFilePicker: pick, showOpenFilePicker: async () => [await pick()] });
  });
  const written = () =>
    page.evaluate(async () => {
      const folder = await navigator.storage.getDirectory();
      return (await (await folder.getFileHandle('Quince.rotund')).getFile()).text();
    });
  await open(page, 'own');
  await draw(page, STROKE);
  await page.keyboard.press('Control+s');
  await expect(title(page)).toContainText('Quince Saved');
  expect(parse(await written(), 'quince')).toEqual(await drawing(page));
  await draw(page, OTHER);
  await kept(page);
  await page.reload();
  await expect(title(page)).toContainText('Quince Kept');
  await page.locator('.stage').focus();
  await page.keyboard.press('Control+s');
  await expect(title(page)).toContainText('Quince Saved');
  expect(parse(await written(), 'quince').document).toEqual((await drawing(page)).document);
  expect(await page.evaluate(() => sessionStorage.getItem('asked'))).toBe('1');
});

test('a reload brings everything back: forms, the unfinished one, name, view and look', async ({ page }) => {
  await open(page);
  await pictured(page);
  await draw(page, STROKE, OTHER);
  await page.getByRole('button', { name: 'Keep' }).click();
  await draw(
    page,
    STROKE.map(([x, y]) => [x + 100, y + 20]),
  );
  await page.evaluate(() => {
    const { session, files } = document.querySelector('rotund-sketch')!;
    files.saving.rename('Half a pear');
    session.setStyle('hbed-ink', 'Ink');
    session.camera.orbit(37, 21);
    session.camera.zoom(1.3, 321, 234);
  });
  // The camera comes to rest before the page goes.
  const rest = () => page.evaluate(() => document.querySelector('rotund-sketch')!.session.scene!.rig.moving);
  await expect.poll(rest).toBe(false);
  const before = await drawing(page);
  await kept(page);
  await page.reload();
  await expect(title(page)).toContainText('Half a pear Kept');
  expect(await drawing(page)).toEqual(before);
  await pictured(page);
  expect(await drawing(page)).toEqual(before);
  await expect(page.getByRole('group', { name: 'Tube, preview' })).toBeVisible();
  await expect(page.getByRole('button', { name: 'Undo' })).toHaveAttribute('aria-disabled', 'true');
});

test('what was replaced comes back, also after a reload', async ({ page }) => {
  await open(page);
  await draw(page, STROKE, OTHER);
  const { document: before } = await drawing(page);
  await page.getByRole('button', { name: 'Drawings' }).click();
  await page.getByRole('button', { name: /^Pear/ }).click();
  await expect(status(page)).toContainText('Pear opened');
  await kept(page);
  await page.reload();
  await kept(page);
  await page.getByRole('button', { name: 'Drawings' }).click();
  await page.getByRole('button', { name: 'Previous drawing' }).click();
  await expect.poll(async () => (await drawing(page)).document).toEqual(before);
});

test('a stored drawing that cannot be read is not lost, and the page goes on', async ({ page }) => {
  const errors = complaints(page);
  const broken = '{"format":"rotund","version":1,"document":{"parts":[{"kind":"<b>"}]}}';
  await open(page);
  await draw(page, STROKE);
  await kept(page);
  // From a page without the program: it would write what comes later, as a view that has only just come to rest.
  await page.route('**/favicon.ico', (route) => route.fulfill({ status: 204 }));
  await page.goto('/samples/index.json');
  await page.evaluate(async (text) => {
    const database = await new Promise<IDBDatabase>((resolve) => {
      const request = indexedDB.open('rotund');
      request.onsuccess = () => resolve(request.result);
    });
    const store = database.transaction('drawings', 'readwrite').objectStore('drawings');
    await new Promise<void>((resolve) => {
      const got = store.get('drawing/current');
      got.onsuccess = () => {
        store.put({ ...got.result, text, name: 'Pear' }, 'drawing/current').onsuccess = () => resolve();
      };
    });
    database.close();
  }, broken);
  await page.goto('/');
  await expect(alert(page)).toContainText('could not be read');
  await draw(page, OTHER);
  await kept(page);
  const download = page.waitForEvent('download');
  await alert(page).getByRole('button', { name: 'Save it as a file' }).click();
  expect((await download).suggestedFilename()).toBe('Pear.unreadable.rotund');
  expect(await textOf(await download)).toBe(broken);
  await page.reload();
  await kept(page);
  expect((await drawing(page)).document.draft?.strokes).toHaveLength(1);
  await expect(alert(page)).toBeHidden();
  expect(errors).toEqual([]);
});

const STORES = {
  full: {
    says: 'Not saved: storage is full.',
    break: () => {
      IDBObjectStore.prototype.put = () => {
        throw new DOMException('full', 'QuotaExceededError');
      };
    },
  },
  'not there': {
    says: 'Not saved: this browser does not let the page keep drawings.',
    break: () => {
      IDBFactory.prototype.open = () => {
        throw new DOMException('blocked', 'SecurityError');
      };
    },
  },
} as const;

for (const [store, { says, break: breakStore }] of Object.entries(STORES)) {
  test(`with a store that is ${store} the page asks before it goes, until there is a file`, async ({
    page,
  }) => {
    await page.addInitScript(breakStore);
    await open(page);
    expect(await asks(page)).toBe(false);
    await draw(page, STROKE);
    await expect(alert(page)).toContainText(says);
    await expect(title(page)).toContainText('Not saved');
    expect(await asks(page)).toBe(true);
    const download = page.waitForEvent('download');
    await alert(page).getByRole('button', { name: 'Save a copy' }).click();
    await download;
    await expect(title(page)).toContainText('Saved');
    expect(await asks(page)).toBe(false);
  });
}

/** Whether the page would keep a person from leaving. */
const asks = (page: Page) =>
  page.evaluate(() => !window.dispatchEvent(new Event('beforeunload', { cancelable: true })));

test('a page that is kept closes without a question, one that is not asks', async ({ page, context }) => {
  await open(page);
  await draw(page, STROKE);
  await kept(page);
  const closed = page.waitForEvent('close');
  await page.close({ runBeforeUnload: true });
  await closed;
  const other = await context.newPage();
  await other.addInitScript(STORES.full.break);
  await open(other);
  await draw(other, OTHER);
  await expect(alert(other)).toBeVisible();
  const dialog = other.waitForEvent('dialog');
  await other.close({ runBeforeUnload: true });
  expect((await dialog).type()).toBe('beforeunload');
  await (await dialog).accept();
});

test('of two tabs one keeps the drawing; the other may take over or be a copy', async ({ page, context }) => {
  await open(page);
  await draw(page, STROKE);
  await kept(page);
  const other = await context.newPage();
  await open(other);
  await expect(alert(other)).toContainText('Open in another tab');
  expect((await drawing(other)).document).toEqual((await drawing(page)).document);
  await alert(other).getByRole('button', { name: 'Open a copy' }).click();
  await expect(title(other)).toContainText('Drawing copy Not saved');
  await title(other).click();
  await other.getByRole('button', { name: 'Take over' }).click();
  await expect(status(other)).toContainText('This tab keeps the drawing now');
  await expect(alert(page)).toContainText('Open in another tab');
  await expect(title(other)).toContainText('Drawing copy Kept');
  await draw(page, OTHER);
  await expect(title(page)).toContainText('Not saved');
});

test('the gallery lets the pen draw between its cards, and a card opens its drawing', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 960 });
  await open(page);
  await pictured(page);
  const cards = page.getByRole('region', { name: 'Samples' }).getByRole('listitem');
  const list: readonly { readonly name: string; readonly strokes: number }[] = JSON.parse(
    await readFile(`${SAMPLES}/index.json`, 'utf8'),
  );
  await expect(cards).toHaveCount(list.length);
  const [first, second] = [(await cards.nth(0).boundingBox())!, (await cards.nth(1).boundingBox())!];
  const x = (first.x + first.width + second.x) / 2;
  await draw(
    page,
    Array.from({ length: 30 }, (_, i) => [x, first.y + first.height / 2 - 8 * i]),
  );
  await expect(cards.first()).toBeHidden();
  expect((await drawing(page)).document.draft?.strokes).toHaveLength(1);
  await page.keyboard.press('Escape');
  await cards.filter({ hasText: 'Paprika' }).click();
  await expect(status(page)).toContainText('Paprika opened');
  await expect(cards.first()).toBeHidden();
  const picture = await takePicture(page);
  const [r, g, b] = picture.at(640, 480);
  expect(Math.max(r, g, b) - Math.min(r, g, b)).toBeGreaterThan(40);
});

test('every export is, byte for byte, what the registry writes', async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: /^Laser gun/ }).click();
  await expect(title(page)).toContainText('Laser gun');
  await page.getByRole('button', { name: 'More' }).click();
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  const { document, name } = await drawing(page);
  for (const { label, write } of Object.values(exporters)) {
    const expected = await write(modelOf(document, name));
    const downloads: Download[] = [];
    const collect = (download: Download) => downloads.push(download);
    page.on('download', collect);
    await page.getByRole('button', { name: label }).click();
    await expect.poll(() => downloads.length).toBe(expected.length);
    page.off('download', collect);
    for (const file of expected) {
      const download = downloads.find((one) => one.suggestedFilename() === file.name);
      const bytes = await readFile(await download!.path());
      expect(Buffer.compare(bytes, Buffer.from(file.bytes))).toBe(0);
    }
    await expect(status(page)).toContainText(expected[0]!.name);
  }
});

test('what an export leaves out is said before', async ({ page }) => {
  await open(page);
  const toExports = async () => {
    await page.getByRole('button', { name: 'More' }).click();
    await page.getByRole('button', { name: 'Export', exact: true }).click();
  };
  await toExports();
  await expect(page.getByRole('dialog')).toContainText('Nothing to export yet');
  await draw(page, STROKE, OTHER);
  await toExports();
  await expect(page.getByRole('dialog')).toContainText('left out until you keep it');
  await page.getByRole('button', { name: 'Keep it' }).click();
  await expect(page.getByRole('button', { name: /^STL/ })).toBeVisible();
  await expect(page.getByRole('dialog')).not.toContainText('left out');
});

test('a picture has the size of the screen, or the longer side that was asked for', async ({ page }) => {
  await open(page);
  await draw(page, STROKE, OTHER);
  await page.getByRole('button', { name: 'Keep' }).click();
  await page.evaluate(() => document.querySelector('rotund-sketch')!.toggle('export'));
  const first = page.waitForEvent('download');
  await page.getByRole('button', { name: 'As on the screen' }).click();
  const { width, height, at } = readPicture(await readFile(await (await first).path()));
  expect([width, height]).toEqual([800, 600]);
  const [r, g, b] = at((420 + 580) / 2, 280);
  expect(Math.max(r, g, b) - Math.min(r, g, b)).toBeGreaterThan(40);
  // Large ones take a software adapter long: what is asked for is enough.
  await page.evaluate(() => {
    const sketch = document.querySelector('rotund-sketch')!;
    sketch.picture = async (shot) => new Blob([JSON.stringify(shot)]);
  });
  const second = page.waitForEvent('download');
  await page.getByRole('button', { name: /^2048/ }).click();
  expect(JSON.parse(await textOf(await second))).toEqual({ width: 2048, height: 1536 });
});

test('panels take the focus and give it back', async ({ page }) => {
  await open(page);
  await draw(page, STROKE);
  const focused = () =>
    page.evaluate(() => {
      const active = document.querySelector('rotund-sketch')!.shadowRoot!.activeElement;
      return active?.closest('.panel') ? 'panel' : (active?.getAttribute('aria-label') ?? active?.className);
    });
  for (const name of ['Drawings', 'More', 'Parts']) {
    const button = page.getByRole('button', { name }).first();
    await button.focus();
    await page.keyboard.press('Enter');
    await expect.poll(focused).toBe('panel');
    await page.keyboard.press('Escape');
    await expect.poll(focused).toMatch(name);
  }
  await page.getByRole('button', { name: 'More' }).click();
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  await expect.poll(focused).toBe('panel');
  await page.keyboard.press('Escape');
  await expect.poll(focused).toBe('More');
});

/** Colours that change with the theme have arrived. */
const painted = (page: Page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

async function violations(page: Page): Promise<string[]> {
  const { violations: found } = await new AxeBuilder({ page }).analyze();
  return found.map(({ id, nodes }) => `${id}: ${nodes[0]?.target} ${nodes[0]?.failureSummary}`);
}

for (const scheme of ['light', 'dark'] as const) {
  test(`every panel of files is accessible and within reach, also on a phone, ${scheme}`, async ({
    page,
  }) => {
    await page.emulateMedia({ colorScheme: scheme, reducedMotion: 'reduce' });
    await open(page);
    await draw(page, STROKE, OTHER);
    await page.getByRole('button', { name: 'Keep' }).click();
    for (const panel of ['drawings', 'file', 'export'] as const) {
      await page.evaluate((name) => document.querySelector('rotund-sketch')!.toggle(name), panel);
      await expect(page.getByRole('dialog')).toBeVisible();
      await painted(page);
      expect(await violations(page)).toEqual([]);
      for (const size of SIZES) {
        await page.setViewportSize(size);
        expect(await small(page)).toEqual([]);
      }
      await page.evaluate((name) => document.querySelector('rotund-sketch')!.toggle(name), panel);
    }
  });
}

const SIZES = [
  { width: 320, height: 640 },
  { width: 1024, height: 768 },
] as const;

/** Controls of the open panel that a finger misses. */
const small = (page: Page) =>
  page.getByRole('dialog').evaluate((dialog) =>
    [...dialog.querySelectorAll('button, input')]
      .filter((control) => {
        const { width, height } = control.getBoundingClientRect();
        return width < 43.5 || height < 43.5;
      })
      .map((control) => control.textContent?.trim() || control.className),
  );

test('where people only look nothing can be opened or dropped', async ({ page }) => {
  await open(page);
  await draw(page, STROKE);
  await page.evaluate(() => {
    document.querySelector('rotund-sketch')!.readOnly = true;
  });
  await expect(page.getByRole('button', { name: 'Drawings' })).toBeHidden();
  await drag(page, 'hold', [{ name: 'a.rotund', text: '' }]);
  await drag(page, 'drop', [{ name: 'a.rotund', text: '' }]);
  await expect(page.getByText('Drop a drawing to open it')).toBeHidden();
  await expect(alert(page)).toBeHidden();
  expect((await drawing(page)).document.draft?.strokes).toHaveLength(1);
});
