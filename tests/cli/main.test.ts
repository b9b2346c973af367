/** Wrong usage and bad input as a person meets them: a message that helps, exit status 2, no output file, no JSON. */
import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { line } from '../document/strokes.ts';
import { BALL, drawingFile, kept, scriptFile } from './drawings.ts';
import { run as runScript, useProgram } from './program.ts';

const program = useProgram();
const { put, run, folder } = program;
put('ball.rotund', drawingFile(BALL));
put('script.rotund', scriptFile(BALL));
put('broken.rotund', drawingFile(BALL).slice(0, 500));
put('wrong.rotund', JSON.stringify({ format: 'rotund', version: 99, document: 7 }));
put('empty.rotund', '');
put('vectors.json', readFileSync(join(import.meta.dirname, '../fixtures/vectors/point.json')));
put('picture.png', Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0xff, 0xfe));
put('old.obj', 'precious');
mkdirSync(join(folder, 'folder'));
mkdirSync(join(folder, 'folder.obj'));

/** Arguments, and what the message must name. */
const WRONG: readonly (readonly [args: string, ...names: string[]])[] = [
  ['', 'no command', 'mesh, render, info', '--help'],
  ['fly ball.rotund', 'fly', 'mesh, render, info'],
  ['--verbose', '--verbose'],
  ['field', 'no input', 'rotund field VECTORS.json'],
  ['field none.json', 'none.json', 'no such file'],
  ['field folder', 'folder', 'reference vectors', 'found a folder'],
  ['field empty.rotund', 'empty.rotund', 'reference vectors'],
  ['field ball.rotund', 'ball.rotund', 'family', 'point, segment or polygon'],
  ['field broken.rotund', 'broken.rotund', 'line '],
  ['field vectors.json --backend gpu', '--backend gpu', 'webgpu'],
  ['field vectors.json --backend tpu', '--backend', 'tpu'],
  ['field vectors.json -o x.json', '-o'],
  ['mesh', 'no input', 'rotund mesh IN'],
  ['mesh ball.rotund', 'no output', '-o OUT'],
  ['mesh ball.rotund script.rotund -o x.obj', 'one input', 'found 2'],
  ['mesh ball.rotund -o', '-o needs a value'],
  ['mesh ball.rotund -o --backend cpu', '-o needs a value'],
  ['mesh ball.rotund -o x.obj -o y.obj', 'twice'],
  ['mesh ball.rotund -o x.obj --fast', '--fast', 'rotund mesh --help'],
  ['mesh ball.rotund -o x.obj -q', '-q'],
  ['mesh ball.rotund -o x.obj --style toon', '--style'],
  ['mesh ball.rotund -o -', 'standard output'],
  ['mesh ball.rotund -o x.3mf', '3mf', 'does not exist yet', '.obj'],
  ['mesh ball.rotund -o x.dae', '.dae', '.obj, .glb, .stl, .ply'],
  ['mesh ball.rotund -o x', 'extension', 'found none'],
  ['mesh ball.rotund -o .obj', 'extension'],
  ['mesh ball.rotund -o nowhere/x.obj', 'nowhere', 'does not exist'],
  ['mesh ball.rotund -o old.obj/x.obj', 'old.obj', 'not a folder'],
  ['mesh ball.rotund -o folder.obj', 'found a folder'],
  ['mesh ball.rotund -o x.obj --backend gpu', '--backend gpu', 'webgpu'],
  ['mesh ball.rotund -o x.obj --backend tpu', '--backend', 'tpu'],
  ['mesh ball.rotund -o x.obj --resolution 12.5', '--resolution', '12.5'],
  ['mesh ball.rotund -o x.obj --resolution -5', '--resolution', '-5'],
  ['mesh ball.rotund -o x.obj --surface-resolution 3', 'from 4 to 1024', "'3'"],
  ['mesh ball.rotund -o x.obj --surface-resolution 64x', '--surface-resolution'],
  ['mesh ball.rotund -o x.obj --surface-resolution 1e2', "'1e2'"],
  ['mesh none.rotund -o x.obj', 'none.rotund', 'no such file'],
  ['mesh folder -o x.obj', 'folder', 'found a folder'],
  ['mesh broken.rotund -o x.obj', 'broken.rotund'],
  ['mesh wrong.rotund -o x.obj', 'wrong.rotund'],
  ['mesh empty.rotund -o x.obj', 'empty.rotund'],
  ['mesh picture.png -o x.obj', 'picture.png', 'UTF-8'],
  ['mesh broken.rotund -o old.obj', 'broken.rotund'],
  ['mesh old.obj -o ./old.obj', 'same file'],
  ['info', 'no input'],
  ['info none.rotund', 'none.rotund'],
  ['info ball.rotund -o x.json', '-o'],
  ['info broken.rotund', 'broken.rotund'],
  ['render ball.rotund', 'no output', '-o OUT.png'],
  ['render ball.rotund -o x.jpg', '.png', '.jpg'],
  ['render ball.rotund -o x.png --mode wire', 'wire', 'mesh or raycast'],
  ['render ball.rotund -o x.png --rays zhu', '--rays zhu', '--mode raycast'],
  ['render ball.rotund -o x.png --mode raycast --rays own', "'own'", 'bricks or zhu'],
  ['render ball.rotund -o x.png --mode raycast --rays zhu', 'ball.rotund', 'no implicit body'],
  ['render ball.rotund -o x.png --style comic', 'comic', 'toon, gouraud, phong, hbed-lines, hbed-ink'],
  ['render ball.rotund -o x.png --size 10x10', 'from 16 to 8192'],
  ['render ball.rotund -o x.png --size 800', '1024x768'],
  ['render ball.rotund -o x.png --size 99999x99999', 'from 16 to 8192'],
  ['render ball.rotund -o x.png --camera above', 'above', 'front, back'],
  ['render ball.rotund -o x.png --camera -30', "'-30'", 'yaw,pitch'],
  ['render ball.rotund -o x.png --camera 1,2,3,4', 'yaw,pitch'],
  ['render ball.rotund -o nowhere/x.png', 'nowhere'],
  ['render broken.rotund -o x.png', 'broken.rotund'],
];

