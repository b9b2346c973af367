/**
 * Marching cubes over the active bricks: by loops around each cube (cubeLoops.ts), whose vertices are on edges of the lattice, each
 * edge with one at most, so that the mesh is closed across bricks. Where smooth fields meet in an edge (hard unions, boxes) the
 * loop gets a point on the crease (crease.ts) in its middle.
 *
 * Chosen over dual contouring, whose surfaces need repairs to be manifold, and over marching tetrahedra, which have more than
 * twice the triangles for the same field.
 */
import { add3, cross3, length3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Mesh } from '../mesh/mesh.ts';
import { FLOPS } from '../skeleton/work.ts';
import type { Brick, Bricks } from './bricks.ts';
import { type BrickValues, CUT } from './brickValues.ts';
import { creaseNear } from './crease.ts';
import { CreaseFans } from './creaseFans.ts';
import { AMBIGUOUS, CubeLoops } from './cubeLoops.ts';
import { CROSSING_FLOPS, cubicCrossing, EdgePoint } from './edgePoint.ts';
import { CORNERS, SIDE } from './hermite.ts';
import { BRICK } from './lattice.ts';
import { eachTriangle } from './loopTriangles.ts';
import type { Tally } from './near.ts';

/** A mesh painted by the field. */
export interface FieldMesh extends Mesh {
  readonly colours: Float32Array;
}

/** of a cell, how far from the middle of its loop a point on a crease may be */
const REACH = 0.9;
const AXES = [1, SIDE, SIDE * SIDE] as const;
const NO_BRANCH = -1;

export class BrickMesh {
  readonly #bricks: Bricks;
  readonly #values: BrickValues;
  readonly #tally: Tally;
  readonly #positions: number[] = [];
  readonly #normals: number[] = [];
  readonly #colours: number[] = [];
  readonly #indices: number[] = [];
  /** of each vertex, in bricks that have more than one */
  readonly #branches: number[] = [];
  /** vertices where the field has no slope */
  readonly #flat: number[] = [];
  /** by edge of the lattice */
  readonly #vertices = new Map<number, number>();
  readonly #paint = new Float64Array(3);
  readonly #loops = new CubeLoops();
  readonly #eight = new Float64Array(8);
  readonly #inside = new Uint8Array(CORNERS);
  readonly #point = new EdgePoint();
  readonly #fans: CreaseFans;
  /** places of points on creases */
  readonly #creases = new Set<string>();
  #brick: Brick;
  #own: Float64Array = new Float64Array(CORNERS);

  constructor(bricks: Bricks, values: BrickValues, tally: Tally) {
    this.#bricks = bricks;
    this.#values = values;
    this.#tally = tally;
    this.#brick = bricks.active[0]!;
    this.#fans = new CreaseFans(this.#branches, (a, b, c) => this.#indices.push(a, b, c));
  }

  /** The cells of one brick, with the values at its corners; bricks come in order. */
  add(brick: Brick, values: Float64Array): void {
    this.#brick = brick;
    this.#own = values;
    const inside = this.#inside;
    let count = 0;
    for (let c = 0; c < CORNERS; c++) {
      inside[c] = values[c]! > 0 ? 1 : 0;
      count += inside[c]!;
    }
    if (count === 0 || count === CORNERS) return;
    for (let k = 0; k < BRICK; k++) {
      for (let j = 0; j < BRICK; j++) {
        for (let i = 0; i < BRICK; i++) this.#cube(i + SIDE * (j + SIDE * k));
      }
    }
  }

