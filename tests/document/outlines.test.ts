/** What is drawn over parts of closed sections: they enclose what the line goes round an odd number of times, and nothing backwards. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { buildForm } from '../../src/document/build.ts';
import { curveOfStroke } from '../../src/document/curves.ts';
import { DEFAULT_BRUSH } from '../../src/document/document.ts';
import { outlinesOf } from '../../src/document/outlines.ts';
import { PLAIN, ROUND, type Section } from '../../src/document/surfacePart.ts';
import { cross3, distance2, dot3, length3, sub3 } from '../../src/math/tuple.ts';
import type { Vec2, Vec3 } from '../../src/math/vec.ts';
import { eachTriangle } from '../../src/mesh/measure.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import type { Stroke } from '../../src/stroke/stroke.ts';
import { round } from '../../src/surface/joined.ts';
import { type Outline, outlineOf } from '../../src/surface/outline.ts';
import { redrawn } from '../../src/surface/oversketch.ts';
import { selfCrossings } from '../../src/surface/selfCrossings.ts';
import { expectOdd, grid, polygonOf, windingOf } from '../surface/winding.ts';
import { PLANE, strokeAlong } from './strokes.ts';

const SIDES = [-20, 20].map((x) => strokeAlong((t) => [x, 40 - 80 * t]));
const HALF = 20;

/** In half chords. */
const drawn = (points: readonly Vec2[], closed = false): Stroke =>
  strokeAlong(
    (t) => {
      const at = t * (points.length - 1);
      const i = Math.min(Math.floor(at), points.length - 2);
      const [[ax, ay], [bx, by]] = [points[i]!, points[i + 1]!];
      return [HALF * (ax + (bx - ax) * (at - i)), HALF * (ay + (by - ay) * (at - i))];
    },
    { plane: PLANE, closed },
    30 * points.length,
  );

function outlineAfter(strokes: readonly Stroke[]): Outline {
  const redraws = strokes.map((stroke) => ({ stroke, half: HALF }));
  const section: Section = { u: 0.5, front: null, back: null, redraws };
  const curves = SIDES.map((side) => curveOfStroke(side, DEFAULT_BRUSH)!);
  const form = { strokes: SIDES, sections: [section], back: 'front', between: 'cubic' } as const;
  return outlinesOf('crossSection', form, DEFAULT_BRUSH, curves)[0]!.outline;
}

function inHalfChords(stroke: Stroke): Curve {
  const curve = curveOfStroke(stroke, DEFAULT_BRUSH)!;
  const point = (t: number): Vec2 => [curve.point(t)[0] / HALF, curve.point(t)[1] / HALF];
  return { ...curve, length: curve.length / HALF, point };
}

/** chords: a long line over a small part of an outline has few of them */
const FINE = 4096;

/** Every line that is drawn over what the ones before it left. */
function expectEnclosed(strokes: readonly Stroke[], places: readonly Vec2[]): void {
  strokes.forEach((stroke, i) => {
    const before = outlineAfter(strokes.slice(0, i));
    const line = redrawn(before, inHalfChords(stroke));
    expectOdd(outlineAfter(strokes.slice(0, i + 1)), polygonOf(line, FINE), places, FINE);
  });
}

/** Along the circle from one angle to the other, radians. */
const arc = (from: number, to: number): Vec2[] =>
  Array.from({ length: 9 }, (_, i) => {
    const angle = from + ((to - from) * i) / 8;
    return [Math.cos(angle), Math.sin(angle)];
  });

const dent = drawn([...arc(2.9, 1.7), [-0.1, -1.15], [0.1, -1.15], ...arc(1.4, 0.2)]);