// A process each, on a machine that may be busy.
describe('wrong usage', { timeout: 60_000 }, () => {
  it.each(WRONG)('rotund %s', async (line, ...names) => {
    const before = program.list();
    const { status, stdout, stderr } = await run(line ? line.split(' ') : []);
    expect(stderr).toMatch(/^rotund: .+\n$/);
    for (const name of names) expect(stderr).toContain(name);
    expect(stderr).not.toMatch(/mistake in the program|\n\s+at /);
    expect(status).toBe(2);
    expect(stdout).toBe('');
    expect(program.list()).toEqual(before);
    expect(readFileSync(join(folder, 'old.obj'), 'utf8')).toBe('precious');
  });

  it('names what is lacking where there is no playwright-core', async () => {
    // The bundle lies where no package can be found; a page is all that is looked for before.
    mkdirSync(join(program.home, 'cli/page'), { recursive: true });
    const { run: again } = program;
    const missing = await again(['render', 'ball.rotund', '-o', 'x.png']);
    expect(missing.stderr).toMatch(/page that draws is missing/);
    put('../cli/page/sketch.js', '');
    const { status, stderr } = await again(['render', 'ball.rotund', '-o', 'x.png']);
    expect(stderr).toMatch(/playwright-core.*npm install playwright-core@\d+\.\d+\.\d+/);
    expect(status).toBe(2);
    expect(program.list()).not.toContain('x.png');
  });
});

describe('what is printed', { timeout: 60_000 }, () => {
  it('says what is in a drawing, as one line', async () => {
    const { status, stdout, stderr } = await run(['info', 'ball.rotund']);
    expect([status, stderr]).toEqual([0, '']);
    expect(stdout.trimEnd().split('\n')).toHaveLength(1);
    const none = { components: 0, groups: 0, skels: 0, warnings: [] };
    expect(JSON.parse(stdout)).toEqual({ parts: 1, strokes: 2, ...none });
    expect((await run(['info', '-'], { stdin: scriptFile(BALL) })).stdout).toBe(stdout);
  });

  it('names a part whose strokes enclose nothing', async () => {
    const nothing = scriptFile(kept(line(10), line(10)));
    const { status, stdout } = await run(['info', '-'], { stdin: nothing });
    expect(status).toBe(0);
    expect(JSON.parse(stdout).warnings).toEqual([expect.stringContaining('the strokes make no surface')]);
  });

  it('prints help and the version', async () => {
    const general = await run(['--help']);
    expect(general).toMatchObject({ status: 0, stderr: '' });
    for (const command of ['mesh', 'render', 'info']) {
      expect(general.stdout).toContain(command);
      const help = await run([command, '--help']);
      expect(help).toMatchObject({ status: 0, stderr: '' });
      expect(help.stdout).toContain(`Usage: rotund ${command} IN`);
    }
    const { version } = JSON.parse(readFileSync('package.json', 'utf8'));
    expect((await run(['--version'])).stdout).toBe(`rotund ${version}\n`);
  });

  it('is the same by npm’s script, from the folder where one stands', async () => {
    const script = join(import.meta.dirname, '../../scripts/rotund.mjs');
    const first = await runScript(script, ['info', 'ball.rotund'], folder);
    expect(first.stdout).toBe((await run(['info', 'ball.rotund'])).stdout);
    expect(first.status).toBe(0);
    const { status } = await runScript(script, ['info', 'none.rotund'], folder);
    expect(status).toBe(2);
  }, 120_000);
});
