import { test } from 'vitest';
import { pairCurves } from '../../src/surface/pair.ts';
import { standingOf } from '../../src/surface/placing.ts';
import { patchSheet } from '../../src/surface/patch.ts';
import { place } from '../../src/surface/stand.ts';
import { halfCircle, line, circle } from './curves.ts';
import { arch, bumpy, oval, ridge, DIAMOND } from './outlines.ts';

test('try', () => {
  const s = standingOf(pairCurves(halfCircle(50, -1), line([0, 50], [30, 20], [0, -50])));
  for (const rows of [4, 8, 16, 32, 64]) {
    for (const outline of [oval(0.5), DIAMOND, arch(1), bumpy(5, 0.1)]) {
      const sheet = patchSheet(s, null as never, [{ u: 0.3, outline }, { u: 0.7, outline }], { between: 'cubic', rows, columns: 2*rows, subdivisions: { u: 1, v: 1 } });
      let most = 0, mostN = 0, nan = 0;
      for (const row of sheet.rows) {
        const stand = s.at(row.at.u, row.at.side);
        sheet.columns.vs.forEach((v, j) => {
          const p = place(stand, outline.point(v));
          const d = Math.hypot(...[0, 1, 2].map((k) => p[k]! - row.points[3 * j + k]!));
          most = Math.max(most, d);
          if (!row.normals.every(Number.isFinite)) nan++;
        });
      }
      console.log(rows, sheet.rows.length, sheet.columns.vs.length, most.toExponential(2), nan, sheet.rows[3].flipped);
    }
  }
});
