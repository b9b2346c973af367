// npm start: everything a newcomer needs, then the application's address.
import { installPackages, run } from './prepare.mjs';

installPackages();
process.exit(run('npx', ['vite', ...process.argv.slice(2)]));
