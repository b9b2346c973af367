// npm run pictures: renders the samples in every style, and the application, into docs/pictures; thumbnails into public/samples.
import { installPackages, needChromium, run } from './prepare.mjs';

installPackages();
const CHROMIUM = needChromium();
process.exit(run('npx', ['playwright', 'test', '--project', 'pictures', '--reporter=list'], { CHROMIUM }));
