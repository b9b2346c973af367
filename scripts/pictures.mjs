// npm run pictures: draws with a pen in Chromium and renders every style into docs/pictures.
import { installPackages, needChromium, run } from './prepare.mjs';

installPackages();
const CHROMIUM = needChromium();
process.exit(run('npx', ['playwright', 'test', '--project', 'pictures', '--reporter=list'], { CHROMIUM }));
