import { test } from 'vitest';
import { curveOf } from '../../src/stroke/arcLength.ts';
import { FILTER_DEFAULTS, filterStroke } from '../../src/stroke/filter.ts';
import { pairCurves } from '../../src/surface/pair.ts';
import { patchSheet } from '../../src/surface/patch.ts';
import { standingOf } from '../../src/surface/placing.ts';
import { penStroke } from '../fixtures/pen.ts';
import { line } from './curves.ts';
import { arch } from './outlines.ts';
function byHand(seed: number, path: (t: number) => readonly [number, number]) {
  const samples = penStroke(path, { seed, jitter: 0.15, quantise: 0.25, rest: 3, hook: 1 });
  return curveOf(filterStroke(samples, FILTER_DEFAULTS)!);
}
const P = {
  spike: [
    line(...Array.from({ length: 65 }, (_, i) => [-(i * i) / 200, 60 - i / 2] as const)),
    line(...Array.from({ length: 65 }, (_, i) => [(i * i) / 200, 60 - i / 2] as const)),
  ],
  leaf: [
    byHand(3, (t) => [-40 * Math.sin(Math.PI * t), 90 - 180 * t]),
    byHand(4, (t) => [30 * Math.sin(Math.PI * t) * (1 + 0.3 * Math.sin(9 * t)), 90 - 180 * t]),
  ],
} as const;
test('try', () => {
  for (const [name, c] of Object.entries(P)) {
    const pair = pairCurves(c[0], c[1]);
    const s = standingOf(pair);
    console.log(name, pair.stops, c[0].corners, c[1].corners);
    for (const rows of [16,32,64,128,256]) {
      const sheet = patchSheet(s, null as never, [{u:0.3,outline:arch(1)}], { between: 'cubic', rows, columns: 4, subdivisions: { u: 2, v: 0 } });
      const longest = 60;
      const bad: string[] = [];
      let most = 0;
      for (const row of sheet.rows) {
        const st = s.at(row.at.u, row.at.side);
        const d = Math.hypot(row.points[0]! - st.left[0], row.points[1]! - st.left[1]);
        const n = row.points.length;
        const e = Math.hypot(row.points[n-3]! - st.right[0], row.points[n-2]! - st.right[1]);
        const rel = Math.max(d, e) / Math.max(2 * st.radius, 1e-3 * longest);
        most = Math.max(most, rel);
        if (rel > 0.005) bad.push(`${row.at.u.toFixed(4)}:${rel.toFixed(4)} (${Math.max(d,e).toFixed(5)} mm)`);
      }
      console.log(rows, most, bad.length, bad.slice(0, 6).join(' '), '...', bad.slice(-3).join(' '));
    }
  }
});
