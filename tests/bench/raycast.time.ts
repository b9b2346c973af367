/**
 * Rays onto fields on one thread, against Zhu et al.'s march and plain sphere tracing: pictures of 512² pixels. `ROTUND_SCENES=tree16,tree178` and
 * `ROTUND_PIXELS=128` choose. The others cast every so many rows and columns only, and what they miss is counted along the same rays
 * by intervals in float64.
 */
import { bindField } from '../../src/field/bind.ts';
import { locating } from '../../src/field/polygonize.ts';
import { Raycaster } from '../../src/field/raycast.ts';
import type { RayCamera } from '../../src/field/rayImage.ts';
import { raycasting } from '../../src/field/rayScene.ts';
import { ZhuMarch } from '../../src/field/zhuMarch.ts';
import { rayAt } from '../../src/stroke/plane.ts';
import { finished } from '../field/finished.ts';
import { firstHit } from '../field/rays.ts';
import { type SceneName, sceneNode } from './scenes/index.ts';
import { SphereTracing } from './sphereTracing.ts';
import { rounded } from './timing.ts';

const PIXELS = Number(process.env.ROTUND_PIXELS ?? 512);
/** of the scenes' longest sides: bricks about as large as kernels are wide */
const CELLS: Partial<Record<SceneName, number>> = { tree1024: 320 };
/** of both axes: every so many pixels */
const SPARSE = 8;
/** spheres take long */
const FEW = 64;
const SCENES = (process.env.ROTUND_SCENES?.split(',') ?? [
  'tree16',
  'tree64',
  'tree178',
  'tree1024',
]) as SceneName[];
const HEIGHT: Partial<Record<SceneName, number>> = { tree1024: 5.5 };

const cameraOf = (name: SceneName): RayCamera => ({
  view: { pivot: [0, 0, 0], rotation: [0.1, 0.2, 0, 0.9746794], height: HEIGHT[name] ?? 2.2, fov: 30 },
  width: PIXELS,
  height: PIXELS,
  offset: [0.5, 0.5],
});

const rows = SCENES.map((name) => {
  const node = sceneNode(name);
  const field = bindField(node);
  const camera = cameraOf(name);
  const begun = performance.now();
  const located = finished(locating(field, CELLS[name] ?? 128));
  const culled = performance.now();
  const before = located.tally.work;
  finished(raycasting(located, camera));
  const cast = performance.now();
  const ours = (located.tally.work - before) / PIXELS ** 2;
  const zhu = new ZhuMarch(node);
  const spheres = new SphereTracing(node);
  const caster = new Raycaster(located);
  const missed = { ours: 0, zhu: 0, spheres: 0 };
  const time = { zhu: 0, spheres: 0 };
  let [rays, hits, traces] = [0, 0, 0];
  for (let y = SPARSE / 2; y < PIXELS; y += SPARSE) {
    for (let x = SPARSE / 2; x < PIXELS; x += SPARSE) {
      const { origin, direction } = rayAt(camera.view, camera, x + 0.5, y + 0.5);
      const size = camera.view.height;
      const distance = Math.hypot(...origin);
      const [start, end] = [distance - size, distance + size];
      const ray = { from: origin, along: direction, nearest: 0, pixel: 0, growth: size / PIXELS / distance };
      const timed = (of: 'zhu' | 'spheres', call: () => number | null) => {
        const then = performance.now();
        const found = call();
        time[of] += performance.now() - then;
        return found;
      };
      const theirs = timed('zhu', () => zhu.cast(origin, direction));
      const isTraced = x % FEW === SPARSE / 2 && y % FEW === SPARSE / 2;
      const traced =
        isTraced && timed('spheres', () => spheres.cast(origin, direction, start, end, 1e-4 * size));
      const mine = caster.cast(ray) ? caster.hit.t : null;
      const truth = firstHit(field, ray, start, end, size / PIXELS / 64).t;
      rays++;
      if (isTraced) traces++;
      if (truth === null) continue;
      hits++;
      const isMissed = (t: number | null) => t === null || Math.abs(t - truth) > 0.01 * size;
      if (isMissed(mine)) missed.ours++;
      if (isMissed(theirs)) missed.zhu++;
      if (traced !== false && isMissed(traced)) missed.spheres++;
    }
  }
  return {
    scene: name,
    'hits of rays': `${hits} of ${rays}`,
    'ours, evaluations a pixel': rounded(ours, 1),
    'Zhu’s': rounded(zhu.work / rays, 1),
    spheres: rounded(spheres.work / traces, 1),
    'missed: ours, Zhu’s, spheres': `${missed.ours}, ${missed.zhu}, ${missed.spheres}`,
    'ms: culling': Math.round(culled - begun),
    [`ours, ${PIXELS}²`]: Math.round(cast - culled),
    'Zhu’s, ': Math.round((time.zhu / rays) * PIXELS ** 2),
    'spheres, ': Math.round((time.spheres / traces) * PIXELS ** 2),
  };
});
console.table(rows);
