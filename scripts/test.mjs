// npm test: everything CI runs, from a fresh clone. Ends with one line that sums all runners.
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { dawnEnvironment } from './chromium.mjs';
import { installPackages, needChromium, run } from './prepare.mjs';

installPackages();
const chromium = needChromium();
const out = 'test-results';
rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
const total = { passed: 0, failed: 0, skipped: 0 };

/** A step without counts of its own is one test. */
function check(name, command, args) {
  console.log(`\n── ${name}`);
  const passed = run(command, args) === 0;
  total[passed ? 'passed' : 'failed'] += 1;
}

/** A runner that failed without saying what failed (a crash, no test found) is one failure. */
function suite(name, args, environment, read) {
  console.log(`\n── ${name}`);
  const status = run('npx', args, environment);
  const counts = { passed: 0, failed: 0, skipped: 0 };
  try {
    Object.assign(counts, read());
  } catch {
    // no report was written: counted below
  }
  if (status !== 0 && counts.failed === 0) counts.failed = 1;
  if (counts.passed + counts.failed === 0) counts.failed = 1;
  for (const key of Object.keys(total)) total[key] += counts[key];
}

const json = (file) => JSON.parse(readFileSync(file, 'utf8'));

function vitest(project, environment) {
  const file = `${out}/${project}.json`;
  const args = ['vitest', 'run', '--project', project, '--reporter=default', '--reporter=json'];
  suite(`${project} tests`, [...args, `--outputFile.json=${file}`], environment, () => {
    const report = json(file);
    return { passed: report.numPassedTests, failed: report.numFailedTests, skipped: report.numPendingTests };
  });
}

check('types', 'npx', ['tsc', '--noEmit']);
check('lint', 'npx', ['biome', 'check']);
vitest('unit', {});
vitest('gpu', dawnEnvironment(chromium));
suite('browser tests', ['playwright', 'test', '--project', 'chromium'], { CHROMIUM: chromium }, () => {
  const { expected, unexpected, flaky, skipped } = json(`${out}/playwright.json`).stats;
  return { passed: expected, failed: unexpected + flaky, skipped };
});

console.log(
  `\n${total.passed} passed, ${total.failed} failed${total.skipped ? `, ${total.skipped} skipped` : ''}`,
);
process.exit(total.failed ? 1 : 0);
