/** `<rotund-sketch>` in somebody’s page: what it is told by attributes, properties and methods, and what it tells. */
import { expect, type Page, test } from '@playwright/test';
import { mutant } from '../../tests/document/mutate.ts';
import { PenDriver } from '../pen.ts';
import { readPicture } from '../picture.ts';

let problems: string[];

test.beforeEach(({ page }) => {
  problems = [];
  page.on('pageerror', (error) => problems.push(error.message));
});

test.afterEach(() => expect(problems).toEqual([]));

async function open(page: Page, markup = '<rotund-sketch></rotund-sketch>'): Promise<void> {
  await page.goto('/e2e/element/index.html');
  await page.evaluate(async (html) => {
    await window.define();
    document.body.insertAdjacentHTML('afterbegin', html);
    for (const sketch of document.querySelectorAll('rotund-sketch')) window.listen(sketch);
  }, markup);
}

/** A saved drawing of two parts. */
async function saved(page: Page): Promise<string> {
  return page.evaluate(() => {
    const sketch = document.createElement('rotund-sketch');
    window.drawForm(sketch);
    return sketch.save();
  });
}

const serve = (page: Page, address: string, body: string, status = 200) =>
  page.route(`**/${address}`, (route) => route.fulfill({ status, body }));

const heard = (page: Page, type: string) =>
  page.evaluate((wanted) => window.heard.filter((line) => line.startsWith(wanted)), type);

const isReady = (page: Page) => expect.poll(() => heard(page, 'ready')).not.toHaveLength(0);

const parts = (page: Page) =>
  page.evaluate(() => document.querySelector('rotund-sketch')!.document.parts.length);

/** Pixels that are neither paper nor its grain: saturated ones. */
function coloured(png: Buffer): number {
  const picture = readPicture(png);
  let count = 0;
  for (let y = 0; y < picture.height; y++)
    for (let x = 0; x < picture.width; x++) {
      const rgb = picture.at(x, y);
      if (Math.max(...rgb) - Math.min(...rgb) > 60) count++;
    }
  return count;
}

