import { bindField } from './src/field/bind.ts';
import { polygonizing, locating } from './src/field/polygonize.ts';
import { Raycaster } from './src/field/raycast.ts';
import { sceneNode } from './tests/bench/scenes/index.ts';
import { carvedTree, warpedTree } from './tests/bench/scenes/trees.ts';

const run = <T>(g: Generator<number, T>): T => { for (;;) { const { done, value } = g.next(); if (done) return value as T; } };
const nodes: [string, any][] = [['tree16', sceneNode('tree16')], ['tree64', sceneNode('tree64')], ['tree178', sceneNode('tree178')], ['blob', sceneNode('blob200')], ['carved', carvedTree()], ['warped', warpedTree()], ['1024', sceneNode('tree1024')]];
for (const [name, node] of nodes) {
  const only = process.argv[2]; if (only && only !== name) continue;
  const field = bindField(node);
  let t0 = performance.now();
  const located = run(locating(field, 128));
  const cullWork = located.tally.work;
  const cull = performance.now() - t0;
  const caster = new Raycaster(located);
  const { origin, step, counts } = located.bricks.lattice;
  const c = [0,1,2].map((i) => origin[i]! + 0.5 * step * (counts[i]! - 1));
  const size = (Math.max(...counts) - 1) * step;
  const N = 128;
  t0 = performance.now();
  let hits = 0, bad = 0, worst = 0;
  const v = new Float64Array(4);
  const px = size / N;
  for (let j = 0; j < N; j++) for (let i = 0; i < N; i++) {
    const from = [c[0]! + (i + 0.5 - N / 2) * px, c[1]! + (j + 0.5 - N / 2) * px, c[2]! + 2 * size] as const;
    if (caster.cast({ from: from as any, along: [0, 0, -1], pixel: px, growth: 0 })) {
      hits++;
    }
  }
  const ms = performance.now() - t0;
  const work = caster.work - cullWork;
  // check: value at hit, and no earlier sign change by sampling whole field
  for (let j = 0; j < N; j += 5) for (let i = 0; i < N; i += 5) {
    const from = [c[0]! + (i + 0.5 - N / 2) * px, c[1]! + (j + 0.5 - N / 2) * px, c[2]! + 2 * size] as const;
    const is = caster.cast({ from: from as any, along: [0, 0, -1], pixel: px, growth: 0 });
    const t = is ? caster.hit.t : 3 * size;
    let first = Infinity;
    for (let s = 1.4 * size; s < 2.6 * size; s += px / 8) {
      if (field.value(from[0], from[1], from[2] - s) > 0) { let lo = s - px / 8, hi = s; for (let q = 0; q < 50; q++) { const m = (lo + hi) / 2; if (field.value(from[0], from[1], from[2] - m) > 0) hi = m; else lo = m; } first = hi; break; }
    }
    if (is && first < Infinity) worst = Math.max(worst, Math.abs(first - t) / size);
    if (is !== first < Infinity) { bad++; }
    if (is && first < t - 1e-3 * size) bad++;
  }
  console.log(name, 'cull ms', cull.toFixed(0), 'ray ms', ms.toFixed(0), 'hits', hits / N / N, 'work/pixel', (work / N / N).toFixed(1), 'per hit', (work / hits).toFixed(1), 'bad', bad, 'worst', worst.toExponential(2));
}
