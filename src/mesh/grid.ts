/**
 * Grid meshes: rows of points across a form, each joined by quads to the row before it.
 *
 * A crease or an end is not a special case but two rows at the same place: a row that is not `joined` starts
 * again from the points of the row before it with other normals; creases along the form are two columns in one
 * place alike. What is closed around ends with the points of its first column, a grid closed along it with those of
 * its first row. Such copies share their coordinates as doubles, so their float32 copies are the same bits and the
 * mesh is closed by construction.
 *
 * A pole (a row of one point) keeps one vertex a column, half way between the two columns of its triangle, so
 * that a cone's apex is shaded like its flank and textures do not swirl. Triangles that collapse to an edge
 * are left out; that never opens the mesh, since such a triangle uses its edge once in each direction.
 *
 * Texture: v is the column's, u the mean distance along the rows, so that nothing is stretched, caps included.
 */

import type { Plane } from '../math/plane.ts';
import { cross3, length3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Mesh } from './mesh.ts';

/** One row: x y z for each entry of the columns in the plane's coordinates (z = x × y), mm, and unit normals alike. */
export interface Row {
  readonly points: Float64Array;
  readonly normals: Float64Array;
  /** all points are the same */
  readonly pole?: boolean;
  /** quads lead here from the row before; false at a crease, without meaning in the first row */
  readonly joined: boolean;
  /** its quads face the other way: where the form goes round in the other sense */
  readonly flipped?: boolean;
}

/** How the entries of rows hang together. */
export interface Columns {
  /** v of each entry, ascending from 0 to 1; at a crease twice the same */
  readonly vs: readonly number[];
  /** quads lead to this entry from the one before; false at a crease along the surface. Nothing leads to the first. */
  readonly joined: readonly boolean[];
}

/** No triangles: what degenerate input becomes. */
export function emptyMesh(): Mesh {
  return {
    positions: new Float32Array(),
    normals: new Float32Array(),
    uvs: new Float32Array(),
    indices: new Uint32Array(),
  };
}

/** Even columns without creases, closed or not: `count` quads. */
export function evenColumns(count: number): Columns {
  return {
    vs: Array.from({ length: count + 1 }, (_, j) => j / count),
    joined: Array.from({ length: count + 1 }, (_, j) => j > 0),
  };
}

/**
 * The mesh of rows, placed on `plane`: a vertex for each entry. Triangles are counter-clockwise seen from the side to
 * which (along the rows) × (along the columns) points, those that lead to flipped rows from the other.
 */
export function gridMesh(rows: readonly Row[], columns: Columns, plane: Plane): Mesh {
  const { vs, joined } = columns;
  const vertices = rows.length * vs.length;
  const positions = new Float32Array(3 * vertices);
  const normals = new Float32Array(3 * vertices);
  const uvs = new Float32Array(2 * vertices);
  const us = textureRows(rows, columns);
  const poleVs = vs.map((v, j) => (joined[j + 1] ? (v + vs[j + 1]!) / 2 : v));
  const origin: Vec3 = plane.origin;
  const z = cross3(plane.x, plane.y);
  let at = 0;
  rows.forEach((row, i) => {
    const vertexNormals = row.pole ? betweenColumns(row.normals, columns) : row.normals;
    const rowVs = row.pole ? poleVs : vs;
    for (let j = 0; j < vs.length; j++, at++) {
      place(positions, at, row.points, 3 * j, origin, plane, z);
      place(normals, at, vertexNormals, 3 * j, [0, 0, 0], plane, z);
      uvs[2 * at] = us[i]!;
      uvs[2 * at + 1] = rowVs[j]!;
    }
  });
  return { positions, normals, uvs, indices: gridIndices(rows, columns, positions) };
}

/** A point or direction of the plane's coordinates, in the world's. */
function place(
  out: Float32Array,
  vertex: number,
  source: Float64Array,
  from: number,
  origin: Vec3,
  plane: Plane,
  z: Vec3,
): void {
  const x = source[from]!;
  const y = source[from + 1]!;
  const w = source[from + 2]!;
  for (let k = 0; k < 3; k++) {
    out[3 * vertex + k] = origin[k]! + x * plane.x[k]! + y * plane.y[k]! + w * z[k]!;
  }
}

/** Normals half way between neighbouring columns, where the single triangle of a pole's column is. */
function betweenColumns(normals: Float64Array, { joined }: Columns): Float64Array {
  const out = normals.slice();
  for (let j = 0; j + 1 < joined.length; j++) {
    if (!joined[j + 1]) continue;
    const a = 3 * j;
    const sum = [0, 1, 2].map((k) => normals[a + k]! + normals[a + 3 + k]!);
    const length = length3(sum as unknown as Vec3);
    // opposite neighbours cancel: then the column's own normal is as good as any
    if (length > 1e-6) for (let k = 0; k < 3; k++) out[a + k] = sum[k]! / length;
  }
  return out;
}

/** u of every row, 0–1: the mean distance walked along the columns. */
function textureRows(rows: readonly Row[], columns: Columns): number[] {
  let walked = 0;
  const us = rows.map((row, i) => {
    const before = rows[i - 1];
    if (before && row.joined) walked += meanDistance(before.points, row.points, columns);
    return walked;
  });
  return us.map((u) => (walked > 0 ? u / walked : 0));
}

/** Over the middles of quads: columns in one place count once. */
function meanDistance(a: Float64Array, b: Float64Array, { joined }: Columns): number {
  let sum = 0;
  let quads = 0;
  let before = 0;
  for (let j = 0; j < joined.length; j++) {
    const k = 3 * j;
    const way = length3([a[k]! - b[k]!, a[k + 1]! - b[k + 1]!, a[k + 2]! - b[k + 2]!]);
    if (joined[j]) {
      sum += (before + way) / 2;
      quads++;
    }
    before = way;
  }
  return quads > 0 ? sum / quads : 0;
}

function gridIndices(rows: readonly Row[], { joined }: Columns, positions: Float32Array): Uint32Array {
  const entries = joined.length;
  const indices = new Uint32Array(6 * Math.max(entries - 1, 0) * Math.max(rows.length - 1, 0));
  let count = 0;
  const add = (a: number, b: number, c: number): void => {
    if (same(positions, a, b) || same(positions, b, c) || same(positions, c, a)) return;
    indices[count++] = a;
    indices[count++] = b;
    indices[count++] = c;
  };
  for (let i = 1; i < rows.length; i++) {
    const { joined: leads, flipped } = rows[i]!;
    if (!leads) continue;
    for (let j = 0; j + 1 < entries; j++) {
      if (!joined[j + 1]) continue;
      const a = (i - 1) * entries + j;
      // a pole's triangle takes the vertex of its own column
      const b = rows[i - 1]!.pole ? a : a + 1;
      const c = a + entries;
      if (flipped) {
        add(a, b, c);
        add(b, c + 1, c);
      } else {
        add(a, c, b);
        add(b, c, c + 1);
      }
    }
  }
  return indices.slice(0, count);
}

function same(positions: Float32Array, a: number, b: number): boolean {
  const p = 3 * a;
  const q = 3 * b;
  return (
    positions[p] === positions[q] &&
    positions[p + 1] === positions[q + 1] &&
    positions[p + 2] === positions[q + 2]
  );
}
