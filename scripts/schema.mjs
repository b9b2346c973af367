// Writes docs/rotund.schema.json from the schemas that read files; a test holds the two together.
import { writeFileSync } from 'node:fs';
import { runnerImport } from 'vite';
import { run } from './prepare.mjs';

const FILE = 'docs/rotund.schema.json';
const { module } = await runnerImport('./tests/document/jsonSchema.ts', { configFile: false });
writeFileSync(FILE, `${JSON.stringify(module.jsonSchema(), null, 2)}\n`);
process.exit(run('npx', ['biome', 'format', '--write', FILE]));
