// What a fresh clone lacks: the packages of package-lock.json and, for tests and pictures, a Chromium.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { findChromium } from './chromium.mjs';

export const root = fileURLToPath(new URL('..', import.meta.url));
process.chdir(root);

/** Output that is no result goes to standard error, and standard input is left to whom it is meant for. */
export const ASIDE = ['ignore', 2, 2];

/** Runs a command with the terminal attached; returns its exit status. */
export function run(command, args, environment = {}, stdio = 'inherit') {
  const result = spawnSync(command, args, {
    stdio,
    env: { ...process.env, ...environment },
    shell: process.platform === 'win32',
  });
  return result.status ?? 1;
}

const [major, minor] = process.versions.node.split('.').map(Number);
if (major < 20 || (major === 20 && minor < 20)) {
  console.error(`Rotund needs Node 20.20 or newer; this is ${process.version}.`);
  process.exit(1);
}

/** Installs the packages unless those of this very package-lock.json are there already. */
export function installPackages() {
  const stamp = 'node_modules/.rotund-lock';
  const lock = createHash('sha256').update(readFileSync('package-lock.json')).digest('hex');
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === lock) return;
  console.error('Installing packages …');
  // The packages' own install scripts are not needed by any of ours.
  if (
    run('npm', ['ci', '--ignore-scripts', '--no-fund', '--no-audit', '--loglevel=error'], {}, ASIDE) !== 0
  ) {
    console.error('npm ci failed; the lines above say why.');
    process.exit(1);
  }
  writeFileSync(stamp, lock);
}

function installByApt() {
  if (process.getuid?.() !== 0 || !existsSync('/usr/bin/apt-get')) return;
  console.log('Installing Chromium …');
  run('apt-get', ['update', '-qq']);
  run('apt-get', ['install', '-y', '-qq', '--no-install-recommends', 'chromium', 'fonts-liberation'], {
    DEBIAN_FRONTEND: 'noninteractive',
  });
}

/** The path of Chromium, installed by apt when we may; else says what to install and stops. */
export function needChromium() {
  if (!findChromium()) installByApt();
  const chromium = findChromium();
  if (chromium) return chromium;
  console.error(
    'Chromium is missing. Install it (Debian and Ubuntu: sudo apt-get install chromium) or set CHROMIUM to its path.',
  );
  process.exit(1);
}
