import { defineConfig } from 'vite';

export default defineConfig({
  // Relative addresses, so that the built application runs from any folder.
  base: './',
  server: { port: 5173 },
  // Lit's build for development says at each start that it is one.
  resolve: { conditions: ['module', 'browser', 'production'] },
  build: {
    outDir: 'dist/app',
    target: 'es2022',
    chunkSizeWarningLimit: 1200,
    rolldownOptions: { input: ['index.html', 'field.html'] },
  },
  // Known at the start: found late, they would reload the page under a stroke.
  optimizeDeps: {
    include: [
      'three/webgpu',
      'three/tsl',
      'three-mesh-bvh',
      'camera-controls',
      'gl-matrix',
      'lit',
      'idb',
      'browser-fs-access',
      '@gltf-transform/core',
    ],
  },
});