test.describe('methods', () => {
  test('strokes, commands, undo, selection; each is told', async ({ page }) => {
    await open(page);
    const state = await page.evaluate(() => {
      const sketch = document.querySelector('rotund-sketch')!;
      window.drawForm(sketch);
      const ids = sketch.document.parts.map(({ id }) => id);
      sketch.select([ids[1]!, 'none', ids[0]!]);
      const { selection, canUndo, canRedo } = sketch;
      sketch.undo();
      sketch.redo();
      return { ids, selection, canUndo, canRedo };
    });
    expect(state.selection).toEqual(state.ids);
    expect(state).toMatchObject({ canUndo: true, canRedo: false });
    expect(await heard(page, 'change')).toEqual([
      'change command addStroke',
      'change command keep',
      'change command addStroke',
      'change command addStroke',
      'change command keep',
      'change undo ',
      'change redo ',
    ]);
    expect(await heard(page, 'select')).toEqual([
      `select ${state.ids}`,
      // undo took a part away, and its selection with it
      `select ${state.ids.slice(0, 1)}`,
    ]);
  });

  test('what is saved is loaded, from text, a file, an object and a script, as one undo step', async ({
    page,
  }) => {
    await open(page);
    const same = await page.evaluate(async () => {
      const sketch = document.querySelector('rotund-sketch')!;
      window.drawForm(sketch);
      const text = sketch.save();
      const script = sketch.script();
      const wanted = JSON.stringify(sketch.document.parts);
      const other = document.createElement('rotund-sketch');
      const found: boolean[] = [];
      const file = new File([text], 'form.rotund');
      for (const source of [text, file, sketch.drawing, script]) {
        await other.load(source);
        found.push(JSON.stringify(other.document.parts) === wanted);
        other.undo();
        found.push(other.document.parts.length === 0);
      }
      return found;
    });
    expect(same).toEqual(Array(8).fill(true));
  });

  test('export gives files, also of an element that is on no page', async ({ page }) => {
    await open(page, '');
    const files = await page.evaluate(async () => {
      const sketch = document.createElement('rotund-sketch');
      window.drawForm(sketch);
      const made = await Promise.all((['obj', 'glb', 'stl', 'ply'] as const).map((id) => sketch.export(id)));
      return made.map(([first]) => [first!.name, first!.bytes.length > 1000]);
    });
    expect(files.map(([, large]) => large)).toEqual([true, true, true, true]);
    expect(files.map(([name]) => String(name).split('.').at(-1))).toEqual(['obj', 'glb', 'stl', 'ply']);
  });

  test('a picture has exactly the size, the side and the style asked for', async ({ page }) => {
    await open(page, '<rotund-sketch controls="none" readonly quality="fine"></rotund-sketch>');
    const take = async (shot: object) => {
      const data = await page.evaluate(async (wanted) => {
        const blob = await document.querySelector('rotund-sketch')!.picture(wanted);
        return [blob.type, [...new Uint8Array(await blob.arrayBuffer())]] as const;
      }, shot);
      expect(data[0]).toBe('image/png');
      return Buffer.from(data[1]);
    };
    await page.evaluate(() => window.drawForm(document.querySelector('rotund-sketch')!));
    const front = await take({ width: 200, height: 120, camera: 'front' });
    expect(readPicture(front)).toMatchObject({ width: 200, height: 120 });
    const toon = coloured(front);
    expect(toon).toBeGreaterThan(1000);
    // a quarter turn to the left and ink instead of colour: from the left, the tube hides behind the solid
    const turned = await take({ width: 200, height: 120, camera: { yaw: 0, pitch: 0, roll: 90 } });
    expect(Math.abs(coloured(turned) / toon - 1)).toBeGreaterThan(0.1);
    const sameSide = await take({ width: 200, height: 120, camera: { yaw: 0, pitch: 0 } });
    expect(sameSide.equals(front)).toBe(true);
    expect(coloured(await take({ width: 200, height: 120, camera: 'front', style: 'hbed-lines' }))).toBe(0);
    expect(readPicture(await take({}))).toMatchObject({ width: 320, height: 320 });
  });

  test('bad arguments are refused with the place and what was expected, and change nothing', async ({
    page,
  }) => {
    await open(page);
    const refused = await page.evaluate(async () => {
      const sketch = document.querySelector('rotund-sketch')!;
      window.drawForm(sketch);
      const { document: before } = sketch;
      const bad = (value: unknown) => value as never;
      const tries: (() => unknown)[] = [
        () => sketch.load('no drawing'),
        () => sketch.load(bad({ document: { parts: 'all' } })),
        () => sketch.load(bad(null)),
        () => sketch.load(new Blob(['{"format":"rotund","version":1e9}'])),
        () => sketch.run(bad({ type: 'explode' })),
        () => sketch.run([{ type: 'removeAll' }, bad({ type: 'renamePart', ids: 3 })]),
        () => sketch.addStroke(bad({ points: [[0, 'a']] })),
        () => sketch.addStroke(bad(undefined)),
        () => sketch.select(bad('part-1')),
        () => sketch.export(bad('dwg')),
        () => sketch.picture({ width: 0, height: 20 }),
        () => sketch.picture({ width: 20.5, height: 20 }),
        () => sketch.picture({ camera: bad('above') }),
        () => sketch.picture({ camera: { yaw: Number.NaN, pitch: 0 } }),
        () => sketch.picture({ style: bad('cubist') }),
      ];
      const names: string[] = [];
      for (const attempt of tries) {
        try {
          await attempt();
          names.push(`accepted: ${attempt}`);
        } catch (error) {
          names.push((error as Error).name);
        }
      }
      return { names, untouched: sketch.document === before };
    });
    expect(refused.names).toEqual(refused.names.map(() => 'FileError'));
    expect(refused.untouched).toBe(true);
    expect(await heard(page, 'error')).toEqual([]);
  });
});

