/**
 * Affine maps of space: placements, scalings, shears, mirrors. By rows, x' = m₀x + m₁y + m₂z + m₃ and so on: three rows of
 * four, mm.
 */
import type { Box } from '../skeleton/skeleton.ts';
import { FieldError } from '../skeleton/skeleton.ts';

export type Affine = readonly [
  number,
  number,
  number,
  number,
  number,
  number,
  number,
  number,
  number,
  number,
  number,
  number,
];

export const IDENTITY: Affine = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

/** Flatter than this (largest over smallest stretch) nothing is left to see, and float32 loses it. */
const MOST_SQUASHED = 1e5;

/** First `inner`, then `outer`. */
export function composed(outer: Affine, inner: Affine): Affine {
  const entry = (row: number, column: number) => {
    let sum = column === 3 ? outer[4 * row + 3]! : 0;
    for (let k = 0; k < 3; k++) sum += outer[4 * row + k]! * inner[4 * k + column]!;
    return sum;
  };
  return Array.from({ length: 12 }, (_, i) => entry(i >> 2, i & 3)) as unknown as Affine;
}

/** FieldError when it flattens space, or is no matrix of 12 numbers. */
export function inverted(m: Affine): Affine {
  if (m.length !== 12 || !m.every(Number.isFinite))
    throw new FieldError(`matrix must be 12 numbers, got ${m}`);
  const { least, most } = stretches(m);
  if (!(most > 0 && least * MOST_SQUASHED >= most)) throw new FieldError('matrix flattens space');
  const [a, b, c, x, d, e, f, y, g, h, i, z] = m;
  const minors = [
    e * i - f * h,
    c * h - b * i,
    b * f - c * e,
    f * g - d * i,
    a * i - c * g,
    c * d - a * f,
    d * h - e * g,
    b * g - a * h,
    a * e - b * d,
  ];
  const det = a * minors[0]! + b * minors[3]! + c * minors[6]!;
  const n = minors.map((minor) => minor / det);
  const back = (row: number) => -(n[row]! * x + n[row + 1]! * y + n[row + 2]! * z);
  return [n[0]!, n[1]!, n[2]!, back(0), n[3]!, n[4]!, n[5]!, back(3), n[6]!, n[7]!, n[8]!, back(6)];
}

/** By how much lengths change, least and most: the singular values, by Jacobi's rotations of MᵀM. */
export function stretches(m: Affine): { readonly least: number; readonly most: number } {
  const column = (k: number) => [m[k]!, m[4 + k]!, m[8 + k]!] as const;
  const columns = [column(0), column(1), column(2)].map((v) => [...v] as [number, number, number]);
  // one-sided: columns are turned into each other until they are orthogonal, so that no accuracy is lost in squares
  for (let sweep = 0; sweep < 12; sweep++) {
    for (const [p, q] of [
      [0, 1],
      [0, 2],
      [1, 2],
    ] as const)
      turnApart(columns[p]!, columns[q]!);
  }
  const lengths = columns.map(([x, y, z]) => Math.sqrt(x * x + y * y + z * z));
  return { least: Math.min(...lengths), most: Math.max(...lengths) };
}

function turnApart(u: [number, number, number], v: [number, number, number]): void {
  const uu = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
  const vv = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  const uv = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  if (Math.abs(uv) <= 1e-17 * Math.sqrt(uu * vv)) return;
  const zeta = (vv - uu) / (2 * uv);
  const t = (zeta < 0 ? -1 : 1) / (Math.abs(zeta) + Math.sqrt(1 + zeta * zeta));
  const cosine = 1 / Math.sqrt(1 + t * t);
  for (const i of [0, 1, 2] as const) {
    const [a, b] = [u[i], v[i]];
    u[i] = cosine * (a - t * b);
    v[i] = cosine * (b + t * a);
  }
}

/** The box about a box that is mapped. */
export function mappedBox(m: Affine, { min, max }: Box): Box {
  const row = (r: number, sign: 1 | -1) => {
    let sum = m[4 * r + 3]!;
    for (let k = 0; k < 3; k++) {
      const slope = m[4 * r + k]!;
      sum += slope * (slope * sign > 0 ? max[k]! : min[k]!);
    }
    return sum;
  };
  return { min: [row(0, -1), row(1, -1), row(2, -1)], max: [row(0, 1), row(1, 1), row(2, 1)] };
}
