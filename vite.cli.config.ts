/**
 * The command line as files in dist/cli. By default the program itself, for Node; with `--mode page` what it opens in
 * Chromium: the element alone; with `--mode bench` the benchmarks of fields.
 */
import { defineConfig, type UserConfig } from 'vite';
import manifest from './package.json' with { type: 'json' };

const program: UserConfig = {
  define: {
    ROTUND_VERSION: JSON.stringify(manifest.version),
    ROTUND_PLAYWRIGHT: JSON.stringify(manifest.devDependencies['playwright-core']),
    ROTUND_WEBGPU: JSON.stringify(manifest.devDependencies.webgpu),
  },
  // One folder that runs anywhere: only the optional packages stay outside.
  ssr: { noExternal: true, external: ['playwright-core', 'webgpu'] },
  build: {
    ssr: 'src/cli/main.ts',
    outDir: 'dist/cli',
    target: 'node20',
    rolldownOptions: {
      output: {
        entryFileNames: 'rotund.js',
        chunkFileNames: '[name]-[hash].js',
        banner: (chunk) => (chunk.isEntry ? '#!/usr/bin/env node' : ''),
      },
    },
  },
};

const page: UserConfig = {
  base: './',
  build: {
    outDir: 'dist/cli/page',
    target: 'es2022',
    chunkSizeWarningLimit: 1200,
    modulePreload: { polyfill: false },
    rolldownOptions: {
      input: { sketch: 'src/element/define.ts' },
      output: { entryFileNames: '[name].js', chunkFileNames: '[name]-[hash].js' },
    },
  },
};

/** What `npm run bench` times in Node, bundled first: a test runner's import accessors cost more than a segment does. */
const bench: UserConfig = {
  ssr: { noExternal: true, external: ['webgpu'] },
  build: {
    ssr: true,
    outDir: 'dist/bench',
    target: 'node20',
    rolldownOptions: {
      input: ['segment', 'polygon', 'scene', 'polygonize', 'raycast', 'silhouettes', 'surfaces', 'gpu'].map(
        (what) => `tests/bench/${what}.time.ts`,
      ),
    },
  },
};

export default defineConfig(({ mode }) => ({
  publicDir: false,
  logLevel: 'warn',
  ...(mode === 'page' ? page : mode === 'bench' ? bench : program),
}));