test.describe('src', () => {
  test('is fetched, shown, and is where undo ends', async ({ page }) => {
    await open(page, '');
    await serve(page, 'form.rotund', await saved(page));
    await page.evaluate(() => {
      document.body.insertAdjacentHTML(
        'afterbegin',
        '<rotund-sketch src="/form.rotund" readonly></rotund-sketch>',
      );
      window.listen(document.querySelector('rotund-sketch')!);
    });
    await isReady(page);
    expect(await parts(page)).toBe(2);
    expect(await heard(page, '')).toEqual(['change command load', 'ready ']);
    const { name, canUndo } = await page.evaluate(() => {
      const { drawing, canUndo } = document.querySelector('rotund-sketch')!;
      return { name: drawing.name, canUndo };
    });
    expect({ name, canUndo }).toEqual({ name: 'form', canUndo: false });
    expect(coloured(await page.locator('rotund-sketch').screenshot())).toBeGreaterThan(1000);
  });

  test('gives way to what the browser kept of this page', async ({ page }) => {
    await open(page, '');
    await serve(page, 'form.rotund*', await saved(page));
    const visit = async () => {
      await open(page, '<rotund-sketch autosave="visit" src="/form.rotund"></rotund-sketch>');
      await expect.poll(() => parts(page)).toBeGreaterThan(0);
      await isReady(page);
    };
    await visit();
    await page.evaluate(() => {
      const sketch = document.querySelector('rotund-sketch')!;
      sketch.run({ type: 'removeParts', ids: [sketch.document.parts[0]!.id] });
    });
    for (let i = 0; i < 2; i++) {
      const kept = () => page.evaluate(() => document.querySelector('rotund-sketch')!.files.kept);
      await expect.poll(kept).toBe('kept');
      await visit();
      expect(await parts(page)).toBe(1);
    }
    await page.evaluate(() => {
      document.querySelector('rotund-sketch')!.src = '/form.rotund?again';
    });
    await expect.poll(() => parts(page)).toBe(2);
    await page.evaluate(() => document.querySelector('rotund-sketch')!.undo());
    expect(await parts(page)).toBe(1);
  });

  test('does not come back over what was opened in its place', async ({ page }) => {
    await open(page);
    await serve(page, 'form.rotund', await saved(page));
    const shown = await page.evaluate(async () => {
      const sketch = document.querySelector('rotund-sketch')!;
      sketch.src = '/form.rotund';
      await sketch.updateComplete;
      await sketch.load('[{"type":"addStroke","stroke":{"samples":[[0,0],[5,20],[0,40]]}},{"type":"keep"}]');
      // Frameworks move nodes about.
      document.body.append(sketch);
      await sketch.picture({ width: 16, height: 16 });
      return sketch.document.parts.length;
    });
    expect(shown).toBe(1);
  });

  for (const [what, body, status, says] of [
    ['is missing', 'not found', 404, '404'],
    ['is no drawing', '{"format":"rotund"', 200, 'form.rotund'],
  ] as const) {
    test(`that ${what} is told by an event and a notice, and the drawing stays`, async ({ page }) => {
      await open(page);
      await serve(page, 'form.rotund', body, status);
      await page.evaluate(() => {
        const sketch = document.querySelector('rotund-sketch')!;
        window.drawForm(sketch);
        sketch.src = '/form.rotund';
      });
      await expect(page.getByRole('alert')).toContainText(says);
      expect(await heard(page, 'error')).toHaveLength(1);
      expect((await heard(page, 'error'))[0]).toContain(says);
      expect(await parts(page)).toBe(2);
      await page.unroute('**/form.rotund');
      await serve(
        page,
        'form.rotund',
        await page.evaluate(() => document.createElement('rotund-sketch').save()),
      );
      await page.getByRole('button', { name: 'Try again' }).click();
      await expect.poll(() => parts(page)).toBe(0);
      await expect(page.getByRole('alert')).toBeHidden();
    });
  }

  test('that changes withdraws the address before', async ({ page }) => {
    await open(page, '');
    const text = await saved(page);
    let answerSlow = () => {};
    const slow = new Promise<void>((resolve) => {
      answerSlow = resolve;
    });
    await page.route('**/slow.rotund', async (route) => {
      await slow;
      await route.fulfill({ body: 'too late' }).catch(() => {});
    });
    await serve(page, 'form.rotund', text);
    await page.evaluate(async () => {
      document.body.insertAdjacentHTML('afterbegin', '<rotund-sketch src="/slow.rotund"></rotund-sketch>');
      const sketch = document.querySelector('rotund-sketch')!;
      window.listen(sketch);
      await sketch.updateComplete;
      sketch.src = '/form.rotund';
    });
    await expect.poll(() => parts(page)).toBe(2);
    answerSlow();
    await isReady(page);
    expect(await heard(page, 'error')).toEqual([]);
  });

  test('a page that tells the person itself prevents the notice', async ({ page }) => {
    await open(page);
    await serve(page, 'form.rotund', '', 500);
    await page.evaluate(() => {
      const sketch = document.querySelector('rotund-sketch')!;
      sketch.addEventListener('error', (event) => event.preventDefault());
      sketch.setAttribute('src', '/form.rotund');
    });
    await expect.poll(() => heard(page, 'error')).toHaveLength(1);
    await isReady(page);
    await expect(page.getByRole('alert')).toBeHidden();
  });
});

