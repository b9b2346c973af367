/**
 * A row of a sheet moved with its section (bendMap.ts): what its points share is worked out once, and the rest are numbers
 * in flat arrays, since a frame of a drag moves thousands of points.
 */
import { cross3, dot3 } from '../math/tuple.ts';
import { gainOf, inverse, type Move } from './bendMap.ts';
import type { SheetRow, Station } from './sheet.ts';
import type { Side2 } from './sideView.ts';

/** `section` null: the row moves stiffly, normals too. */
export function bentRow(row: SheetRow, move: Move, view: Side2, section: Station | null): SheetRow {
  const points = movedPoints(row.points, move, view);
  // a pole stays one point to the last bit
  if (row.pole) for (let k = 3; k < points.length; k++) points[k] = points[k - 3]!;
  const back = carriedBy(move, view);
  const normals =
    section === null ? stiffNormals(row.normals, back) : bentNormals(row, back, move, view, section);
  return { ...row, points, normals };
}

function movedPoints(points: Float64Array, move: Move, { axes: { origin, x, y } }: Side2): Float64Array {
  const [[a, b], [c, d]] = move.turn();
  const [fromX, fromY] = move.from();
  const [toX, toY] = move.to();
  const out = new Float64Array(points.length);
  for (let k = 0; k < points.length; k += 3) {
    const [p, q, r] = [points[k]! - origin[0], points[k + 1]! - origin[1], points[k + 2]! - origin[2]];
    const h = p * x[0] + q * x[1] + r * x[2];
    const v = p * y[0] + q * y[1] + r * y[2];
    const [awayX, awayY] = [h - fromX, v - fromY];
    // what lies along V is not touched
    const dh = a * awayX + b * awayY + toX - h;
    const dv = c * awayX + d * awayY + toY - v;
    for (let i = 0; i < 3; i++) out[k + i] = points[k + i]! + (x[i]! * dh + y[i]! * dv);
  }
  return out;
}

/** Directions of the sheet after the move, A⁻ᵀ in the side view: what becomes of x, y and z. */
function carriedBy(move: Move, { axes: { x, y, z } }: Side2): Float64Array {
  const [[a, c], [b, d]] = inverse(move.turn());
  const out = new Float64Array(9);
  for (let k = 0; k < 3; k++) {
    const right = a * x[k]! + b * y[k]!;
    const up = c * x[k]! + d * y[k]!;
    for (let i = 0; i < 3; i++) out[3 * k + i] = x[i]! * right + y[i]! * up + z[i]! * z[k]!;
  }
  return out;
}

/** The direction (p, q, r) carried, at length 1, into `out` from k on; left alone where it has no length. */
function put(out: Float64Array, k: number, back: Float64Array, p: number, q: number, r: number): boolean {
  const x = back[0]! * p + back[3]! * q + back[6]! * r;
  const y = back[1]! * p + back[4]! * q + back[7]! * r;
  const z = back[2]! * p + back[5]! * q + back[8]! * r;
  const size = Math.sqrt(x * x + y * y + z * z);
  if (!(size > 0 && size < Infinity)) return false;
  out[k] = x / size;
  out[k + 1] = y / size;
  out[k + 2] = z / size;
  return true;
}

function stiffNormals(normals: Float64Array, back: Float64Array): Float64Array {
  const out = Float64Array.from(normals);
  for (let k = 0; k < out.length; k += 3) put(out, k, back, normals[k]!, normals[k + 1]!, normals[k + 2]!);
  return out;
}

/** n′ ∝ sign(s) A⁻ᵀ(n (s + a·m) − m (a·n)) of bendMap.ts; stiff where that is nothing. */
function bentNormals(
  { points, normals }: SheetRow,
  back: Float64Array,
  move: Move,
  { axes: { origin, x, y } }: Side2,
  { centre, rate, normal: m, spin }: Station,
): Float64Array {
  const out = Float64Array.from(normals);
  const pace = dot3(rate, m);
  const sweep = cross3(m, spin);
  const [mx, my] = [dot3(m, x), dot3(m, y)];
  const [[forthA, forthB], [forthC, forthD]] = inverse(move.turn());
  const [[a, b], [c, d]] = move.dTurn();
  const [gainX, gainY] = gainOf(move);
  const [fromX, fromY] = move.from();
  for (let k = 0; k < points.length; k += 3) {
    const [px, py, pz] = [points[k]!, points[k + 1]!, points[k + 2]!];
    const [nx, ny, nz] = [normals[k]!, normals[k + 1]!, normals[k + 2]!];
    const s = pace + sweep[0] * (px - centre[0]) + sweep[1] * (py - centre[1]) + sweep[2] * (pz - centre[2]);
    const [p, q, r] = [px - origin[0], py - origin[1], pz - origin[2]];
    const h = p * x[0] + q * x[1] + r * x[2] - fromX;
    const v = p * y[0] + q * y[1] + r * y[2] - fromY;
    const [strainX, strainY] = [a * h + b * v + gainX, c * h + d * v + gainY];
    const [ax, ay] = [forthA * strainX + forthB * strainY, forthC * strainX + forthD * strainY];
    const own = s + ax * mx + ay * my;
    const other = ax * (nx * x[0] + ny * x[1] + nz * x[2]) + ay * (nx * y[0] + ny * y[1] + nz * y[2]);
    const [e, f, g] = [nx * own - m[0] * other, ny * own - m[1] * other, nz * own - m[2] * other];
    const nothing = 1e-12 * (Math.abs(s) + Math.sqrt(ax * ax + ay * ay));
    const sign = s < 0 ? -1 : 1;
    const isBent =
      Math.sqrt(e * e + f * f + g * g) > nothing && put(out, k, back, sign * e, sign * f, sign * g);
    if (!isBent) put(out, k, back, nx, ny, nz);
  }
  return out;
}
