import { expect, it } from 'vitest';
import { solidOf } from '/work/main/src/document/build.ts';
import { topology } from '/work/main/src/mesh/check.ts';
import { DEFAULT_BRUSH } from '/work/main/src/document/document.ts';
import { UNMOVED } from '/work/main/src/math/placement.ts';
import { random } from '/work/main/tests/fixtures/random.ts';
const PLANE = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] } as any;
const stroke = (n: number, f: (i: number) => [number, number], height = 200, closed = false) => ({
  samples: Array.from({ length: n }, (_, i) => { const [x, y] = f(i); return { x, y, pressure: 0.5, tiltX: 0, tiltY: 0, time: 8 * i }; }),
  plane: PLANE, view: { pivot: [0, 0, 0], rotation: [0, 0, 0, 1], height, fov: 0 }, pointer: 'pen', closed,
}) as any;
const part = (kind: string, strokes: any[], brush = {}) => ({ id: 'a', name: 'a', kind, strokes, brush: { ...DEFAULT_BRUSH, ...brush }, placement: UNMOVED, hidden: false }) as any;
const run = (name: string, p: any) => {
  const t = performance.now();
  let s: any;
  try { s = solidOf(p); } catch (e) { console.log(name, 'THROWS', String(e), Math.round(performance.now() - t)); return; }
  const t2 = performance.now();
  const top = s && topology(s.mesh);
  console.log(name, Math.round(t2 - t), 'ms', s && s.mesh.positions.length / 3, top && top.finite, top && top.watertight, top && top.degenerate);
};
it('worst', () => {
  const r = random(1);
  const rnd = (k: number) => () => [k * (r() - 0.5), k * (r() - 0.5)] as [number, number];
  const zig = (k: number) => (i: number) => [i * k, (i % 2) * 50] as [number, number];
  for (const n of [1000, 10000, 100000]) {
    run(`random ${n} tube`, part('tube', [stroke(n, rnd(2e6))]));
    run(`zigzag ${n} tube`, part('tube', [stroke(n, zig(5))]));
    run(`zigzag ${n} rot`, part('rotational', [stroke(n, zig(5)), stroke(n, (i) => [i * 5, 200 + (i % 2) * 50])]));
    run(`random ${n} rot`, part('rotational', [stroke(n, rnd(2e6)), stroke(n, rnd(2e6))]));
  }
  for (const levels of [0, 1, 3, 6]) for (const filter of ['least-squares', 'chaikin', 'cubic'])
    run(`tiny height levels ${levels} ${filter}`, part('tube', [stroke(200, (i) => [1e4 * i, 1e5 * Math.sin(i / 20)], 1e-6)], { levels, filter }));
  run('huge height', part('tube', [stroke(200, (i) => [i, 10 * Math.sin(i / 20)], 1e6)]));
  run('tiny stroke', part('tube', [stroke(200, (i) => [i*1e-9, 1e-8 * Math.sin(i / 20)], 200)]));
  run('tiny radius', part('tube', [stroke(200, (i) => [i*1e4, 1e5 * Math.sin(i / 20)], 200)], {radius: 0.1}));
  run('denormal', part('tube', [stroke(200, (i) => [i*5e-324, 5e-324 * (i%7)], 200)], {radius: 0.1}));
  run('denormal rot', part('rotational', [stroke(200, (i) => [i*5e-324, 5e-324 * (i%7)], 200),stroke(200, (i) => [i*1e-160, 1e-160 * (i%7)], 200)], {radius: 0.1}));
}, 600000);
