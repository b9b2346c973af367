// npm run bench: the pure parts in Node, then the application in Chromium on whatever adapter it finds.
import { installPackages, needChromium, run } from './prepare.mjs';

installPackages();
const CHROMIUM = needChromium();
process.exit(
  run('npx', ['vitest', 'bench', '--run', '--project', 'unit']) ||
    run('npx', ['playwright', 'test', '--project', 'bench', '--reporter=line'], { CHROMIUM }),
);
