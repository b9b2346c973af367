import { defineConfig } from 'vite';
import manifest from './package.json' with { type: 'json' };

const packages = Object.keys(manifest.dependencies);

/** The library: its own code only, readable, in the chunks it is fetched in; the packages it needs stay packages. */
export default defineConfig({
  publicDir: false,
  build: {
    outDir: 'dist/lib',
    target: 'es2022',
    minify: false,
    lib: {
      entry: { rotund: 'src/element/index.ts', define: 'src/element/define.ts' },
      formats: ['es'],
    },
    rolldownOptions: {
      external: (id) => packages.some((name) => id === name || id.startsWith(`${name}/`)),
      output: { entryFileNames: '[name].js', chunkFileNames: 'chunks/[name].js' },
    },
  },
});