test.describe('declared', () => {
  test('before the class is there, properties are taken over', async ({ page }) => {
    await open(page, '');
    const text = await saved(page);
    await page.reload();
    await page.evaluate(async (saved) => {
      const sketch = document.body.appendChild(document.createElement('rotund-sketch'));
      sketch.drawing = JSON.parse(saved);
      sketch.readOnly = true;
      sketch.renderStyle = 'hbed-ink';
      window.listen(sketch);
      await window.define();
      await sketch.updateComplete;
    }, text);
    const found = await page.evaluate(() => {
      const sketch = document.querySelector('rotund-sketch')!;
      const { canUndo, readOnly, renderStyle } = sketch;
      const attributes = sketch
        .getAttributeNames()
        .filter((name) => !name.startsWith('data-'))
        .sort();
      return {
        parts: sketch.document.parts.length,
        style: sketch.drawing.look.style,
        canUndo,
        readOnly,
        renderStyle,
        attributes,
      };
    });
    expect(found).toEqual({
      parts: 2,
      style: 'hbed-ink',
      canUndo: false,
      readOnly: true,
      renderStyle: 'hbed-ink',
      attributes: ['readonly', 'render-style'],
    });
  });

  test('nonsense in attributes throws nothing', async ({ page }) => {
    await open(
      page,
      '<rotund-sketch render-style="cubist" theme="plaid" controls="some" backend="magic" quality="best" alt=""></rotund-sketch>',
    );
    await isReady(page);
    expect(await heard(page, 'error')).toHaveLength(1);
    expect((await heard(page, 'error'))[0]).toContain('render-style');
    await page.evaluate(() => {
      document.querySelector('rotund-sketch')!.drawing = 7 as never;
    });
    expect(await heard(page, 'error')).toHaveLength(2);
  });

  test('the style wins over that of a drawing and follows what a person chooses', async ({ page }) => {
    await open(page, '<rotund-sketch style="width:760px" render-style="hbed-lines"></rotund-sketch>');
    await isReady(page);
    const sketch = page.locator('rotund-sketch');
    await page.evaluate(async () => {
      const sketch = document.querySelector('rotund-sketch')!;
      const { drawing } = sketch;
      await sketch.load({ ...drawing, look: { ...drawing.look, style: 'toon' } });
    });
    expect(
      await sketch.evaluate((s) => (s as HTMLElementTagNameMap['rotund-sketch']).drawing.look.style),
    ).toBe('hbed-lines');
    await page.getByRole('radio', { name: 'Ink' }).click();
    await expect(sketch).toHaveAttribute('render-style', 'hbed-ink');
  });

  test('controls="none" leaves the picture alone', async ({ page }) => {
    await open(page, '<rotund-sketch controls="none" alt="A pear"></rotund-sketch>');
    await isReady(page);
    await expect(page.locator('rotund-sketch').getByRole('button')).toHaveCount(0);
    await expect(page.getByRole('application', { name: 'A pear' })).toBeVisible();
    await expect(page.locator('rotund-sketch .chrome, rotund-sketch .hint')).toHaveCount(0);
  });

  test('poster, toolbar and parts', async ({ page }) => {
    await open(
      page,
      `<style>rotund-sketch::part(toolbar) { opacity: 0.5 } rotund-sketch { --surface: rgb(1, 2, 3) }</style>
      <rotund-sketch style="width:760px"><p slot="poster">Soon</p><button slot="toolbar">Mine</button><b>never shown</b></rotund-sketch>`,
    );
    await expect(page.getByText('Soon')).toBeVisible();
    await isReady(page);
    await expect(page.getByText('Soon')).toBeHidden();
    await expect(page.getByRole('button', { name: 'Mine' })).toBeVisible();
    await expect(page.getByText('never shown')).toBeHidden();
    await expect(page.locator('rotund-sketch .top')).toHaveCSS('opacity', '0.5');
    await expect(page.locator('rotund-sketch .tray.right')).toHaveCSS('background-color', 'rgb(1, 2, 3)');
  });
});

