// npm run build: type check, then the application in dist/app, the library in dist/lib with its types, and the command line
// in dist/cli.
import { installPackages, run } from './prepare.mjs';

installPackages();
// What needs the packages themselves comes after them.
const { freshPage } = await import('./cli.mjs');
const { buildLibrary } = await import('./library.mjs');
process.exit(
  run('npx', ['tsc', '--noEmit']) ||
    run('npx', ['vite', 'build', ...process.argv.slice(2)]) ||
    buildLibrary() ||
    (freshPage() ? 0 : 1),
);
