import { defineConfig } from 'vite';

export default defineConfig({
  // Relative addresses, so that the built application runs from any folder.
  base: './',
  server: { port: 5173, strictPort: false },
  build: { target: 'es2022', chunkSizeWarningLimit: 1200 },
  esbuild: false,
});