test.describe('readonly', () => {
  test('a drag turns the view, a tap selects, keys and taps of fingers edit nothing', async ({ page }) => {
    await open(page, '');
    const text = await saved(page);
    await page.evaluate((drawing) => {
      document.body.insertAdjacentHTML(
        'afterbegin',
        '<rotund-sketch readonly alt="Two forms"></rotund-sketch>',
      );
      const sketch = document.querySelector('rotund-sketch')!;
      window.listen(sketch);
      sketch.drawing = JSON.parse(drawing);
    }, text);
    await isReady(page);
    await expect(page.getByRole('img', { name: 'Two forms' })).toBeVisible();
    for (const name of ['Undo', 'Redo', 'Draw', 'Colour'])
      await expect(page.getByRole('button', { name, exact: true })).toHaveCount(0);
    await expect(page.getByRole('group', { name: /View/ })).toBeVisible();
    const view = () => page.evaluate(() => document.querySelector('rotund-sketch')!.drawing.view.rotation);
    const solid = await page.evaluate(() => document.querySelector('rotund-sketch')!.document.parts[1]!.id);
    const before = await view();
    await page.mouse.click(130, 160);
    expect(await heard(page, 'select')).toEqual([`select ${solid}`]);
    expect(await view()).toEqual(before);
    for (const pointer of ['mouse', 'pen'] as const) {
      const from = await view();
      const hand = await PenDriver.on(page, pointer);
      await hand.draw([
        [100, 100],
        [130, 110],
        [160, 120],
      ]);
      expect(await view()).not.toEqual(from);
    }
    await page.locator('rotund-sketch .stage').focus();
    for (const key of ['c', 'e', 'u', 'n', 'Delete', 'Control+z', 'Shift+Q']) await page.keyboard.press(key);
    await page.keyboard.press('2');
    expect(await page.evaluate(() => document.querySelector('rotund-sketch')!.drawing.look.style)).toBe(
      'hbed-lines',
    );
    expect(await parts(page)).toBe(2);
    expect(await heard(page, 'change')).toEqual(['change command load']);
    await page.evaluate(() => document.querySelector('rotund-sketch')!.run({ type: 'removeAll' }));
    expect(await parts(page)).toBe(0);
  });
});

test.describe('a page', () => {
  test('with two elements has one device; keys answer where the focus is', async ({ page }) => {
    await open(page, '<rotund-sketch></rotund-sketch><rotund-sketch></rotund-sketch>');
    await expect.poll(() => heard(page, 'ready')).toHaveLength(2);
    const [first, second] = await page.evaluate(() =>
      [...document.querySelectorAll('rotund-sketch')]
        .map((sketch) => {
          window.drawForm(sketch);
          return sketch.session.scene!.device;
        })
        .map((device, _, all) => device !== null && device === all[0]),
    );
    expect([first, second]).toEqual([true, true]);
    await page.locator('rotund-sketch').nth(1).locator('.stage').focus();
    await page.keyboard.press('e');
    const counts = await page.evaluate(() =>
      [...document.querySelectorAll('rotund-sketch')].map(({ document }) => document.parts.length),
    );
    expect(counts).toEqual([2, 0]);
  });

  test('that removes, re-adds and moves it keeps drawing, history and view', async ({ page }) => {
    await open(page);
    await isReady(page);
    const kept = await page.evaluate(async () => {
      const sketch = document.querySelector('rotund-sketch')!;
      window.drawForm(sketch);
      sketch.session.camera.orbit(40, 10);
      const { document: drawn, drawing } = sketch;
      sketch.remove();
      await new Promise((done) => setTimeout(done));
      const frame = document.createElement('div');
      document.body.append(frame);
      frame.append(sketch);
      document.body.prepend(sketch);
      return {
        document: sketch.document === drawn,
        view: JSON.stringify(sketch.drawing.view) === JSON.stringify(drawing.view),
        undo: sketch.canUndo,
      };
    });
    expect(kept).toEqual({ document: true, view: true, undo: true });
    await expect.poll(() => heard(page, 'ready')).toHaveLength(2);
    const same = await page.evaluate(() => {
      const sketch = document.querySelector('rotund-sketch')!;
      const { scene } = sketch.session;
      const to = document.querySelector('div') as Element & { moveBefore(node: Node, before: null): void };
      to.moveBefore(sketch, null);
      return sketch.parentElement === to && scene !== null && sketch.session.scene === scene;
    });
    expect(same).toBe(true);
    await expect
      .poll(async () => coloured(await page.locator('rotund-sketch').screenshot()))
      .toBeGreaterThan(1000);
  });

  test('draws no frames of an element that nobody can see', async ({ page }) => {
    await open(page, '<div style="height:3000px"></div><rotund-sketch></rotund-sketch>');
    await isReady(page);
    const frames = () => page.evaluate(() => window.heard.filter((line) => line === 'frame').length);
    await page.evaluate(() => {
      const { session } = document.querySelector('rotund-sketch')!;
      const { scene } = session;
      const render = scene!.render;
      scene!.render = () => {
        window.heard.push('frame');
        render();
      };
      window.drawForm(document.querySelector('rotund-sketch')!);
    });
    await page.evaluate(
      () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
    );
    expect(await frames()).toBe(0);
    await page.evaluate(() => document.querySelector('rotund-sketch')!.scrollIntoView());
    await expect.poll(frames).toBeGreaterThan(0);
    await page.evaluate(() => {
      document.querySelector('rotund-sketch')!.hidden = true;
    });
    await expect(page.locator('rotund-sketch')).toBeHidden();
    await page.evaluate(() => {
      const sketch = document.querySelector('rotund-sketch')!;
      sketch.hidden = false;
      sketch.style.width = '0';
    });
    await page.evaluate(() => {
      document.querySelector('rotund-sketch')!.style.width = '';
    });
    await expect
      .poll(async () => coloured(await page.locator('rotund-sketch').screenshot()))
      .toBeGreaterThan(1000);
  });

  test('shows names as text, and hears no events of the inputs inside', async ({ page }) => {
    await open(page);
    await isReady(page);
    const name = '<img src=x onerror="window.heard.push(\'script ran\')">';
    await page.evaluate((html) => {
      const sketch = document.querySelector('rotund-sketch')!;
      window.drawForm(sketch);
      sketch.run({ type: 'renamePart', id: sketch.document.parts[0]!.id, name: html });
      sketch.select([sketch.document.parts[0]!.id]);
      sketch.session.saySelection();
      window.heard.length = 0;
      for (const input of sketch.shadowRoot!.querySelectorAll('input'))
        for (const type of ['select', 'change', 'error'])
          input.dispatchEvent(new Event(type, { bubbles: true }));
    }, name);
    await expect(page.getByRole('status').first()).toContainText(name);
    expect(await page.locator('rotund-sketch img').count()).toBe(0);
    expect((await heard(page, '')).filter((line) => !line.startsWith('change command'))).toEqual([]);
  });
});

