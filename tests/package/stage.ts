/** The package as it is published, built from these sources into a folder of its own: the one of the repository stays as it is. */
import { execFileSync } from 'node:child_process';
import { cpSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

const ROOT = resolve(import.meta.dirname, '../..');

export interface Stage {
  /** of the package */
  readonly folder: string;
  /** Runs a program there; its output when it ends well, else an error that quotes it. */
  run(command: string, args: readonly string[], folder?: string): string;
  /** Builds the application, too; the folder it is in. */
  application(): string;
  remove(): void;
}

export function stagePackage(): Stage {
  const place = mkdtempSync(join(tmpdir(), 'rotund-package-'));
  const folder = join(place, 'rotund');
  for (const name of ['package.json', 'README.md', 'LICENSE']) cpSync(join(ROOT, name), join(folder, name));
  const node = (args: readonly string[]) => run(process.execPath, args, ROOT);
  node(['scripts/library.mjs', join(folder, 'dist')]);
  const vite = ['node_modules/vite/bin/vite.js', 'build', '--config', 'vite.cli.config.ts'];
  node([...vite, '--outDir', join(folder, 'dist/cli')]);
  return {
    folder,
    run: (command, args, where = folder) => run(command, args, where),
    application: () => {
      const app = join(place, 'app');
      node([
        'node_modules/vite/bin/vite.js',
        'build',
        '--logLevel',
        'error',
        '--outDir',
        app,
        '--emptyOutDir',
      ]);
      return app;
    },
    remove: () => rmSync(place, { recursive: true, force: true }),
  };
}

function run(command: string, args: readonly string[], folder: string): string {
  try {
    return execFileSync(command, args, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
  } catch (error) {
    const { stdout, stderr } = error as { stdout?: string; stderr?: string };
    throw new Error(`${command} ${args.join(' ')}\n${stdout}\n${stderr}`);
  }
}
