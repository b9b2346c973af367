/** `rotund mesh` as a process: measures against mathematics, files against the exporters, one line of JSON. */
import { lstatSync, mkdirSync, readFileSync, symlinkSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import type { Command } from '../../src/document/command/index.ts';
import { exporters, modelOf } from '../../src/export/index.ts';
import {
  BALL,
  BLOBS,
  documentOf,
  drawingFile,
  PIPE,
  RING,
  scriptFile,
  TORUS,
  UNFINISHED,
} from './drawings.ts';
import { useProgram } from './program.ts';

const program = useProgram();
const { put, run } = program;
const bytes = (name: string) => readFileSync(join(program.folder, name));

/** The result of a command that must succeed. */
async function result(...args: readonly string[]) {
  const { status, stdout, stderr } = await run(args);
  expect(stderr === '' || stderr.startsWith('rotund: '), stderr).toBe(true);
  expect(status).toBe(0);
  expect(stdout).toMatch(/^\{[ -~]+\}\n$/);
  return JSON.parse(stdout);
}

const FAR = (x: number) =>
  ({
    type: 'affine',
    matrix: [1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0],
    node: { type: 'shape', shape: { type: 'sphere', radius: 5 } },
  }) as const;

const near = (found: number, expected: number): number => Math.abs(found / expected - 1);

// A process each, on a machine that may be busy.
describe('rotund mesh', { timeout: 60_000 }, () => {
  it('measures a ball', async () => {
    put('ball.rotund', drawingFile(BALL));
    const found = await result('mesh', 'ball.rotund', '-o', 'ball.stl');
    expect(near(found.volume, (4 / 3) * Math.PI * 50 ** 3)).toBeLessThan(0.01);
    expect(near(found.area, 4 * Math.PI * 50 ** 2)).toBeLessThan(0.01);
    expect(found).toMatchObject({ watertight: true, genus: 0, fieldEvaluations: 0 });
    for (const value of [...found.bounds.min.map((x: number) => -x), ...found.bounds.max]) {
      expect(Math.abs(value - 50)).toBeLessThan(0.5);
    }
    expect(found.milliseconds).toBeGreaterThan(0);
    expect(bytes('ball.stl').length).toBe(84 + 50 * found.triangles);
  });

  it('measures a ring, whose genus is 1', async () => {
    put('ring.rotund', drawingFile(RING));
    const found = await result('mesh', 'ring.rotund', '-o', 'ring.ply');
    expect(near(found.volume, 2 * Math.PI ** 2 * 40 * 5 ** 2)).toBeLessThan(0.01);
    expect(near(found.area, 4 * Math.PI ** 2 * 40 * 5)).toBeLessThan(0.01);
    expect(found).toMatchObject({ watertight: true, genus: 1 });
  });

  it('tells parts apart and sums them up', async () => {
    put('three.rotund', drawingFile([...BALL, ...RING, ...PIPE]));
    const found = await result('mesh', 'three.rotund', '-o', 'three.glb');
    expect(found.parts).toHaveLength(3);
    expect(found.parts.map((part: { genus: number | null }) => part.genus)).toEqual([0, 1, null]);
    expect(found).toMatchObject({ watertight: false, genus: null });
    for (const key of ['vertices', 'triangles', 'volume', 'area']) {
      const sum = found.parts.reduce(
        (before: number, part: Record<string, number>) => before + part[key]!,
        0,
      );
      expect(near(found[key], sum)).toBeLessThan(1e-12);
    }
  });

  it.each(Object.keys(exporters))('writes what the exporter writes: %s', async (id) => {
    put('two.rotund', drawingFile([...BALL, ...RING], 'Another name'));
    await result('mesh', 'two.rotund', '-o', `two.${id}`);
    const expected = await exporters[id as 'obj'].write(modelOf(documentOf([...BALL, ...RING]), 'two'));
    for (const { name, bytes: own } of expected) expect(bytes(name).equals(own), name).toBe(true);
  });

  it('writes the same mesh from a drawing, from its script and from standard input', async () => {
    put('drawing.rotund', drawingFile([...BALL, ...RING]));
    const script = put('script.rotund', scriptFile([...BALL, ...RING]));
    await result('mesh', 'drawing.rotund', '-o', 'a.ply');
    await result('mesh', script, '--output=b.ply');
    const piped = await run(['mesh', '-', '-o', 'c.PLY'], { stdin: drawingFile([...BALL, ...RING]) });
    expect(piped.status).toBe(0);
    expect(bytes('b.ply').equals(bytes('a.ply'))).toBe(true);
    expect(bytes('c.PLY').equals(bytes('a.ply'))).toBe(true);
  });

  it('follows --surface-resolution', async () => {
    put('ball.rotund', drawingFile(BALL));
    const coarse = await result('mesh', 'ball.rotund', '-o', 'x.stl', '--surface-resolution', '16');
    const fine = await result('mesh', 'ball.rotund', '-o', 'x.stl', '--surface-resolution', '128x32');
    const same = await result('mesh', 'ball.rotund', '-o', 'x.stl', '--surface-resolution=64x64');
    const usual = await result(
      'mesh',
      'ball.rotund',
      '-o',
      'y.stl',
      '--resolution',
      '256',
      '--backend',
      'cpu',
    );
    expect(coarse.triangles).toBeLessThan(usual.triangles / 8);
    expect(near(fine.triangles, 2 * 128 * 32)).toBeLessThan(0.1);
    expect(same.triangles).toBe(usual.triangles);
    expect(bytes('x.stl').equals(bytes('y.stl'))).toBe(true);
  });

  it('measures bodies, and says what they took', async () => {
    const file = put('torus.rotund', drawingFile([TORUS, ...BALL]));
    const found = await result('mesh', file, '-o', 'torus.ply', '--resolution', '96');
    const [torus] = found.parts;
    expect(torus).toMatchObject({ name: 'Torus', watertight: true, genus: 1 });
    expect(near(torus.volume, 2 * Math.PI ** 2 * 20 * 6 ** 2)).toBeLessThan(0.005);
    expect(near(torus.area, 4 * Math.PI ** 2 * 20 * 6)).toBeLessThan(0.005);
    expect(Math.abs(torus.bounds.max[0] - 26)).toBeLessThan(0.01);
    expect(found).toMatchObject({ watertight: true, genus: 1 });
    expect(found.fieldEvaluations).toBeGreaterThan(torus.vertices);
  });

  it('follows --resolution for bodies, 128 without it', async () => {
    const file = put('blobs.rotund', drawingFile([BLOBS]));
    const coarse = await result('mesh', file, '-o', 'x.obj', '--resolution', '32');
    const usual = await result('mesh', file, '-o', 'y.obj');
    const same = await result('mesh', file, '-o', 'z.obj', '--resolution=128');
    expect(usual.triangles / coarse.triangles).toBeGreaterThan(12);
    expect(usual.triangles / coarse.triangles).toBeLessThan(20);
    expect(usual).toMatchObject({ watertight: true, genus: 0 });
    expect(same.triangles).toBe(usual.triangles);
    expect(bytes('z.obj').toString().replace('z.mtl', 'y.mtl')).toBe(bytes('y.obj').toString());
  });

  const PLATE = (half: number, name: string, x = 0): Command => ({
    type: 'addBody',
    name,
    node: {
      type: 'affine',
      matrix: [1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0],
      node: { type: 'shape', shape: { type: 'box', half: [40, half, 20] } },
    },
  });

  it('makes finer what is thin, and warns where that is not enough or not wanted', async () => {
    const file = put('plate.rotund', drawingFile([PLATE(0.3, 'Plate')]));
    const unasked = await result('mesh', file, '-o', 'plate.stl');
    expect(unasked).toMatchObject({ thin: null, backend: 'cpu' });
    expect(near(unasked.volume, 80 * 40 * 0.6)).toBeLessThan(1e-3);
    const { stdout, stderr } = await run(['mesh', file, '-o', 'plate.stl', '--resolution', '128']);
    const asked = JSON.parse(stdout);
    expect(asked.parts[0]).toMatchObject({ cells: 128, backend: 'cpu', thin: { places: 1 } });
    expect(asked.thin.least).toBeCloseTo(0.6, 2);
    expect(Math.abs(asked.thin.at[1])).toBeLessThan(0.01);
    expect(stderr).toMatch(
      /in 1 place, 0\.6 mm at the thinnest.*“Plate”; --resolution \d+ shows all of it\n$/,
    );
    const enough = String(asked.thin.resolution);
    expect(stderr).toContain(`--resolution ${enough} `);
    const finer = await result('mesh', file, '-o', 'plate.stl', '--resolution', enough);
    expect(finer.thin).toBeNull();
  });

  it('says of what is lost whether it is too thin, and for which cells', async () => {
    const ball: Command = {
      type: 'addBody',
      name: 'Ball',
      node: { type: 'shape', shape: { type: 'sphere', radius: 40 } },
    };
    const file = put('foil.rotund', drawingFile([PLATE(0.03, 'Foil'), PLATE(0.15, 'Sheet', 0.1), ball]));
    const { stdout, stderr } = await run(['mesh', file, '-o', 'foil.stl', '--resolution', '64']);
    expect(JSON.parse(stdout).parts).toHaveLength(1);
    expect(stderr).toMatch(/2 parts are left out.*that thin: “Foil”, “Sheet”; not even --resolution 512/);
  });

  it('has cells of one size all over a drawing', async () => {
    const file = put('sizes.rotund', drawingFile([TORUS, ...BALL]));
    const { parts } = await result('mesh', file, '-o', 'sizes.stl');
    // 52 mm of 100
    expect(parts.map(({ cells }: { cells: number | null }) => cells)).toEqual([80, null]);
  });

  it('paints bodies, red on one side and blue on the other', async () => {
    const file = put('painted.rotund', drawingFile([BLOBS]));
    await result('mesh', file, '-o', 'painted.obj', '--resolution', '32');
    const lines = bytes('painted.obj').toString().split('\n');
    const rows = lines
      .filter((line) => line.startsWith('v '))
      .map((line) => line.split(' ').slice(1).map(Number));
    expect(rows.every((row) => row.length === 6)).toBe(true);
    const at = (x: number) => rows.reduce((a, b) => (Math.abs(a[0]! - x) < Math.abs(b[0]! - x) ? a : b));
    expect(at(-30)[3]).toBeGreaterThan(0.9);
    expect(at(30)[5]).toBeGreaterThan(0.9);
  });

  it('says that a body has no surface', async () => {
    const node = { type: 'intersection', form: 'hard', parts: [FAR(-50), FAR(50)] } as const;
    const file = put('nowhere.rotund', drawingFile([{ type: 'addBody', node, name: 'Nowhere' }]));
    const { status, stderr } = await run(['mesh', file, '-o', 'nowhere.stl']);
    expect(status).toBe(2);
    expect(stderr).toMatch(/left out, because the field is nowhere above 0.*“Nowhere”/);
    expect(stderr).toContain('nothing to export: its parts make no surface');
  });

  it('names the place in a tree that makes no field', async () => {
    const text = drawingFile([BLOBS]).replace('"radius": 8', '"radius": -8');
    const { status, stderr } = await run(['mesh', put('wrong.rotund', text), '-o', 'wrong.stl']);
    expect(status).toBe(2);
    expect(stderr).toContain(
      'wrong.rotund, document.parts[0].node.parts[0].skels[0].radius: makes no field: the radius must be above 0, found -8',
    );
  });

  it('leaves out the unfinished form and hidden parts, and says so', async () => {
    const hide = { type: 'showParts', ids: ['part-2'], visible: false } as const;
    const file = put('left.rotund', drawingFile([...BALL, ...RING, hide, UNFINISHED]));
    const { stdout, stderr } = await run(['mesh', file, '-o', 'left.stl']);
    expect(JSON.parse(stdout).parts).toHaveLength(1);
    expect(stderr).toContain('unfinished form (1 stroke)');
    expect(stderr).toMatch(/1 hidden part is left out: “Tube 2”/);
  });

  it('quotes names so that no terminal obeys them', async () => {
    const rename = { type: 'renamePart', id: 'part-1', name: 'a\u001b[31mb\u009bc' } as const;
    const hide = { type: 'showParts', ids: ['part-1'], visible: false } as const;
    const file = put('escape.rotund', drawingFile([...BALL, rename, hide, ...RING]));
    const { stderr, stdout } = await run(['mesh', file, '-o', 'escape.stl']);
    // biome-ignore lint/suspicious/noControlCharactersInRegex: these are what must not be there
    expect(stderr + stdout).not.toMatch(/[\u0000-\u0009\u000b-\u001f\u007f-\u009f]/);
  });

  it('replaces a file as a whole, and through a link', async () => {
    put('ball.rotund', drawingFile(BALL));
    put('target.stl', 'old');
    symlinkSync('target.stl', join(program.folder, 'link.stl'));
    await result('mesh', 'ball.rotund', '-o', 'link.stl');
    expect(lstatSync(join(program.folder, 'link.stl')).isSymbolicLink()).toBe(true);
    expect(bytes('target.stl').length).toBeGreaterThan(1000);
    expect(program.list().filter((name) => name.endsWith('.part'))).toEqual([]);
  });

  it('writes both files of an OBJ or none', async () => {
    put('ball.rotund', drawingFile(BALL));
    put('pair.obj', 'old');
    mkdirSync(join(program.folder, 'pair.mtl'));
    const before = program.list();
    const { status, stdout, stderr } = await run(['mesh', 'ball.rotund', '-o', 'pair.obj']);
    expect(status).toBe(2);
    expect(stdout).toBe('');
    expect(stderr).toContain('pair.mtl');
    expect(bytes('pair.obj').toString()).toBe('old');
    expect(program.list()).toEqual(before);
  });

  const empty: readonly (readonly [string, readonly Command[], string])[] = [
    ['no parts', [], 'no parts'],
    ['an unfinished form', [UNFINISHED], 'unfinished form'],
    ['hidden parts', [...BALL, { type: 'showParts', ids: ['part-1'], visible: false }], 'hidden'],
  ];
  it.each(empty)('refuses to export nothing: %s', async (_, commands, reason) => {
    const file = put('empty.rotund', drawingFile(commands));
    const before = program.list();
    const { status, stdout, stderr } = await run(['mesh', file, '-o', 'empty.obj']);
    expect(status).toBe(2);
    expect(stdout).toBe('');
    expect(stderr).toMatch(/empty\.rotund: nothing to export: /);
    expect(stderr).toContain(reason);
    expect(program.list()).toEqual(before);
  });
});
