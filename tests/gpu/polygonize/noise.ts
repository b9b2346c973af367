/** A field that is noise at the nodes of the lattice of whole millimetres and linear between them, alike in WGSL and TypeScript: every case of a cube. */
import { OUTSIDE } from '../../../src/field/bricks.ts';
import type { Lattice } from '../../../src/field/lattice.ts';
import type { Near } from '../../../src/field/near.ts';
import type { TreeField } from '../../../src/field/treeField.ts';
import type { Modules } from '../../../src/gpu/link.ts';
import type { ListedBricks } from '../../../src/gpu/polygonize/lists.ts';

/** In place of the field of the tree. */
export const noiseModules = (seed: number): Modules => ({
  'field/tree': `#import field/records
fn noise_at(n: vec3u) -> f32 {
  var h = (n.x * 0x9E3779B1u) ^ (n.y * 0x85EBCA77u) ^ (n.z * 0xC2B2AE3Du) ^ ${seed}u;
  h = (h ^ (h >> 15u)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12u)) * 0x297A2D39u;
  h = h ^ (h >> 15u);
  return f32(h >> 8u) / 8388608.0 - 1.0;
}
fn run_program(p: vec3f, colours: bool) -> vec4f {
  // every field has records
  _ = records[0];
  let first = vec3u(floor(p));
  let t = p - floor(p);
  var sum = vec4f(0.0);
  for (var corner = 0u; corner < 8u; corner++) {
    let step = (vec3u(corner) >> vec3u(0u, 1u, 2u)) & vec3u(1u);
    let share = select(1.0 - t, t, step == vec3u(1u));
    let slope = select(vec3f(-1.0), vec3f(1.0), step == vec3u(1u));
    let all = share.x * share.y * share.z;
    sum += noise_at(first + step) * vec4f(all, slope * vec3f(share.y * share.z, share.x * share.z, share.x * share.y));
  }
  return select(sum, vec4f(sum.x, vec3f(0.5)), colours);
}
`,
});

/** The same. */
export function noiseAt(i: number, j: number, k: number, seed: number): number {
  let h = Math.imul(i, 0x9e3779b1) ^ Math.imul(j, 0x85ebca77) ^ Math.imul(k, 0xc2b2ae3d) ^ seed;
  h = Math.imul(h ^ (h >>> 15), 0x2c1b3c6d);
  h = Math.imul(h ^ (h >>> 12), 0x297a2d39);
  h ^= h >>> 15;
  return (h >>> 8) / 8388608 - 1;
}

export function noiseField(seed: number): TreeField {
  const corners = (x: number, y: number, z: number, out: Float64Array) => {
    const first = [Math.floor(x), Math.floor(y), Math.floor(z)] as const;
    const t = [x - first[0], y - first[1], z - first[2]] as const;
    out.fill(0);
    for (let corner = 0; corner < 8; corner++) {
      const step = [corner & 1, (corner >> 1) & 1, corner >> 2] as const;
      const [a, b, c] = step.map((s, axis) => (s ? t[axis]! : 1 - t[axis]!)) as [number, number, number];
      const noise = noiseAt(first[0] + step[0], first[1] + step[1], first[2] + step[2], seed);
      const sign = step.map((s) => (s ? noise : -noise));
      [noise * a * b * c, sign[0]! * b * c, sign[1]! * a * c, sign[2]! * a * b].forEach((part, i) => {
        out[i]! += part;
      });
    }
  };
  const out = new Float64Array(4);
  const value = (x: number, y: number, z: number) => {
    corners(x, y, z, out);
    return out[0]!;
  };
  return {
    value,
    evaluate: corners,
    colour: (x, y, z, paint) => {
      paint.fill(0.5);
      return value(x, y, z);
    },
    range: () => {},
    near: () => ({}) as Near,
    box: null,
    boxAbove: () => null,
  };
}

/** Bricks of which all are active, but those that `isActive` refuses; in a tree of one leaf, asked as a whole. */
export function allBricks(
  along: readonly [number, number, number],
  isActive: (i: number, j: number, k: number) => boolean = () => true,
): ListedBricks {
  const [bx, by, bz] = along;
  const lattice: Lattice = {
    origin: [0, 0, 0],
    step: 1,
    counts: [4 * bx + 1, 4 * by + 1, 4 * bz + 1],
  };
  const near: ListedBricks['active'][number]['near'] = {
    error: 0,
    branches: 1,
    eachLeaf: (visit) => visit(ALL),
  };
  const grid = new Int32Array(bx * by * bz).fill(OUTSIDE);
  const active: ListedBricks['active'][number][] = [];
  for (let number = 0; number < grid.length; number++) {
    const [i, j, k] = [number % bx, Math.floor(number / bx) % by, Math.floor(number / (bx * by))];
    if (!isActive(i, j, k)) continue;
    grid[number] = active.length;
    active.push({ i, j, k, near });
  }
  return { lattice, active, grid };
}

const ALL = { leaf: 0, dropped: null, terms: null, far: null };
