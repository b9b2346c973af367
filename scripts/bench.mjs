// npm run bench: the pure parts in Node, fields bundled (in JavaScript, then on the GPU), then the application in Chromium on whatever adapter it finds.
import { dawnEnvironment } from './chromium.mjs';
import { installPackages, needChromium, run } from './prepare.mjs';

installPackages();
const CHROMIUM = needChromium();
process.exit(
  run('npx', ['vitest', 'bench', '--run', '--project', 'unit']) ||
    run('npx', ['vite', 'build', '-c', 'vite.cli.config.ts', '--mode', 'bench']) ||
    run('node', ['dist/bench/segment.time.js']) ||
    run('node', ['dist/bench/polygon.time.js']) ||
    run('node', ['dist/bench/scene.time.js']) ||
    run('node', ['dist/bench/polygonize.time.js']) ||
    run('node', ['dist/bench/raycast.time.js']) ||
    run('node', ['dist/bench/silhouettes.time.js']) ||
    run('node', ['dist/bench/surfaces.time.js']) ||
    run('node', ['dist/bench/gpu.time.js'], dawnEnvironment(CHROMIUM)) ||
    run('npx', ['playwright', 'test', '--project', 'bench', '--reporter=line'], { CHROMIUM }),
);
