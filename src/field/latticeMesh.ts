/**
 * Marching cubes: values on a lattice become an indexed mesh, by loops around each cube (cubeLoops.ts). Every edge of the lattice
 * owns at most one vertex, so the mesh is watertight by construction, and vertices are moved onto the surface of the field itself,
 * whose slopes are the normals. The lattice's own border counts as outside: what reaches it is cut off, half a cell within it.
 *
 * Each layer of cubes is a slice of work. Only the edges of two layers of nodes are remembered at a time.
 */
import { add3, cross3, length3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Mesh } from '../mesh/mesh.ts';
import { CubeLoops } from './cubeLoops.ts';
import type { Lattice, LatticeValues } from './lattice.ts';
import { eachTriangle } from './loopTriangles.ts';
import { surfacePoint } from './surfacePoint.ts';
import type { TreeField } from './treeField.ts';

/** A mesh painted by the field. */
export interface FieldMesh extends Mesh {
  readonly colours: Float32Array;
}

/** Yields what share of the layers is done. */
export function* meshing(
  field: TreeField,
  lattice: Lattice,
  values: LatticeValues,
): Generator<number, FieldMesh> {
  const surface = new Surface(field, lattice, values);
  const layers = lattice.counts[2] - 1;
  for (let k = 0; k < layers; k++) {
    surface.layer(k);
    yield (k + 1) / layers;
  }
  return surface.mesh();
}

class Surface {
  readonly #field: TreeField;
  readonly #lattice: Lattice;
  readonly #values: LatticeValues;
  readonly #inside: Uint8Array;
  /** vertex of the edge from a node of the layer along an axis, at 3 node + axis; −1: none yet */
  #near: Int32Array;
  #far: Int32Array;
  readonly #positions: number[] = [];
  readonly #normals: number[] = [];
  readonly #colours: number[] = [];
  readonly #indices: number[] = [];
  /** vertices where the field has no slope */
  readonly #flat: number[] = [];
  readonly #paint = new Float64Array(3);
  readonly #loops = new CubeLoops();
  readonly #corners = new Float64Array(8);

  constructor(field: TreeField, lattice: Lattice, values: LatticeValues) {
    this.#field = field;
    this.#lattice = lattice;
    this.#values = values;
    this.#inside = insideOf(lattice, values);
    const [nx, ny] = lattice.counts;
    this.#near = new Int32Array(3 * nx * ny).fill(-1);
    this.#far = new Int32Array(3 * nx * ny).fill(-1);
  }

