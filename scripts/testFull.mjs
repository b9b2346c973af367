// npm run test:full: the unit tests with all their seeds: ten times the mutants of files, and longer walks. Minutes.
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { installPackages, run } from './prepare.mjs';

installPackages();
const file = 'test-results/full.json';
mkdirSync('test-results', { recursive: true });
rmSync(file, { force: true });
const report = ['--reporter=default', '--reporter=json', `--outputFile.json=${file}`];
const status = run('npx', ['vitest', 'run', '--project', 'unit', ...report], { ROTUND_FULL: '1' });

/** A runner that failed without a report (a crash, no test found) is one failure. */
function counts() {
  try {
    const { numPassedTests, numFailedTests, numPendingTests } = JSON.parse(readFileSync(file, 'utf8'));
    return { passed: numPassedTests, failed: numFailedTests, skipped: numPendingTests };
  } catch {
    return { passed: 0, failed: 1, skipped: 0 };
  }
}

const { passed, failed, skipped } = counts();
console.log(`\n${passed} passed, ${failed} failed${skipped ? `, ${skipped} skipped` : ''}`);
process.exit(status === 0 && failed === 0 && passed > 0 ? 0 : 1);
