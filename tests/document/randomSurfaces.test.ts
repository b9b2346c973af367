/**
 * 200 surfaces of random strokes, 2,000 with ROTUND_FULL: no exception, numbers all of it, closed ones watertight and outward.
 * Outward: of what is bent, where no slab between rows is turned over by it and rows stay the same (corners of bends add some).
 */
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { shapeOf } from '../../src/document/build.ts';
import { curveOfStroke } from '../../src/document/curves.ts';
import { EMPTY_DOCUMENT, type SurfacePart } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { outlinesOf } from '../../src/document/outlines.ts';
import { parse, serialize } from '../../src/document/serialize.ts';
import { sheetOf } from '../../src/document/sheets.ts';
import { add3, cross2, cross3, dot3, scale3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
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

/** where meshes are so coarse that those of surfaces which overlap themselves enclose less than nothing */
const FINE = { u: 256, v: 96 };
/** of the size cubed: as much less than nothing do fine ones enclose at most */
const COARSE = 5e-4;

/** Volume of the size cubed. */
function volumeShare(mesh: Mesh): number {
  const { min, max } = bounds(mesh);
  const size = Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
  return volume(mesh) / size ** 3;
}

/**
 * Between neighbouring rows the bent solid has volume of the sign that the straight one has there, but for slabs of next to none:
 * where that is so, no part of it was turned inside out.
 */
function keepsFacing(part: SurfacePart): boolean {
  const sheets = [{ ...part, bends: [] }, part].map((form) => sheetOf(part.kind, form, part.brush));
  const [straight, bent] = sheets.map((sheet) => sheet?.rows.map(({ points }) => points) ?? []);
  if (straight!.length !== bent!.length) return false;
  const [before, after] = [slabsOf(straight!), slabsOf(bent!)];
  const least = THIN * after.reduce((sum, volume) => sum + Math.abs(volume), 0);
  return after.every((volume, i) => volume * before[i]! >= 0 || Math.abs(volume) < least);
}

/** of the whole: slabs at poles and seams, which rounding turns */
const THIN = 1e-4;

const slabsOf = (rows: readonly Float64Array[]): number[] =>
  rows.slice(1).map((row, i) => slab(rows[i]!, row));

/** mm³ between two rows of one solid, closed by a fan about the middle of each. */
function slab(a: Float64Array, b: Float64Array): number {
  const [p, q] = [pointsOf(a), pointsOf(b)];
  const [top, end] = [middleOf(p), middleOf(q)];
  let six = 0;
  const add = (r: Vec3, s: Vec3, t: Vec3): void => {
    six += dot3(sub3(r, top), cross3(sub3(s, top), sub3(t, top)));
  };
  const count = Math.min(p.length, q.length);
  for (let k = 0; k < count; k++) {
    const next = (k + 1) % count;
    add(p[k]!, q[k]!, q[next]!);
    add(p[k]!, q[next]!, p[next]!);
    add(end, q[next]!, q[k]!);
  }
  return six / 6;
}

const pointsOf = (row: Float64Array): Vec3[] =>
  Array.from({ length: row.length / 3 }, (_, k) => [row[3 * k]!, row[3 * k + 1]!, row[3 * k + 2]!]);

const middleOf = (points: readonly Vec3[]): Vec3 =>
  scale3(
    points.reduce((sum, p) => add3(sum, p), [0, 0, 0] as Vec3),
    1 / points.length,
  );

function expectSound(part: SurfacePart): void {
  const mesh = shapeOf(part);
  if (!mesh || mesh.indices.length === 0) return;
  expect(topology(mesh).finite).toBe(true);
  if (!isClosed(part)) return;
  expect(isBalanced(mesh)).toBe(true);
  if (!keepsFacing(part)) return;
  const share = volumeShare(mesh);
  if (!(share >= 0)) expect(volumeShare(shapeOf(part, FINE)!)).toBeGreaterThan(-COARSE);
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
