import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    // Vitest would leave one core of two to itself.
    maxWorkers: '100%',
    projects: [
      {
        test: {
          name: 'unit',
          include: ['tests/**/*.test.ts'],
          exclude: ['tests/gpu/**'],
          // A busy machine is no failure.
          testTimeout: 60_000,
        },
      },
      { test: { name: 'gpu', include: ['tests/gpu/**/*.test.ts'], testTimeout: 180_000 } },
    ],
    benchmark: { include: ['tests/bench/**/*.bench.ts'] },
  },
});
