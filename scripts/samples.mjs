// npm run samples: draws the gallery's drawings anew, from tests/fixtures/samples into public/samples.
// Their thumbnails come from npm run pictures.
import { mkdirSync, writeFileSync } from 'node:fs';
import { installPackages, root } from './prepare.mjs';

installPackages();
const { runnerImport } = await import('vite');
const { module } = await runnerImport(`${root}tests/fixtures/samples/files.ts`, { logLevel: 'error' });
mkdirSync('public/samples', { recursive: true });
for (const [name, text] of Object.entries(module.sampleFiles())) {
  writeFileSync(`public/samples/${name}`, text);
  console.log(`public/samples/${name}  ${Math.ceil(text.length / 1000)} kB`);
}