test('60 mutated files are refused in words or opened; nothing else happens (seeds 1–60)', async ({
  page,
}) => {
  await open(page);
  const mutants = Array.from({ length: 60 }, (_, i) => mutant(i + 1).text).filter(
    (text) => text.length < 1e6,
  );
  const complaints: string[] = [];
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  const found = await page.evaluate(async (texts) => {
    const sketch = document.querySelector('rotund-sketch')!;
    window.drawForm(sketch);
    const wrong: string[] = [];
    let refused = 0;
    for (const text of texts) {
      const before = sketch.document;
      try {
        await sketch.load(text, { name: 'mutant.rotund' });
        sketch.undo();
      } catch (error) {
        refused++;
        const { name, message } = error as Error;
        if (name !== 'FileError' || !message.startsWith('mutant.rotund')) wrong.push(`${name}: ${message}`);
      }
      if (sketch.document !== before) wrong.push(`another document after ${text.slice(0, 80)}`);
    }
    await sketch.updateComplete;
    const strange = sketch.shadowRoot!.querySelectorAll('script, img, iframe').length;
    return { wrong, refused, strange };
  }, mutants);
  expect(found).toMatchObject({ wrong: [], strange: 0 });
  expect(found.refused).toBeGreaterThan(30);
  expect(complaints).toEqual([]);
});

test('a fallback of the page stands in for the picture that no back end can draw', async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(navigator, 'gpu', { value: undefined });
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (
      this: HTMLCanvasElement,
      ...[type, ...rest]: unknown[]
    ) {
      return type === '2d' ? Reflect.apply(getContext, this, [type, ...rest]) : null;
    } as typeof getContext;
  });
  await open(page, '<rotund-sketch controls="none"><p slot="fallback">A pear, in words</p></rotund-sketch>');
  await expect(page.getByText('A pear, in words')).toBeVisible();
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', 'none');
  expect(await heard(page, 'error')).toHaveLength(1);
  expect(await heard(page, 'ready')).toEqual([]);
  const refused = await page.evaluate(() => {
    const sketch = document.querySelector('rotund-sketch')!;
    window.drawForm(sketch);
    return sketch.picture({ width: 64, height: 64 }).catch((error: Error) => error.name);
  });
  expect(refused).toBe('NoGraphicsError');
  expect(await parts(page)).toBe(2);
});
