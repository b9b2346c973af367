/** The page about the element says what its source says. */
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { expect, it } from 'vitest';
import { tokens } from '../../src/element/tokens.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const page = readFileSync(resolve(ROOT, 'docs/element.md'), 'utf8');

it('the tables of docs/element.md are those of the source', { timeout: 60_000 }, () => {
  expect(() =>
    execFileSync(process.execPath, ['scripts/manifest.mjs', '--check'], { cwd: ROOT, encoding: 'utf8' }),
  ).not.toThrow();
});

it('every CSS property it names is one of the element’s', () => {
  const named = [...page.matchAll(/^\| `(--[\w-]+)` \|/gm)].map(([, name]) => name!);
  expect(named.length).toBeGreaterThan(8);
  expect(named.filter((name) => !tokens.cssText.includes(`${name}:`))).toEqual([]);
});
