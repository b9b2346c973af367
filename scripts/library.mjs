// The library as the package has it: its modules, their types, and the manifest of the element. `node scripts/library.mjs
// FOLDER` builds it somewhere else than in dist.
import { existsSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { writeManifest } from './manifest.mjs';
import { run } from './prepare.mjs';

const TYPED = ['index', 'define'].map((entry) => `element/${entry}.d.ts`);

/** Returns the exit status of the first step that failed, or 0. */
export function buildLibrary(folder = 'dist') {
  const modules = [
    'vite',
    'build',
    '-c',
    'vite.lib.config.ts',
    '--outDir',
    join(folder, 'lib'),
    '--emptyOutDir',
  ];
  const types = join(folder, 'types');
  rmSync(types, { recursive: true, force: true });
  const status = run('npx', modules) || run('npx', ['tsc', '-p', 'tsconfig.lib.json', '--outDir', types]);
  if (status) return status;
  prune(types);
  writeManifest(join(folder, 'custom-elements.json'));
  return 0;
}

/** Types that no entry leads to are nobody's; those of the scene would ask for types of three.js. */
function prune(folder) {
  const wanted = new Set();
  const visit = (file) => {
    if (wanted.has(file) || !existsSync(file)) return;
    wanted.add(file);
    for (const [, name] of readFileSync(file, 'utf8').matchAll(/(?:from|import)\s*\(?\s*['"](\.[^'"]+)['"]/g))
      visit(resolve(dirname(file), name.replace(/\.ts$/, '.d.ts')));
  };
  for (const entry of TYPED) visit(resolve(folder, entry));
  for (const path of readdirSync(folder, { recursive: true })) {
    const file = resolve(folder, path);
    if (file.endsWith('.d.ts') && !wanted.has(file)) rmSync(file);
  }
  for (const path of readdirSync(folder, { recursive: true }).sort().reverse()) {
    const file = resolve(folder, path);
    if (!file.endsWith('.d.ts') && readdirSync(file).length === 0) rmSync(file, { recursive: true });
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const [folder] = process.argv.slice(2);
  process.exit(buildLibrary(folder && relative('.', folder)));
}
