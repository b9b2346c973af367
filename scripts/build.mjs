// npm run build: type check, then the application in dist/.
import { installPackages, run } from './prepare.mjs';

installPackages();
process.exit(run('npx', ['tsc', '--noEmit']) || run('npx', ['vite', 'build', ...process.argv.slice(2)]));
