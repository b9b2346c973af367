// Builds the command line into dist/cli, and the page it draws on into dist/cli/page, when their sources have changed.
import { createHash } from 'node:crypto';
import {
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { ASIDE, run } from './prepare.mjs';

export const PROGRAM = 'dist/cli/rotund.js';

const SOURCES = ['src', 'shaders', 'package.json', 'package-lock.json', 'vite.cli.config.ts'];

/** By contents, not by dates: a checkout gives every file a new one. */
function fingerprint() {
  const hash = createHash('sha256');
  for (const file of SOURCES.flatMap(filesIn))
    hash.update(`${file}\0`).update(readFileSync(file)).update('\0');
  return hash.digest('hex');
}

function filesIn(path) {
  if (statSync(path).isFile()) return [path];
  const entries = readdirSync(path, { recursive: true, withFileTypes: true });
  return entries
    .filter((entry) => entry.isFile())
    .map((entry) => `${entry.parentPath}/${entry.name}`)
    .sort();
}

/** Makes both folders what the sources say; false when that failed, which standard error then explains. */
export function freshProgram(sources = fingerprint()) {
  return fresh('the command line', 'dist/cli', [], sources);
}

export function freshPage(sources = fingerprint()) {
  return (
    freshProgram(sources) && fresh('the page for pictures', 'dist/cli/page', ['--mode', 'page'], sources)
  );
}

function fresh(what, folder, args, sources) {
  const stamp = `${folder}/.sources`;
  const isFresh = () => existsSync(stamp) && readFileSync(stamp, 'utf8') === sources;
  if (isFresh()) return true;
  console.error(`Building ${what} …`);
  // Beside its place first: another command may be running from there.
  const made = `dist/.making-${process.pid}`;
  mkdirSync('dist', { recursive: true });
  const vite = ['node_modules/vite/bin/vite.js', 'build', '--config', 'vite.cli.config.ts'];
  if (run(process.execPath, [...vite, ...args, '--outDir', made], {}, ASIDE) !== 0) return false;
  writeFileSync(`${made}/.sources`, sources);
  rmSync(folder, { recursive: true, force: true });
  try {
    renameSync(made, folder);
  } catch (error) {
    // Another command has just put the same there.
    rmSync(made, { recursive: true, force: true });
    if (!isFresh()) throw error;
  }
  return true;
}
