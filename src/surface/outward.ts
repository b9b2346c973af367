/** Which way rows face: by the volume they enclose, or, of open sheets, whether they look out of the drawing plane. */

import { add3, cross3, dot3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Row } from '../mesh/grid.ts';

/** Six times the signed volume of rows round a form, their ends closed by fans; positive when (along rows) × (along columns) is outward. */
export function sixVolumes(rows: readonly Row[]): number {
  const from = pointAt(rows[0]!, 0);
  const corner = (row: Row, j: number): Vec3 => sub3(pointAt(row, j), from);
  let sum = 0;
  eachQuad(rows, (a, b, c, d) => {
    sum += dot3(sub3(a, from), cross3(sub3(c, from), sub3(b, from)));
    sum += dot3(sub3(b, from), cross3(sub3(c, from), sub3(d, from)));
  });
  for (const [row, sign] of [
    [rows[0]!, 1],
    [rows[rows.length - 1]!, -1],
  ] as const) {
    const count = row.points.length / 3;
    let middle: Vec3 = [0, 0, 0];
    for (let j = 0; j < count; j++) middle = add3(middle, scale3(corner(row, j), 1 / count));
    for (let j = 1; j < count; j++) sum += sign * dot3(corner(row, j - 1), cross3(corner(row, j), middle));
  }
  return sum;
}

/** Twice the signed area of rows seen from in front. */
export function twiceArea(rows: readonly Row[]): number {
  let sum = 0;
  eachQuad(rows, (a, b, c, d) => {
    sum += cross3(sub3(d, a), sub3(b, c))[2];
  });
  return sum;
}

/** a, b: neighbours in a row; c, d: the same columns in the next. */
function eachQuad(rows: readonly Row[], visit: (a: Vec3, b: Vec3, c: Vec3, d: Vec3) => void): void {
  for (let i = 1; i < rows.length; i++) {
    if (!rows[i]!.joined) continue;
    const [before, row] = [rows[i - 1]!, rows[i]!];
    for (let j = 1; 3 * j < row.points.length; j++) {
      visit(pointAt(before, j - 1), pointAt(before, j), pointAt(row, j - 1), pointAt(row, j));
    }
  }
}

function pointAt({ points }: Row, j: number): Vec3 {
  return [points[3 * j]!, points[3 * j + 1]!, points[3 * j + 2]!];
}
