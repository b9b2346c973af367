/**
 * Unit normals S_u × S_v of a net of points and derivatives. In a point of the surface where a whole row meets (a tip) S_v vanishes;
 * there it is S_v = ± S_uv du, and where that is nothing too, the normal of the row next to it.
 */
import { length3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Limit } from './net.ts';

/** products of derivatives below this part of the row's largest have no direction */
const NOTHING = 1e-7;

/** Rows of x y z. `tips`: whether the first and the last row are one point each. */
export function normalsOf(
  limit: Limit,
  tips: { readonly first: boolean; readonly last: boolean },
): Float64Array[] {
  const { rows } = limit.points;
  const found = Array.from({ length: rows }, (_, i) => {
    const tip = (i === 0 && tips.first) || (i === rows - 1 && tips.last);
    return rowNormals(limit, i, tip ? (i === 0 ? 1 : -1) : 0);
  });
  // from the inside out, so that a tip can borrow from the row before it
  const inwards = (i: number): number => (2 * i < rows ? i + 1 : i - 1);
  const order = found.map((_, i) => i).sort((a, b) => Math.min(b, rows - 1 - b) - Math.min(a, rows - 1 - a));
  for (const i of order) fill(found[i]!, found[inwards(i)]);
  return found;
}

/** Zero where there is none. */
function rowNormals({ du, dv, duv }: Limit, row: number, tip: -1 | 0 | 1): Float64Array {
  const width = 3 * du.columns;
  const cut = ({ points }: { points: Float64Array }): Float64Array =>
    points.subarray(row * width, (row + 1) * width);
  const [along, across] = [cut(du), tip === 0 ? cut(dv) : cut(duv)];
  const least = NOTHING * longest(along) * longest(across);
  const out = new Float64Array(width);
  const sign = tip === 0 ? 1 : tip;
  for (let k = 0; k < width; k += 3) {
    const [ax, ay, az] = [along[k]!, along[k + 1]!, along[k + 2]!];
    const [bx, by, bz] = [across[k]!, across[k + 1]!, across[k + 2]!];
    const [x, y, z] = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
    const size = Math.sqrt(x * x + y * y + z * z);
    if (!(size > least)) continue;
    out[k] = (sign * x) / size;
    out[k + 1] = (sign * y) / size;
    out[k + 2] = (sign * z) / size;
  }
  return out;
}

function fill(row: Float64Array, inner: Float64Array | undefined): void {
  for (let k = 0; k < row.length; k += 3) {
    if (row[k] !== 0 || row[k + 1] !== 0 || row[k + 2] !== 0) continue;
    const wished = inner && length3(at(inner, k)) > 0 ? at(inner, k) : ([0, 0, 1] as const);
    row.set(wished, k);
  }
}

function longest(vectors: Float64Array): number {
  let most = 0;
  for (let k = 0; k < vectors.length; k += 3) {
    const [x, y, z] = [vectors[k]!, vectors[k + 1]!, vectors[k + 2]!];
    most = Math.max(most, x * x + y * y + z * z);
  }
  return Math.sqrt(most);
}

function at(vectors: Float64Array, k: number): Vec3 {
  return [vectors[k]!, vectors[k + 1]!, vectors[k + 2]!];
}
