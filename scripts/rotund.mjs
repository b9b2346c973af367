// npm run rotund: the command line. What is stale is built first; all that has to be said about it goes to standard error.
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

// npm runs scripts in the package's folder; files are named from where the person stands.
const { npm_lifecycle_event: event, INIT_CWD } = process.env;
const here = (event === 'rotund' && INIT_CWD) || process.cwd();

const { installPackages } = await import('./prepare.mjs');
const { freshPage, freshProgram, PROGRAM } = await import('./cli.mjs');
installPackages();
if (!(process.argv[2] === 'render' ? freshPage() : freshProgram())) process.exit(1);
const program = pathToFileURL(resolve(PROGRAM)).href;
process.chdir(here);
await import(program);