  mesh(): FieldMesh {
    this.#fans.finish();
    const mesh = {
      positions: Float32Array.from(this.#positions),
      normals: Float32Array.from(this.#normals),
      uvs: new Float32Array((2 * this.#positions.length) / 3),
      indices: Uint32Array.from(this.#indices),
      colours: Float32Array.from(this.#colours),
    };
    if (this.#flat.length > 0) fillNormals(mesh, new Set(this.#flat));
    return mesh;
  }

  /** The cube whose first corner is `c`. */
  #cube(c: number): void {
    const inside = this.#inside;
    const above = c + SIDE * SIDE;
    const mask =
      inside[c]! |
      (inside[c + 1]! << 1) |
      (inside[c + SIDE]! << 2) |
      (inside[c + SIDE + 1]! << 3) |
      (inside[above]! << 4) |
      (inside[above + 1]! << 5) |
      (inside[above + SIDE]! << 6) |
      (inside[above + SIDE + 1]! << 7);
    if (mask === 0 || mask === 255) return;
    for (let corner = 0; corner < 8; corner++) {
      const at = c + CUBE[corner]!;
      this.#eight[corner] = AMBIGUOUS[mask] === 1 ? this.#decider(at) : this.#own[at]!;
    }
    const loops = this.#loops;
    loops.trace(mask, this.#eight);
    let start = 0;
    for (let loop = 0; loop < loops.count; loop++) {
      const end = loops.ends[loop]!;
      const ring = Array.from(loops.edges.subarray(start, end), (edge) => this.#vertex(c, edge));
      this.#fill(ring, loops.isTwisted[loop] === 1, c);
      start = end;
    }
  }

  /** What decides how a face hangs together is not interpolated. */
  #decider(c: number): number {
    const value = this.#own[c]!;
    const exact = value === CUT ? value : this.#values.exact(this.#brick, c);
    return exact > 0 === value > 0 ? exact : value;
  }

  /** A piece of surface in a loop. */
  #fill(ring: readonly number[], isTwisted: boolean, c: number): void {
    const fan = this.#brick.near.branches > 1 ? this.#creased(ring) : null;
    if (fan) {
      this.#fans.add(ring, fan);
      return;
    }
    const middle = isTwisted ? this.#middle(ring, c) : null;
    eachTriangle(ring, middle, this.#positions, (a, b, c) => this.#indices.push(a, b, c));
  }

  /** The copies of a point on the crease that runs through the loop, if one does. */
  #creased(ring: readonly number[]) {
    const branches = [...new Set(ring.map((vertex) => this.#branches[vertex]!))];
    if (branches.length < 2 || branches.includes(NO_BRANCH)) return null;
    const { step } = this.#bricks.lattice;
    const crease = creaseNear(this.#brick.near, branches, this.#mean(this.#positions, ring), REACH * step);
    if (!crease || this.#isTaken(crease.at)) return null;
    const copies = branches.map((branch, i) => {
      const side = ring.filter((vertex) => this.#branches[vertex] === branch);
      const copy = this.#add(crease.at, crease.normals[i]!, branch, this.#mean(this.#colours, side));
      return [branch, copy] as const;
    });
    return { copies: new Map(copies) };
  }

  /** Corners are found from cells around, too: two points in one place would be one. */
  #isTaken(at: Vec3): boolean {
    const key = Float32Array.from(at).join(' ');
    const isTaken = this.#creases.has(key);
    this.#creases.add(key);
    return isTaken;
  }

  /** On the edge (corner + 8 axis) of the cube whose first corner is `c`. */
  #vertex(c: number, edge: number): number {
    const from = c + CUBE[edge & 7]!;
    const axis = edge >> 3;
    const { counts } = this.#bricks.lattice;
    const [x, y, z] = this.#lattice(from);
    const key = axis + 3 * (x + counts[0] * (y + counts[1] * z));
    const known = this.#vertices.get(key);
    if (known !== undefined) return known;
    const made = this.#place(from, axis);
    this.#vertices.set(key, made);
    return made;
  }

  /** A new vertex between the corner `from` and the next along `axis`. */
  #place(from: number, axis: number): number {
    const to = from + AXES[axis]!;
    const [valueA, valueB] = [this.#own[from]!, this.#own[to]!];
    const [a, b] = [this.#at(from), this.#at(to)];
    if (valueA === CUT || valueB === CUT) return this.#cutOff(from, axis, a, b);
    const { near } = this.#brick;
    const point = this.#point;
    const { step } = this.#bricks.lattice;
    const isSmooth = near.branches === 1 && point.newton(near, a, axis, step, this.#crossing(from, axis));
    if (!isSmooth) point.search(near, a, b, valueA, valueB);
    const { x, y, z } = point;
    const colour = this.#colourAt([x, y, z]);
    const branch = near.branches > 1 ? near.branch(x, y, z) : NO_BRANCH;
    return this.#add([x, y, z], [point.nx, point.ny, point.nz], branch, colour);
  }

  /** Along the four corners of the brick around an edge. */
  #crossing(from: number, axis: number): number {
    this.#tally.work += CROSSING_FLOPS / FLOPS;
    const stride = AXES[axis]!;
    const along = Math.floor(from / stride) % SIDE;
    const first = along < 2 ? 0 : 1;
    const start = from + (first - along) * stride;
    const own = this.#own;
    const [v0, v1, v2, v3] = [
      own[start]!,
      own[start + stride]!,
      own[start + 2 * stride]!,
      own[start + 3 * stride]!,
    ];
    return cubicCrossing(v0, v1, v2, v3, along - first);
  }

  /** What leaves the lattice ends half a cell within it. */
  #cutOff(from: number, axis: number, a: Vec3, b: Vec3): number {
    const { counts } = this.#bricks.lattice;
    const low = this.#lattice(from);
    const side = (along: 0 | 1 | 2) => {
      const high = low[along] + (along === axis ? 1 : 0);
      return low[along] === 0 ? -1 : high === counts[along] - 1 ? 1 : 0;
    };
    const out: Vec3 = [side(0), side(1), side(2)];
    const at = scale3(add3(a, b), 0.5);
    return this.#add(at, scale3(out, 1 / length3(out)), NO_BRANCH, this.#colourAt(at));
  }

  #colourAt(at: Vec3): Vec3 {
    const { near } = this.#brick;
    if (near.plain) return near.plain;
    const paint = this.#paint;
    near.colour(...at, paint);
    return [paint[0]!, paint[1]!, paint[2]!];
  }

  /** A vertex in the middle of others: on the surface near their mean, or else towards a corner that is on its other side. */
  #middle(ring: readonly number[], c: number): number {
    const mean = this.#mean(this.#positions, ring);
    const point = this.#point;
    const { near } = this.#brick;
    if (!point.polish(near, mean, this.#bricks.lattice.step)) {
      const value = near.value(...mean);
      const corners = CUBE.map((offset) => c + offset).filter((at) => this.#own[at]! > 0 !== value > 0);
      const other = corners.reduce((a, b) => (Math.abs(this.#own[b]!) > Math.abs(this.#own[a]!) ? b : a));
      point.search(near, mean, this.#at(other), value, this.#own[other]!);
    }
    const { x, y, z, nx, ny, nz } = point;
    return this.#add([x, y, z], [nx, ny, nz], NO_BRANCH, this.#mean(this.#colours, ring));
  }

  #mean(of: readonly number[], ring: readonly number[]): Vec3 {
    const along = (axis: number) =>
      ring.reduce((sum, vertex) => sum + of[3 * vertex + axis]!, 0) / ring.length;
    return [along(0), along(1), along(2)];
  }

  #add(at: Vec3, normal: Vec3, branch: number, colour: Vec3): number {
    const made = this.#positions.length / 3;
    this.#positions.push(at[0], at[1], at[2]);
    this.#normals.push(normal[0], normal[1], normal[2]);
    this.#colours.push(colour[0], colour[1], colour[2]);
    this.#branches.push(branch);
    if (normal[0] === 0 && normal[1] === 0 && normal[2] === 0) this.#flat.push(made);
    return made;
  }

  /** The node of the lattice at a corner of the brick. */
  #lattice(c: number): Vec3 {
    const { i, j, k } = this.#brick;
    return [
      BRICK * i + (c % SIDE),
      BRICK * j + (Math.floor(c / SIDE) % SIDE),
      BRICK * k + Math.floor(c / (SIDE * SIDE)),
    ];
  }

  #at(c: number): Vec3 {
    const { origin, step } = this.#bricks.lattice;
    const [x, y, z] = this.#lattice(c);
    return [origin[0] + x * step, origin[1] + y * step, origin[2] + z * step];
  }
}

/** From the first corner of a cube to the others. */
const CUBE = Array.from(
  { length: 8 },
  (_, corner) => (corner & 1) + SIDE * ((corner >> 1) & 1) + SIDE * SIDE * (corner >> 2),
);

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
