/** The published package: what it holds, that every entry can be imported without a DOM, and that its types stand alone. */
import { existsSync, mkdirSync, readdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { type Stage, stagePackage } from './stage.ts';

const MODULES = resolve(import.meta.dirname, '../../node_modules');

let stage: Stage;
/** a project that has it installed, beside what it depends on and nothing else */
let project: string;

const manifest = () => JSON.parse(readFileSync(join(stage.folder, 'package.json'), 'utf8'));

/** The packages a package needs, and those that they need. */
function needed(names: readonly string[], found = new Set<string>()): Set<string> {
  for (const name of names) {
    if (found.has(name) || !existsSync(join(MODULES, name))) continue;
    found.add(name);
    const { dependencies = {} } = JSON.parse(readFileSync(join(MODULES, name, 'package.json'), 'utf8'));
    needed(Object.keys(dependencies), found);
  }
  return found;
}

beforeAll(() => {
  stage = stagePackage();
  project = join(stage.folder, '../project');
  const modules = join(project, 'node_modules');
  mkdirSync(modules, { recursive: true });
  writeFileSync(join(project, 'package.json'), '{ "type": "module" }');
  symlinkSync(stage.folder, join(modules, 'rotund'), 'dir');
  // Beside the package too: Node resolves from where a module really is.
  symlinkSync(modules, join(stage.folder, '../node_modules'), 'dir');
  for (const name of needed(Object.keys(manifest().dependencies))) {
    mkdirSync(join(modules, name, '..'), { recursive: true });
    symlinkSync(join(MODULES, name), join(modules, name), 'dir');
  }
}, 120_000);

afterAll(() => stage?.remove());

describe('the package', () => {
  it('satisfies publint', async () => {
    const { publint } = await import('publint');
    const { messages } = await publint({ pkgDir: stage.folder, strict: true, pack: false });
    expect(messages.filter(({ type }) => type !== 'suggestion')).toEqual([]);
  });

  it('has a file for each entry, and no more types than they lead to', () => {
    const { exports, files, bin, customElements } = manifest();
    const named = JSON.stringify([exports, bin, customElements]).match(/(\.\/)?dist\/[^"]+/g) ?? [];
    expect(named.filter((path) => !existsSync(join(stage.folder, path)))).toEqual([]);
    expect(named.every((path) => files.some((kept: string) => path.replace('./', '').startsWith(kept)))).toBe(
      true,
    );
    const types = readdirSync(join(stage.folder, 'dist/types'), { recursive: true, encoding: 'utf8' });
    expect(types.filter((path) => /rotundSketch|document\.d\.ts/.test(path))).toHaveLength(2);
    const foreign = types
      .filter((path) => path.endsWith('.ts'))
      .filter((path) =>
        /'three|GPUDevice/.test(readFileSync(join(stage.folder, 'dist/types', path), 'utf8')),
      );
    expect(foreign).toEqual([]);
  });

  it('fetches the scene and the exporters only when they are needed', () => {
    const lib = join(stage.folder, 'dist/lib');
    const reached = new Set<string>();
    const visit = (file: string) => {
      if (reached.has(file)) return;
      reached.add(file);
      const code = readFileSync(file, 'utf8');
      for (const [, name] of code.matchAll(/^(?:import|export)\b[^;]*?["']([^"']+)["'];/gm))
        if (name!.startsWith('.')) visit(join(file, '..', name!));
        else reached.add(name!);
    };
    visit(join(lib, 'define.js'));
    expect([...reached].filter((name) => /^three|gltf|export\.js|scene\.js/.test(name))).toEqual([]);
  });

  // What a package says of its side effects holds for its own bundles as well.
  it('leaves the element in the application', { timeout: 60_000 }, () => {
    const assets = join(stage.application(), 'assets');
    const scripts = readdirSync(assets).filter((name) => name.endsWith('.js'));
    const defines = scripts.filter((name) =>
      /customElements[^;]*define\([`'"]rotund-sketch/.test(readFileSync(join(assets, name), 'utf8')),
    );
    expect(defines).toHaveLength(1);
  });

  it('can be imported in bare Node, and works on files there', { timeout: 60_000 }, () => {
    const { exports } = manifest();
    const entries = Object.keys(exports).filter((key) => !key.endsWith('.json'));
    const code = `
      if (globalThis.window || globalThis.HTMLElement) throw new Error('this is no bare Node');
      for (const entry of ${JSON.stringify(entries)}) await import('rotund' + entry.slice(1));
      const { exporters, modelOf, parse, replay, RotundSketch, serialize, EMPTY_DRAWING, FileError } = await import('rotund');
      const points = (x) => [...Array(20).keys()].map((i) => ({ x, y: 5 * i, pressure: 0.5, tiltX: 0, tiltY: 0, time: 8 * i }));
      const plane = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] };
      const { view } = EMPTY_DRAWING;
      const stroke = (x) => ({ samples: points(x), plane, view, pointer: 'pen', closed: false });
      const document = replay([{ type: 'addStroke', stroke: stroke(-20) }, { type: 'addStroke', stroke: stroke(20) }, { type: 'keep' }]);
      const drawing = parse(serialize({ ...EMPTY_DRAWING, document }), 'form.rotund');
      const [file] = await exporters.stl.write(modelOf(drawing.document, 'form'));
      let refused = false;
      try { parse('{', 'form.rotund'); } catch (error) { refused = error instanceof FileError; }
      console.log(JSON.stringify({ kind: drawing.document.parts[0].kind, bytes: file.bytes.length, name: file.name, refused, element: typeof RotundSketch }));`;
    writeFileSync(join(project, 'bare.mjs'), code);
    const { bytes, ...rest } = JSON.parse(stage.run(process.execPath, ['bare.mjs'], project));
    expect(rest).toEqual({ kind: 'rotational', name: 'form.stl', refused: true, element: 'function' });
    expect(bytes).toBeGreaterThan(10_000);
  });

  it('has types that need nobody to look away', { timeout: 60_000 }, () => {
    writeFileSync(join(project, 'page.ts'), PAGE);
    const tsc = join(MODULES, 'typescript/bin/tsc');
    for (const [module, resolution] of [
      ['esnext', 'bundler'],
      ['nodenext', 'nodenext'],
    ] as const) {
      const how = ['--module', module, '--moduleResolution', resolution];
      const common = [
        '--noEmit',
        '--strict',
        '--target',
        'es2022',
        '--lib',
        'es2022,dom,dom.iterable',
        '--types',
        '',
      ];
      expect(stage.run(process.execPath, [tsc, ...common, ...how, 'page.ts'], project)).toBe('');
    }
  });
});

/** What a page may write, and what it may not. */
const PAGE = `
import { type Document, exporters, FileError, parse, type RotundSketch } from 'rotund';
import 'rotund/define';
const sketch: RotundSketch = document.createElement('rotund-sketch');
sketch.addEventListener('change', ({ detail }) => {
  const after: Document = detail.document;
  console.log(after.parts.length, detail.cause, detail.commands.map(({ type }) => type));
});
sketch.addEventListener('select', ({ detail }) => detail.ids.join());
sketch.addEventListener('error', ({ detail }) => detail.message.trim());
sketch.addEventListener('click', ({ clientX }) => clientX);
sketch.addEventListener('anything', (event) => event.type);
sketch.addStroke({ points: [[0, 1], [2, 3, 0.5]] });
sketch.run({ type: 'keep' });
sketch.run([{ type: 'showParts', ids: sketch.selection, visible: false }]);
sketch.renderStyle = 'hbed-ink';
const picture: Promise<Blob> = sketch.picture({ camera: 'front', width: 30, height: 40 });
picture.catch((error) => error instanceof FileError && error.place);
console.log(parse('', 'form').name, exporters.glb.mime, document.querySelector('rotund-sketch')?.canUndo);
// @ts-expect-error: of the controls
sketch.session;
// @ts-expect-error: no command
sketch.run({ type: 'explode' });
// @ts-expect-error: no style
sketch.renderStyle = 'cubist';
`;
