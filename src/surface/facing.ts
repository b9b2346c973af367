/**
 * Which way a part of a sheet faces as it stands: the volume that its rows enclose, or of open sheets the area that the
 * person who drew sees. Strokes that cross, outlines drawn the other way round and strokes of any order are thus alike.
 */
import type { Row } from '../mesh/grid.ts';

/** less than this part of a cube (or square) that holds it: all points lie in one plane, or on one line */
const NOTHING = 1e-13;

/**
 * 1: the quads of `rows` face outward (open: the person) as they are; −1: when flipped; 0: there is nothing to enclose.
 * Open ends of closed outlines count as if they were shut.
 */
export function facing(rows: readonly Row[], closed: boolean): -1 | 0 | 1 {
  const first = rows[0];
  if (!first) return 0;
  const [ox, oy, oz] = first.points as unknown as [number, number, number];
  const last = rows[rows.length - 1]!;
  let sum = 0;
  for (let i = 1; i < rows.length; i++) sum += between(rows[i - 1]!.points, rows[i]!.points);
  if (closed) sum += lid(last.points);
  const size = extent(rows, ox, oy, oz);
  const nothing = NOTHING * size * size * (closed ? size : 1);
  return Math.abs(sum) > nothing ? (sum > 0 ? 1 : -1) : 0;

  function between(a: Float64Array, c: Float64Array): number {
    let part = 0;
    for (let k = 0; k + 5 < a.length; k += 3)
      part += facet(a, k, c, k, a, k + 3) + facet(a, k + 3, c, k, c, k + 3);
    return part;
  }

  /** The end shut by a fan about its own first point; the start's would be about the reference, and is nothing. */
  function lid(p: Float64Array): number {
    let part = 0;
    for (let k = 0; k + 5 < p.length; k += 3) part += facet(p, k, p, 0, p, k + 3);
    return part;
  }

  function facet(p: Float64Array, i: number, q: Float64Array, j: number, r: Float64Array, k: number): number {
    const ax = p[i]! - ox;
    const ay = p[i + 1]! - oy;
    const bx = q[j]! - ox;
    const by = q[j + 1]! - oy;
    const cx = r[k]! - ox;
    const cy = r[k + 1]! - oy;
    if (!closed) return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    const az = p[i + 2]! - oz;
    const bz = q[j + 2]! - oz;
    const cz = r[k + 2]! - oz;
    return ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
}

/** The largest distance of a coordinate from the reference, mm. */
function extent(rows: readonly Row[], ox: number, oy: number, oz: number): number {
  let size = 0;
  for (const { points } of rows) {
    for (let k = 0; k < points.length; k += 3) {
      size = Math.max(
        size,
        Math.abs(points[k]! - ox),
        Math.abs(points[k + 1]! - oy),
        Math.abs(points[k + 2]! - oz),
      );
    }
  }
  return size;
}
