import { describe, expect, test } from 'vitest';
import { alike } from '../../src/surface/alike.ts';
import type { Outline } from '../../src/surface/outline.ts';
import { arch, bumpy, DIAMOND, lines, oval, ridge, STRAIGHT } from './sections.ts';

/** Points of one outline over all pieces. */
function walk(outlines: readonly Outline[], k: number, steps = 20): (readonly [number, number])[] {
  return alike(outlines).pieces.flatMap(({ from, to, along }) =>
    Array.from({ length: steps + 1 }, (_, i) => along[k]!.point(from + ((to - from) * i) / steps)),
  );
}

test('outlines that go together already stay as they are', () => {
  const made = alike([arch(1), STRAIGHT, arch(-0.3)]);
  expect(made).toMatchObject({ closed: false, seamless: false });
  expect(made.pieces.map(({ from, to }) => [from, to])).toEqual([[0, 1]]);
  for (const v of [0, 0.2, 0.5, 1]) {
    expect(made.pieces[0]!.along[0]!.point(v)).toEqual(arch(1).point(v));
    expect(made.pieces[0]!.along[0]!.derivative(v)).toEqual(arch(1).derivative(v, 1));
  }
});

test('smooth closed ones have no seam', () => {
  expect(alike([oval(1), bumpy(5, 0.1)])).toMatchObject({ closed: true, seamless: true });
});

test('ridges at other places meet at their mean', () => {
  const outlines = [ridge(0.3, -0.5, 1), ridge(0.5, 0, 1), ridge(0.7, 0.5, 1)];
  const { pieces } = alike(outlines);
  expect(pieces).toHaveLength(2);
  expect(pieces[0]!.to).toBeCloseTo(0.5, 14);
  outlines.forEach((outline, k) => {
    const crease = outline.point(outline.corners[0]!);
    expect(pieces[0]!.along[k]!.point(pieces[0]!.to)).toEqual(crease);
    expect(pieces[1]!.along[k]!.point(pieces[1]!.from)).toEqual(crease);
    // each side has the direction of its own line
    const [dx, dy] = pieces[0]!.along[k]!.derivative(pieces[0]!.to);
    expect(dy / dx).toBeCloseTo(1 / (crease[0] + 1), 12);
  });
});

test('an outline without corners is smooth across the crease of another', () => {
  const { pieces } = alike([ridge(0.4, 0, 1), arch(1)]);
  expect(pieces.map(({ from, to }) => [from, to])).toEqual([
    [0, 0.4],
    [0.4, 1],
  ]);
  const [before, after] = [pieces[0]!.along[1]!, pieces[1]!.along[1]!];
  expect(before.point(0.4)).toEqual(after.point(0.4));
  expect(before.derivative(0.4)).toEqual(after.derivative(0.4));
});

test('other numbers of corners: each is a crease at its own v', () => {
  const two = lines(
    [
      [0, -1, 0],
      [0.3, -0.5, 1],
      [0.6, 0.5, 1],
      [1, 1, 0],
    ],
    false,
  );
  expect(alike([two, ridge(0.45, 0, 1)]).pieces.map(({ to }) => to)).toEqual([0.3, 0.45, 0.6, 1]);
});

describe('closed outlines', () => {
  const late = lines(
    [
      [0, -1, 0],
      [0.3, 0, 1],
      [0.5, 1, 0],
      [0.8, 0, -1],
      [1, -1, 0],
    ],
    true,
  );

  test('keep q_l and q_r where they are, and match front and back alone', () => {
    const { pieces } = alike([DIAMOND, late]);
    const froms = pieces.map(({ from }) => from);
    for (const [i, v] of [0, 0.275, 0.5, 0.775].entries()) expect(froms[i]).toBeCloseTo(v, 14);
    for (const k of [0, 1]) {
      expect(pieces.map(({ from, along }) => along[k]!.point(from))).toEqual([
        [-1, 0],
        [0, 1],
        [1, 0],
        [0, -1],
      ]);
    }
  });

  test('whose only crease is not at q_l go round to it again', () => {
    const drop: Outline = { ...oval(1), corners: [0.2] };
    const other: Outline = { ...oval(0.5), corners: [0.3] };
    const { pieces, seamless } = alike([drop, other]);
    expect(seamless).toBe(false);
    expect(pieces).toHaveLength(1);
    const { from, to, along } = pieces[0]!;
    expect([from, to]).toEqual([0.25, 1.25]);
    for (const [k, outline] of [drop, other].entries()) {
      expect(along[k]!.point(from)).toEqual(outline.point(outline.corners[0]!));
      expect(along[k]!.point(to)).toEqual(outline.point(outline.corners[0]!));
      expect(along[k]!.point(1)).toEqual(outline.point(0));
      expect(along[k]!.point(0.5)).toEqual(outline.point(0.5));
    }
  });

  test('derivatives are those of the points', () => {
    for (const { from, to, along } of alike([DIAMOND, late, oval(1)]).pieces) {
      for (const { point, derivative } of along) {
        for (const t of [0.1, 0.5, 0.8]) {
          const v = from + t * (to - from);
          const [before, after] = [point(v - 1e-6), point(v + 1e-6)];
          for (const i of [0, 1] as const) {
            expect(derivative(v)[i]).toBeCloseTo((after[i] - before[i]) / 2e-6, 5);
          }
        }
      }
    }
  });

  test('nothing is lost: the outline is walked as it is', () => {
    for (const k of [0, 1]) {
      for (const [x, y] of walk([DIAMOND, late], k)) {
        expect(Math.abs(x) + Math.abs(y)).toBeCloseTo(1, 12);
      }
    }
  });
});

test('open and closed do not mix', () => {
  expect(() => alike([arch(1), oval(1)])).toThrow(RangeError);
});
