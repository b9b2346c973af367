// npm run build: type check, then the application in dist/app, the library in dist/lib with its types, and the command line
// in dist/cli.
import { freshPage } from './cli.mjs';
import { buildLibrary } from './library.mjs';
import { installPackages, run } from './prepare.mjs';

installPackages();
process.exit(
  run('npx', ['tsc', '--noEmit']) ||
    run('npx', ['vite', 'build', ...process.argv.slice(2)]) ||
    buildLibrary() ||
    (freshPage() ? 0 : 1),
);
