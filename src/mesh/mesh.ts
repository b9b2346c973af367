import type { Vec3 } from '../math/vec.ts';

/**
 * An indexed triangle mesh. Outward triangles are counter-clockwise. Vertices are split where normals or
 * texture coordinates jump (creases, seams); such copies share their position bit for bit, so topology is
 * judged by position (see `check.ts`).
 */
export interface Mesh {
  /** x y z per vertex, mm */
  readonly positions: Float32Array;
  /** unit x y z per vertex, outward */
  readonly normals: Float32Array;
  /** u v per vertex, 0–1 */
  readonly uvs: Float32Array;
  /** three per triangle */
  readonly indices: Uint32Array;
  /** red green blue per vertex, 0–1, linear; the part's own colour where there are none */
  readonly colours?: Float32Array;
}

/** Corners of the axis-aligned box, mm. */
export interface Box {
  readonly min: Vec3;
  readonly max: Vec3;
}
