/** The real command line: bundled once for a test file, run as a process of its own. */
import { execFile, spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll } from 'vitest';

const ROOT = resolve(import.meta.dirname, '../..');

export interface Ran {
  readonly status: number;
  readonly stdout: string;
  readonly stderr: string;
}

export interface Program {
  /** of the bundle; no package can be found from here */
  readonly home: string;
  /** where it runs and where files are named from */
  readonly folder: string;
  run(args: readonly string[], options?: RunOptions): Promise<Ran>;
  /** A file in the folder; its name is returned. */
  put(name: string, content: string | Uint8Array): string;
  /** Everything in the folder, hidden files too. */
  list(): string[];
}

export interface RunOptions {
  readonly stdin?: string;
  readonly env?: Readonly<Record<string, string>>;
}

/** The bundle and an empty folder, for the tests of one file. */
export function useProgram(): Program {
  const home = mkdtempSync(join(tmpdir(), 'rotund-cli-'));
  const folder = join(home, 'drawings');
  beforeAll(() => bundle(join(home, 'cli')), 120_000);
  afterAll(() => rmSync(home, { recursive: true, force: true }));
  mkdirSync(folder);
  return {
    home,
    folder,
    run: (args, options = {}) => run(join(home, 'cli/rotund.js'), args, folder, options),
    put: (name, content) => {
      writeFileSync(join(folder, name), content);
      return name;
    },
    list: () => readdirSync(folder).sort(),
  };
}

function bundle(out: string): void {
  const vite = join(ROOT, 'node_modules/vite/bin/vite.js');
  const args = [vite, 'build', '--config', 'vite.cli.config.ts', '--outDir', out, '--emptyOutDir'];
  const { status, stderr } = spawnSync(process.execPath, args, { cwd: ROOT, encoding: 'utf8' });
  if (status !== 0) throw new Error(`the command line cannot be bundled: ${stderr}`);
}

export function run(
  script: string,
  args: readonly string[],
  cwd: string,
  { stdin = '', env = {} }: RunOptions = {},
): Promise<Ran> {
  return new Promise((done) => {
    const options = { cwd, env: { ...process.env, ...env }, maxBuffer: 1 << 26 };
    const child = execFile(process.execPath, [script, ...args], options, (error, stdout, stderr) => {
      done({ status: error ? Number(error.code) : 0, stdout, stderr });
    });
    child.stdin?.on('error', () => {});
    child.stdin?.end(stdin);
  });
}
