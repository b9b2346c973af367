/** The lint rule that keeps the engine's own mathematics out of the pure code, in a folder of its own. */
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';

const ROOT = resolve(import.meta.dirname, '..');
const PLUGIN = 'scripts/engineMath.grit';
const { plugins } = JSON.parse(readFileSync(join(ROOT, 'biome.json'), 'utf8')) as {
  plugins: readonly object[];
};

const folder = mkdtempSync(join(tmpdir(), 'rotund-lint-'));
afterAll(() => rmSync(folder, { recursive: true }));

/** How often the rule speaks of this code in that folder. */
function findings(path: string, code: string): number {
  mkdirSync(join(folder, path), { recursive: true });
  const file = join(folder, path, 'x.ts');
  writeFileSync(file, code);
  const biome = join(ROOT, 'node_modules/.bin/biome');
  const { stdout, stderr } = spawnSync(biome, ['lint', '--only=plugin', '--max-diagnostics=none', file], {
    cwd: folder,
    encoding: 'utf8',
    shell: process.platform === 'win32',
  });
  return `${stdout}${stderr}`.split('Its last bit differs').length - 1;
}

describe('the lint rule', { timeout: 30_000 }, () => {
  mkdirSync(join(folder, 'scripts'));
  cpSync(join(ROOT, PLUGIN), join(folder, PLUGIN));
  writeFileSync(join(folder, 'biome.json'), JSON.stringify({ root: true, plugins }));
  const names =
    'sin cos tan asin acos atan atan2 exp expm1 log log1p log2 log10 pow cbrt sinh cosh tanh hypot';

  it('finds each of the functions, called or handed on, and the power operator', () => {
    const uses = names.split(' ').map((name) => `export const ${name} = [1].map(Math.${name});`);
    const code = [...uses, 'export const p = (x: number) => x ** 2;', 'export const { fround } = Math;'];
    expect(findings('src/math', code.join('\n'))).toBe(uses.length + 2);
  });

  it('leaves alone what is the same everywhere', () => {
    const code = 'export const a = Math.sqrt(2) + Math.max(1, 2) + Math.PI * Math.round(3);';
    expect(findings('src/surface', code)).toBe(0);
  });

  it('speaks in the pure folders only', () => {
    const code = 'export const a = Math.sin(1);';
    expect(findings('src/document/command', code)).toBe(1);
    expect(findings('src/scene', code)).toBe(0);
    expect(findings('tests/math', code)).toBe(0);
  });
});
