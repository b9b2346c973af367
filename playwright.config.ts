import { defineConfig } from '@playwright/test';
import { findChromium, QUIET, SOFTWARE_WEBGPU } from './scripts/chromium.mjs';

const executablePath = findChromium() ?? '/usr/bin/chromium';

export default defineConfig({
  testDir: 'e2e',
  testMatch: '**/*.spec.ts',
  // One browser at a time: the software adapter takes every core there is.
  workers: 1,
  timeout: 90_000,
  expect: { timeout: 20_000 },
  forbidOnly: Boolean(process.env.CI),
  outputDir: 'test-results/browser',
  reporter: [['list'], ['json', { outputFile: 'test-results/playwright.json' }]],
  use: {
    baseURL: 'http://localhost:5199',
    viewport: { width: 800, height: 600 },
    launchOptions: { executablePath, args: [...SOFTWARE_WEBGPU, ...QUIET] },
    trace: 'off',
  },
  webServer: {
    command:
      'npx vite build -c vite.e2e.config.ts --logLevel error && npx vite preview -c vite.e2e.config.ts',
    url: 'http://localhost:5199',
    stdout: 'ignore',
  },
  projects: [
    { name: 'chromium' },
    { name: 'pictures', testMatch: '**/pictures/*.make.ts' },
    { name: 'bench', testMatch: '**/bench/*.time.ts' },
  ],
});