describe.each<[string, readonly Stroke[]]>([
  ['a dent through the back', [dent]],
  [
    'a loop outside',
    [
      drawn([
        [-0.8, 0.6],
        [0.5, 1.1],
        [0.5, 2],
        [-0.4, 2],
        [-0.4, 1],
        [0.8, 0.6],
      ]),
    ],
  ],
  [
    'an eight all round',
    [
      drawn(
        [
          [-1, 0.5],
          [1, -0.5],
          [1, 0.6],
          [-1, -0.7],
          [-1, 0.5],
        ],
        true,
      ),
    ],
  ],
  [
    'a dent through the back, and one through what it left',
    [dent, drawn([...arc(1.3, 0.9), [0.55, -1.05], [0.65, -1.05], ...arc(0.8, 0.1)])],
  ],
])('%s', (_, strokes) => {
  test('is crossed', () => {
    const lines = strokes.map((stroke, i) =>
      redrawn(outlineAfter(strokes.slice(0, i)), inHalfChords(stroke)),
    );
    for (const line of lines) expect(selfCrossings(line)).not.toEqual([]);
  });

  test('goes round what the line went round an odd number of times', () => {
    expectEnclosed(strokes, grid);
  });
});

test('what does not cross keeps all else where it is, v included', () => {
  const stroke = drawn([
    [-0.7, 0.7],
    [0, 0.2],
    [0.7, 0.7],
  ]);
  const line = redrawn(round, inHalfChords(stroke));
  const found = outlineAfter([stroke]);
  for (let i = 0; i < 256; i++)
    expect(distance2(found.point(i / 256), line.point(i / 256))).toBeLessThan(1e-9);
});

// doubles by lot are nearly all next to nothing
const x = fc.integer({ min: -18_000, max: 18_000 }).map((i) => i / 1e4);
const place = fc.tuple(x, x);

test('random lines over a circle, one or two (seed 92)', () => {
  const line = fc.array(place, { minLength: 3, maxLength: 6 }).map((points) => drawn(points));
  fc.assert(
    fc.property(
      fc.array(line, { minLength: 1, maxLength: 2 }),
      fc.array(place, { minLength: 40, maxLength: 40 }),
      (strokes, places) => {
        expectEnclosed(strokes, places);
      },
    ),
    { seed: 92, numRuns: Number(process.env.RUNS ?? 40) },
  );
});

/** How often a closed mesh goes round p: the solid angle of its triangles (van Oosterom and Strackee 1983). */
function windingAbout(mesh: Mesh, p: Vec3): number {
  let sum = 0;
  eachTriangle(mesh, (i, j, k) => {
    const [a, b, c] = [sub3(i, p), sub3(j, p), sub3(k, p)];
    const [x, y, z] = [length3(a), length3(b), length3(c)];
    const beside = x * y * z + dot3(a, b) * z + dot3(a, c) * y + dot3(b, c) * x;
    sum += 2 * Math.atan2(dot3(a, cross3(b, c)), beside);
  });
  return sum / (4 * Math.PI);
}

test('a solid whose back crosses its front goes once round what is inside, and not at all round all else', () => {
  const front = drawn([
    [-1, 0],
    [-0.5, 0.8],
    [0.5, -0.5],
    [1, 0],
  ]);
  const back = drawn([
    [-1, 0],
    [-0.4, -0.7],
    [0.5, 0.7],
    [1, 0],
  ]);
  const section: Section = {
    ...ROUND,
    u: 0.5,
    front: { stroke: front, half: HALF },
    back: { stroke: back, half: HALF },
  };
  const form = { ...PLAIN, strokes: SIDES, sections: [section], back: 'drawn' } as const;
  const mesh = buildForm('crossSection', form, { ...DEFAULT_BRUSH, caps: true }, { u: 8, v: 128 })!;
  const around = [...lineOf(front), ...lineOf(back).reverse()];
  let inside = 0;
  for (const [x, z] of grid) {
    if (Math.min(...around.map((q) => distance2(q, [x, z]))) < 0.08) continue;
    const expected = Math.abs(windingOf(around, [x, z])) % 2;
    // the sides run down the plane: q_l, to their left, is at x = 20
    expect(windingAbout(mesh, [-HALF * x, 3, HALF * z])).toBeCloseTo(expected, 6);
    inside += expected;
  }
  expect(inside).toBeGreaterThan(8);
});

/** An open line, from q_l to q_r. */
const lineOf = (stroke: Stroke): Vec2[] =>
  polygonOf(outlineOf(inHalfChords(stroke), { reversed: false, across: false }));
