import { describe, expect, test } from 'vitest';
import { length3, sub3 } from '../../src/math/tuple.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import { controlNet, netLines, patchCounts } from '../../src/surface/controlNet.ts';
import { sheetMesh } from '../../src/surface/index.ts';
import { type PatchOptions, patchSheet } from '../../src/surface/patch.ts';
import { circle, FLAT, halfCircle, line } from './curves.ts';
import { arch, bumpy, DIAMOND, oval, ridge } from './sections.ts';

const OPTIONS: PatchOptions = { between: 'cubic', rows: 12, columns: 8, subdivisions: { u: 1, v: 2 } };
const source = (...curves: Curve[]) => ({ curves, radius: 10, pressure: false, caps: 'none' }) as const;

const FORMS = {
  'a ball': source(halfCircle(50, -1), halfCircle(50, 1)),
  'lines that cross': source(line([-20, 50], [20, -50]), line([20, 50], [-20, -50])),
  'a ring': source(circle(0, 0, 10), circle(0, 0, 30, -1, 1)),
  'a tube': source(halfCircle(50, 1)),
};
const SETS = {
  open: [
    { u: 0.3, outline: arch(1) },
    { u: 0.7, outline: ridge(0.4, 0, 1) },
  ],
  seamless: [
    { u: 0.3, outline: oval(1) },
    { u: 0.7, outline: bumpy(5, 0.1) },
  ],
  creased: [{ u: 0.5, outline: DIAMOND }],
};

for (const [name, input] of Object.entries(FORMS)) {
  for (const [set, sections] of Object.entries(SETS)) {
    describe(`${name}, ${set}`, () => {
      test('its triangles are as many as counted', () => {
        for (const rows of [1, 12, null]) {
          for (const subdivisions of [OPTIONS.subdivisions, { u: 0, v: 0 }, { u: 3, v: 1 }]) {
            const options = { ...OPTIONS, rows, subdivisions };
            const mesh = sheetMesh(patchSheet(input, sections, options), FLAT);
            expect(patchCounts(input, sections, options).triangles).toBe(mesh.indices.length / 3);
          }
        }
      });

      test('each subdivision doubles the quads and leaves the controls alone', () => {
        const at = (u: number, v: number) =>
          patchCounts(input, sections, { ...OPTIONS, subdivisions: { u, v } });
        expect(at(1, 2).triangles).toBe(2 * at(1, 1).triangles);
        expect(at(3, 2).controls).toBe(at(0, 0).controls);
      });

      test('lines of the net run through every control', () => {
        const net = controlNet(input, sections, OPTIONS);
        const { controls } = patchCounts(input, sections, OPTIONS);
        const round = set === 'seamless' ? net.rows.length : 0;
        expect(net.rows.length * net.columns.vs.length).toBe(controls + round);
        const lines = netLines(net);
        const places = lines.flatMap((points) => points.map(String));
        for (const { points } of net.rows) {
          for (let k = 0; k < points.length; k += 3) {
            expect(places).toContain(String([points[k], points[k + 1], points[k + 2]]));
          }
        }
        net.rows.forEach(({ at }, i) => {
          if (net.rows[i]!.joined) expect(at.u).toBeGreaterThan(net.rows[i - 1]!.at.u);
        });
      });
    });
  }
}

test('controls are nearer to the patch with more of them', () => {
  const input = FORMS['a ball'];
  const nearest = (rows: number): number => {
    const net = controlNet(input, SETS.seamless, { ...OPTIONS, rows, columns: rows });
    const sheet = patchSheet(input, SETS.seamless, { ...OPTIONS, rows, columns: rows })!;
    const points = sheet.rows.flatMap((row) =>
      sheet.columns.vs.map(
        (_, j) => [row.points[3 * j]!, row.points[3 * j + 1]!, row.points[3 * j + 2]!] as const,
      ),
    );
    const away = netLines(net)
      .flat()
      .map((p) => Math.min(...points.map((q) => length3(sub3(p, q)))));
    return Math.max(...away);
  };
  expect(nearest(16)).toBeLessThan(nearest(8) / 1.8);
});
