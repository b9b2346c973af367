import { defineConfig, type Plugin } from 'vite';
import manifest from './package.json' with { type: 'json' };

const packages = Object.keys(manifest.dependencies);

/** A worker's address as Vite writes it into a library: absolute, and hidden from the bundler of whoever uses the library. */
const HIDDEN = /new URL\(\s*\/\* @vite-ignore \*\/\s*"\/assets\/([\w.-]+)",\s*"" \+ import\.meta\.url\s*\)/g;

/** Workers lie beside the chunks that start them, said so that every bundler takes them along. */
const workersBeside: Plugin = {
  name: 'workers-beside',
  enforce: 'post',
  generateBundle(_, bundle) {
    for (const chunk of Object.values(bundle)) {
      if (chunk.type !== 'chunk') continue;
      const up = '../'.repeat(chunk.fileName.split('/').length - 1) || './';
      chunk.code = chunk.code.replace(HIDDEN, `new URL("${up}assets/$1", import.meta.url)`);
      if (chunk.code.includes('"/assets/'))
        this.error(`${chunk.fileName} names a file by an absolute address`);
    }
  },
};

/** The library: its own code only, readable, in the chunks it is fetched in; the packages it needs stay packages. */
export default defineConfig({
  publicDir: false,
  plugins: [workersBeside],
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
