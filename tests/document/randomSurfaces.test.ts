/** 200 surfaces of random strokes, 2,000 with ROTUND_FULL: no exception, numbers all of it, closed ones watertight and outward. */
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { shapeOf } from '../../src/document/build.ts';
import { curveOfStroke } from '../../src/document/curves.ts';
import { EMPTY_DOCUMENT, type SurfacePart } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { outlinesOf } from '../../src/document/outlines.ts';
import { parse, serialize } from '../../src/document/serialize.ts';
import { cross2 } from '../../src/math/tuple.ts';
import { topology } from '../../src/mesh/check.ts';
import { bounds, volume } from '../../src/mesh/measure.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { weld } from '../../src/mesh/weld.ts';
import type { Outline } from '../../src/surface/outline.ts';
import { anySurface } from './anySurface.ts';

const BLOCKS = process.env.ROTUND_FULL ? 40 : 4;
const BLOCK = 50;

/** Nothing of it is open: a back or a round section that encloses something, and ends that are shut. */
function isClosed(part: SurfacePart): boolean {
  const { kind, strokes, brush } = part;
  const curves = strokes.map((stroke) => curveOfStroke(stroke, brush)!);
  const sections = outlinesOf(kind, part, brush, curves);
  return brush.caps && sections.every(({ outline }) => outline.closed && Math.abs(areaOf(outline)) > 0.01);
}

function areaOf({ point }: Outline): number {
  const points = Array.from({ length: 128 }, (_, i) => point(i / 128));
  return points.reduce((sum, p, i) => sum + cross2(points.at(i - 1)!, p) / 2, 0);
}

/** Triangles run through every edge as often one way as the other, though sheets may touch along some. */
function isBalanced({ positions, indices }: Mesh): boolean {
  const { ids } = weld(positions);
  const sums = new Map<string, number>();
  for (let t = 0; t < indices.length; t += 3)
    for (let k = 0; k < 3; k++) {
      const [a, b] = [ids[indices[t + k]!]!, ids[indices[t + ((k + 1) % 3)]!]!];
      const edge = a < b ? `${a} ${b}` : `${b} ${a}`;
      sums.set(edge, (sums.get(edge) ?? 0) + (a < b ? 1 : -1));
    }
  return [...sums.values()].every((sum) => sum === 0);
}

/** of the size cubed: coarse meshes of surfaces that overlap themselves enclose so much less than nothing */
const COARSE = 2e-3;

function expectSound(part: SurfacePart): void {
  const mesh = shapeOf(part);
  if (!mesh || mesh.indices.length === 0) return;
  expect(topology(mesh).finite).toBe(true);
  if (!isClosed(part)) return;
  expect(isBalanced(mesh)).toBe(true);
  // bends as nobody bends turn parts of it inside out
  if (part.bends.some(({ isOff }) => !isOff)) return;
  const { min, max } = bounds(mesh);
  const size = Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
  expect(volume(mesh) / size ** 3).toBeGreaterThan(-COARSE);
}

describe.each(Array.from({ length: BLOCKS }, (_, block) => block + 1))('surfaces of seed %i', (seed) => {
  it('are sound, and the same from a file', { timeout: 240_000 }, () => {
    fc.assert(
      fc.property(anySurface, (part) => {
        expectSound(part);
        const document = { ...EMPTY_DOCUMENT, parts: [part], nextId: 2 };
        expect(parse(serialize({ ...EMPTY_DRAWING, document }), 'x').document).toEqual(document);
      }),
      { seed, numRuns: BLOCK, endOnFailure: true, verbose: 0 },
    );
  });
});
