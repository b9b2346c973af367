/**
 * A point on a crease: where two or more smooth fields are 0 at once, the one nearest to where the search begins.
 *
 * Theory: extended marching cubes (Kobbelt et al. 2001) take tangent planes at a cell's vertices; here the tree tells which fields meet
 * (Near.branch), so that Newton's steps of least length, J⁺ F, go onto all of them: creases of curved bodies are as exact as
 * vertices. Departure for near-parallel slopes: J⁺ by (JᵀJ + λ)⁻¹ Jᵀ, which moves little where little is known.
 */
import type { Vec3 } from '../math/vec.ts';
import type { Near } from './near.ts';

const STEPS = 8;
/** of the unit slopes' squares: directions that are known less do not count */
const LEAST = 1e-6;
/** of the step: close enough */
const CLOSE = 1e-4;
/** Below, sides meet so flatly that nothing is seen of the edge: the cosine of 8°. */
const FLAT = 0.99;

/** A point and the outward unit normals there: of each branch, in the order asked. */
export interface Crease {
  readonly at: Vec3;
  readonly normals: readonly Vec3[];
}

const value = new Float64Array(4);

/** Within `reach` of `start` along each axis, mm; null where there is none, or where the sides meet too flatly. */
export function creaseNear(
  near: Near,
  branches: readonly number[],
  start: Vec3,
  reach: number,
): Crease | null {
  const at: [number, number, number] = [start[0], start[1], start[2]];
  for (let i = 0; i < STEPS; i++) {
    const normals: Vec3[] = [];
    const off: number[] = [];
    for (const branch of branches) {
      near.onBranch(branch, ...at, value);
      const slope = Math.sqrt(value[1]! * value[1]! + value[2]! * value[2]! + value[3]! * value[3]!);
      if (!(slope > 0 && slope < Infinity)) return null;
      normals.push([-value[1]! / slope, -value[2]! / slope, -value[3]! / slope]);
      off.push(value[0]! / slope);
    }
    if (i === 0 && isFlat(normals)) return null;
    const move = leastStep(normals, off);
    let most = 0;
    for (let axis = 0; axis < 3; axis++) {
      at[axis] = at[axis]! + move[axis]!;
      most = Math.max(most, Math.abs(move[axis]!));
      if (!(Math.abs(at[axis]! - start[axis]!) <= reach)) return null;
    }
    if (most < CLOSE * reach) return { at, normals };
  }
  return null;
}

function isFlat(normals: readonly Vec3[]): boolean {
  return normals.every((a) => normals.every((b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2] > FLAT));
}

/** The shortest v with n · v = off for all normals, as far as they agree. */
function leastStep(normals: readonly Vec3[], off: readonly number[]): Vec3 {
  let [xx, yy, zz, xy, yz, zx] = [LEAST, LEAST, LEAST, 0, 0, 0];
  let [bx, by, bz] = [0, 0, 0];
  normals.forEach(([x, y, z], i) => {
    xx += x * x;
    yy += y * y;
    zz += z * z;
    xy += x * y;
    yz += y * z;
    zx += z * x;
    bx += x * off[i]!;
    by += y * off[i]!;
    bz += z * off[i]!;
  });
  const [cxx, cxy, czx] = [yy * zz - yz * yz, yz * zx - xy * zz, xy * yz - yy * zx];
  const [cyy, cyz, czz] = [xx * zz - zx * zx, xy * zx - xx * yz, xx * yy - xy * xy];
  const det = xx * cxx + xy * cxy + zx * czx;
  return [
    (cxx * bx + cxy * by + czx * bz) / det,
    (cxy * bx + cyy * by + cyz * bz) / det,
    (czx * bx + cyz * by + czz * bz) / det,
  ];
}