  /** The cubes between the layers k and k + 1 of nodes. */
  layer(k: number): void {
    const [nx, ny] = this.#lattice.counts;
    for (let j = 0; j < ny - 1; j++) {
      for (let i = 0; i < nx - 1; i++) this.#cube(i, j, k);
    }
    [this.#near, this.#far] = [this.#far, this.#near.fill(-1)];
  }

  mesh(): FieldMesh {
    const vertices = this.#positions.length / 3;
    const mesh = {
      positions: Float32Array.from(this.#positions),
      normals: Float32Array.from(this.#normals),
      uvs: new Float32Array(2 * vertices),
      indices: Uint32Array.from(this.#indices),
      colours: Float32Array.from(this.#colours),
    };
    if (this.#flat.length > 0) fillNormals(mesh, new Set(this.#flat));
    return mesh;
  }

  #cube(i: number, j: number, k: number): void {
    const [nx, ny] = this.#lattice.counts;
    const inside = this.#inside;
    const first = i + nx * (j + ny * k);
    const above = first + nx * ny;
    const mask =
      inside[first]! |
      (inside[first + 1]! << 1) |
      (inside[first + nx]! << 2) |
      (inside[first + nx + 1]! << 3) |
      (inside[above]! << 4) |
      (inside[above + 1]! << 5) |
      (inside[above + nx]! << 6) |
      (inside[above + nx + 1]! << 7);
    if (mask === 0 || mask === 255) return;
    for (let corner = 0; corner < 8; corner++) {
      this.#corners[corner] = this.#value([i + (corner & 1), j + ((corner >> 1) & 1), k + (corner >> 2)]);
    }
    this.#loops.trace(mask, this.#corners);
    this.#fill(i, j, k);
  }

  /** A piece of surface in every loop. */
  #fill(i: number, j: number, k: number): void {
    const loops = this.#loops;
    let start = 0;
    for (let loop = 0; loop < loops.count; loop++) {
      const end = loops.ends[loop]!;
      const ring = Array.from(loops.edges.subarray(start, end), (edge) => this.#vertex(i, j, k, edge));
      const middle = loops.isTwisted[loop] ? this.#middle(ring) : null;
      eachTriangle(ring, middle, this.#positions, (a, b, c) => this.#indices.push(a, b, c));
      start = end;
    }
  }

  #vertex(i: number, j: number, k: number, edge: number): number {
    const [corner, axis] = [edge & 7, edge >> 3];
    const [x, y, z] = [i + (corner & 1), j + ((corner >> 1) & 1), k + (corner >> 2)];
    const owners = corner & 4 ? this.#far : this.#near;
    const slot = 3 * (x + this.#lattice.counts[0] * y) + axis;
    const known = owners[slot]!;
    if (known >= 0) return known;
    const made = this.#positions.length / 3;
    owners[slot] = made;
    this.#place([x, y, z], [x + Number(axis === 0), y + Number(axis === 1), z + Number(axis === 2)]);
    return made;
  }

  /** A vertex in the middle of others, with the mean of their normals. */
  #middle(ring: readonly number[]): number {
    const mean = (from: readonly number[], axis: number) =>
      ring.reduce((sum, vertex) => sum + from[3 * vertex + axis]!, 0) / ring.length;
    const made = this.#positions.length / 3;
    const at: Vec3 = [mean(this.#positions, 0), mean(this.#positions, 1), mean(this.#positions, 2)];
    const sum: Vec3 = [mean(this.#normals, 0), mean(this.#normals, 1), mean(this.#normals, 2)];
    const length = length3(sum);
    if (!(length > 0)) this.#flat.push(made);
    this.#add(at, length > 0 ? scale3(sum, 1 / length) : [0, 0, 0]);
    return made;
  }

  /** A new vertex between two nodes. */
  #place(from: Vec3, to: Vec3): void {
    const [a, b] = [this.#at(from), this.#at(to)];
    const [valueA, valueB] = [this.#value(from), this.#value(to)];
    const isCut = valueA > 0 === valueB > 0;
    const { at, normal } = isCut
      ? { at: scale3(add3(a, b), 0.5), normal: this.#outOfBorder(from, to) }
      : surfacePoint(this.#field, a, b, valueA, valueB);
    if (!normal) this.#flat.push(this.#positions.length / 3);
    this.#add(at, normal ?? [0, 0, 0]);
  }

  #add(at: Vec3, normal: Vec3): void {
    this.#positions.push(...at);
    this.#normals.push(...normal);
    this.#field.colour(...at, this.#paint);
    this.#colours.push(this.#paint[0]!, this.#paint[1]!, this.#paint[2]!);
  }

  #at([i, j, k]: Vec3): Vec3 {
    const { origin, step } = this.#lattice;
    return [origin[0] + i * step, origin[1] + j * step, origin[2] + k * step];
  }

  #value([i, j, k]: Vec3): number {
    const [nx, ny] = this.#lattice.counts;
    return this.#values[i + nx * (j + ny * k)]!;
  }

  /** Of what was cut off: the sides of the lattice that one of the nodes lies on. */
  #outOfBorder(from: Vec3, to: Vec3): Vec3 {
    const { counts } = this.#lattice;
    const side = (axis: 0 | 1 | 2) =>
      Math.min(from[axis], to[axis]) === 0 ? -1 : Math.max(from[axis], to[axis]) === counts[axis] - 1 ? 1 : 0;
    const out: Vec3 = [side(0), side(1), side(2)];
    return scale3(out, 1 / length3(out));
  }
}

/** One byte a node; what is no number is outside, and so is the border. */
function insideOf({ counts: [nx, ny, nz] }: Lattice, values: LatticeValues): Uint8Array {
  const inside = new Uint8Array(values.length);
  for (let k = 1; k < nz - 1; k++) {
    for (let j = 1; j < ny - 1; j++) {
      const row = nx * (j + ny * k);
      for (let i = row + 1; i < row + nx - 1; i++) inside[i] = values[i]! > 0 ? 1 : 0;
    }
  }
  return inside;
}

/** The mean of the triangles around, by area, for vertices without a slope. */
function fillNormals({ positions, normals, indices }: Mesh, wanted: ReadonlySet<number>): void {
  const at = (i: number): Vec3 => [positions[3 * i]!, positions[3 * i + 1]!, positions[3 * i + 2]!];
  for (let i = 0; i < indices.length; i += 3) {
    const corners = [indices[i]!, indices[i + 1]!, indices[i + 2]!] as const;
    if (!corners.some((corner) => wanted.has(corner))) continue;
    const [a, b, c] = [at(corners[0]), at(corners[1]), at(corners[2])];
    const across = cross3(sub3(b, a), sub3(c, a));
    for (const corner of corners) {
      if (wanted.has(corner))
        for (let axis = 0; axis < 3; axis++) normals[3 * corner + axis]! += across[axis]!;
    }
  }
  for (const i of wanted) {
    const sum: Vec3 = [normals[3 * i]!, normals[3 * i + 1]!, normals[3 * i + 2]!];
    const length = length3(sum);
    normals.set(length > 0 ? scale3(sum, 1 / length) : [0, 1, 0], 3 * i);
  }
}
