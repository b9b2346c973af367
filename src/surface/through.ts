/**
 * Control points of the cubic spline that passes through given points at its knots: the limit masks of bspline.ts solved for the
 * control points, a tridiagonal system (clamped, with given derivatives at both ends) or a cyclic one (periodic).
 *
 * Departure: the thesis (5.5.1) takes sections as control points, so that its patches miss the strokes; fourth-order
 * accurate ends need true derivatives, for a natural end would flatten every rim.
 */
import { solveBanded, solveCyclicBanded } from '../math/banded.ts';
import type { Net } from './net.ts';

/** Points as one vector each: of a net, whole rows or whole columns at once. */
export type Points = readonly Float64Array[];

/** d point / dt at t = 0 and at t = spans, spans one unit long. */
export interface EndSlopes {
  readonly first: Float64Array;
  readonly last: Float64Array;
}

/** spans + 3 control points through spans + 1 points, at least 2; the ends are kept to the last bit. */
export function clampedThrough(points: Points, { first, last }: EndSlopes): Float64Array[] {
  const spans = points.length - 1;
  if (spans < 1)
    throw new RangeError(`a clamped spline passes through 2 points at least, got ${points.length}`);
  const [head, tail] = [points[0]!, points[spans]!];
  const second = head.map((x, i) => x + first[i]! / 3);
  const beforeLast = tail.map((x, i) => x - last[i]! / 3);
  const known = new Map([
    [1, second],
    [spans + 1, beforeLast],
  ]);
  return [head, second, ...innerControls(points, known), beforeLast, tail];
}

/** As many control points as points, at least 3. */
export function periodicThrough(points: Points): Float64Array[] {
  if (points.length < 3)
    throw new RangeError(`a periodic spline passes through 3 points at least, got ${points.length}`);
  return solved(
    points.map(() => [2 / 3, 1 / 6]),
    points,
    solveCyclicBanded,
  );
}

/** Controls 2 … spans: one for every inner knot k, where ¼ or 1/6 of its neighbours k and k + 2 are added. */
function innerControls(points: Points, known: ReadonlyMap<number, Float64Array>): Float64Array[] {
  const spans = points.length - 1;
  const knots = Array.from({ length: spans - 1 }, (_, i) => i + 1);
  const rows = knots.map((k) => {
    const atEnds = Number(k === 1) + Number(k === spans - 1);
    return [[2 / 3, 7 / 12, 1 / 2][atEnds]!, 1 / 6];
  });
  const rests = knots.map((k) => {
    const rest = Float64Array.from(points[k]!);
    for (const neighbour of [known.get(k), known.get(k + 2)])
      neighbour?.forEach((x, i) => {
        rest[i]! -= x / 4;
      });
    return rest;
  });
  return solved(rows, rests, solveBanded);
}

function solved(rows: number[][], rights: Points, solve: typeof solveBanded): Float64Array[] {
  if (rights.length === 0) return [];
  const columns = Array.from({ length: rights[0]!.length }, (_, i) => rights.map((right) => right[i]!));
  const found = solve(rows, columns);
  return rights.map((_, k) => Float64Array.from(found, (column) => column[k]!));
}

export function netOfRows(rows: Points): Net {
  const width = rows[0]?.length ?? 0;
  const points = new Float64Array(rows.length * width);
  for (const [i, row] of rows.entries()) points.set(row, i * width);
  return { rows: rows.length, columns: width / 3, points };
}

export function rowsOfNet({ rows, columns, points }: Net): Float64Array[] {
  return Array.from({ length: rows }, (_, i) => points.slice(3 * columns * i, 3 * columns * (i + 1)));
}

/** Rows become columns. */
export function turned({ rows, columns, points }: Net): Net {
  const out = new Float64Array(points.length);
  for (let i = 0; i < rows; i++) {
    for (let j = 0; j < columns; j++) {
      const from = 3 * (i * columns + j);
      out.set(points.subarray(from, from + 3), 3 * (j * rows + i));
    }
  }
  return { rows: columns, columns: rows, points: out };
}
