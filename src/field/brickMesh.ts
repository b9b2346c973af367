/**
 * Marching cubes over the active bricks: by loops around each cube (cubeLoops.ts), whose vertices are on edges of the lattice, each
 * edge with one at most, so that the mesh is closed across bricks. Where smooth fields meet in an edge (hard unions, boxes) the
 * loop gets a point on the crease (loopPoints.ts) in its middle.
 *
 * Chosen over dual contouring, whose surfaces need repairs to be manifold, and over marching tetrahedra, which have more than
 * twice the triangles for the same field.
 */
import { add3, length3, scale3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Mesh } from '../mesh/mesh.ts';
import { FLOPS } from '../skeleton/work.ts';
import type { Brick, Bricks } from './bricks.ts';
import { type BrickValues, CUT } from './brickValues.ts';
import { CreaseFans } from './creaseFans.ts';
import { AMBIGUOUS, CubeLoops } from './cubeLoops.ts';
import { CROSSING_FLOPS, cubicCrossing, EdgePoint } from './edgePoint.ts';
import { CORNERS, SIDE } from './hermite.ts';
import { isolatedSpots } from './isolated.ts';
import { BRICK, nodesBefore } from './lattice.ts';
import { type LoopPoint, LoopPoints } from './loopPoints.ts';
import { eachTriangle } from './loopTriangles.ts';
import { meanNormals } from './meanNormals.ts';
import type { Tally } from './near.ts';
import { type Thin, thinOf } from './thin.ts';
import type { ThinSpot } from './thinWalls.ts';
import { unseenIn } from './unseen.ts';
import { NO_BRANCH, type Vertex, VertexStore } from './vertexStore.ts';

/** A mesh painted by the field. */
export interface FieldMesh extends Mesh {
  readonly colours: Float32Array;
  /** null: nowhere is the body thinner than a cell; left out where nobody looked */
  readonly thin?: Thin | null;
}

const AXES = [1, SIDE, SIDE * SIDE] as const;
/** From the first corner of a cube to the others. */
const CUBE = Array.from(
  { length: 8 },
  (_, corner) => (corner & 1) + SIDE * ((corner >> 1) & 1) + SIDE * SIDE * (corner >> 2),
);

export class BrickMesh {
  readonly #bricks: Bricks;
  readonly #values: BrickValues;
  readonly #tally: Tally;
  #before: BrickMesh | null;
  /** nodes of this lattice before the first of the one before */
  readonly #more: Vec3;
  readonly #store = new VertexStore();
  readonly #indices: number[] = [];
  readonly #paint = new Float64Array(3);
  readonly #loops = new CubeLoops();
  readonly #eight = new Float64Array(8);
  readonly #inside = new Uint8Array(CORNERS);
  readonly #point = new EdgePoint();
  readonly #fans: CreaseFans;
  readonly #points: LoopPoints;
  readonly #unseen: ThinSpot[] = [];
  /** places of bricks without a corner inside */
  readonly #empty: number[] = [];
  #brick: Brick;
  #own: Float64Array = new Float64Array(CORNERS);
  #isKept = false;

  /** `before`: the mesh before an edit, which is taken over where nothing changed. */
  constructor(bricks: Bricks, values: BrickValues, tally: Tally, before: BrickMesh | null = null) {
    this.#bricks = bricks;
    this.#values = values;
    this.#tally = tally;
    this.#before = before;
    this.#more = before ? nodesBefore(before.#bricks.lattice, bricks.lattice) : [0, 0, 0];
    this.#brick = bricks.active[0]!;
    this.#fans = new CreaseFans(this.#store.branches, this.#triangle);
    this.#points = new LoopPoints(this.#store, bricks.lattice.step, before === null ? null : before.#points);
  }

  /** The cells of one brick, with the values at its corners; bricks come in order. `isKept`: its field is that of the mesh before. */
  add(brick: Brick, values: Float64Array, isKept = false): void {
    this.#brick = brick;
    this.#own = values;
    this.#isKept = isKept;
    const inside = this.#inside;
    let count = 0;
    for (let c = 0; c < CORNERS; c++) {
      inside[c] = values[c]! > 0 ? 1 : 0;
      count += inside[c]!;
    }
    if (count === 0) this.#lookBetween();
    if (count === 0 || count === CORNERS) return;
    for (let k = 0; k < BRICK; k++) {
      for (let j = 0; j < BRICK; j++) {
        for (let i = 0; i < BRICK; i++) this.#cube(i + SIDE * (j + SIDE * k));
      }
    }
  }

  /** Of all bricks that were added; what was before is forgotten. */
  mesh(): FieldMesh {
    this.#fans.finish();
    this.#before = null;
    this.#points.forget();
    const { positions, normals, colours, flat } = this.#store;
    const alone = isolatedSpots(this.#values.whole, this.#bricks, this.#empty);
    const mesh = {
      positions: Float32Array.from(positions),
      normals: Float32Array.from(normals),
      uvs: new Float32Array((2 * positions.length) / 3),
      indices: Uint32Array.from(this.#indices),
      colours: Float32Array.from(colours),
      thin: thinOf({ positions, normals }, this.#bricks.lattice, [...this.#unseen, ...alone]),
    };
    if (flat.length > 0) meanNormals(mesh, new Set(flat));
    return mesh;
  }

  readonly #triangle = (a: number, b: number, c: number): void => {
    this.#indices.push(a, b, c);
  };

  #brickNumber(): number {
    const { i, j, k } = this.#brick;
    const [nx, ny] = this.#bricks.counts;
    return i + nx * (j + ny * k);
  }

  #lookBetween(): void {
    const missed = unseenIn(this.#brick, this.#own, this.#bricks.lattice);
    if (missed) this.#unseen.push(missed);
    else this.#empty.push(this.#bricks.grid[this.#brickNumber()]!);
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
      this.#fill(ring, c, loop);
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
  #fill(ring: readonly number[], c: number, loop: number): void {
    const isTwisted = this.#loops.isTwisted[loop] === 1;
    const { near } = this.#brick;
    const isSame = this.#isKept && this.#store.areTaken(ring);
    const key = {
      now: loop + 4 * this.#number(c),
      before: isSame && this.#before ? loop + 4 * this.#numberIn(this.#before, c) : null,
    };
    const fan = near.branches > 1 ? this.#points.creased(near, this.#values.whole, ring, key) : null;
    if (fan) {
      this.#fans.add(ring, fan);
      return;
    }
    const search = () => this.#middle(ring, c);
    const middle = isTwisted ? this.#points.remembered(key, 'middle', search) : null;
    eachTriangle(ring, middle && this.#addMiddle(ring, middle), this.#store.positions, this.#triangle);
  }

  #addMiddle(ring: readonly number[], { at, normals }: LoopPoint): number {
    const store = this.#store;
    return store.add({ at, normal: normals[0]!, colour: store.mean(store.colours, ring), branch: NO_BRANCH });
  }

  /** On the surface near the mean of a loop, or else towards a corner that is on its other side. */
  #middle(ring: readonly number[], c: number): LoopPoint {
    const mean = this.#store.mean(this.#store.positions, ring);
    const point = this.#point;
    const { near } = this.#brick;
    if (!point.polish(near, mean, this.#bricks.lattice.step)) {
      const value = near.value(...mean);
      const corners = CUBE.map((offset) => c + offset).filter((at) => this.#own[at]! > 0 !== value > 0);
      const other = corners.reduce((a, b) => (Math.abs(this.#own[b]!) > Math.abs(this.#own[a]!) ? b : a));
      point.search(near, mean, this.#at(other), value, this.#own[other]!);
    }
    const { x, y, z, nx, ny, nz } = point;
    return { at: [x, y, z], normals: [[nx, ny, nz]] };
  }

  /** On the edge (corner + 8 axis) of the cube whose first corner is `c`. */
  #vertex(c: number, edge: number): number {
    const from = c + CUBE[edge & 7]!;
    const axis = edge >> 3;
    const key = axis + 3 * this.#number(from);
    const known = this.#store.onEdge(key);
    if (known !== undefined) return known;
    const ends = [this.#own[from]!, this.#own[from + AXES[axis]!]!] as const;
    const before = this.#isKept ? this.#before : null;
    const taken =
      before && this.#store.take(before.#store, axis + 3 * this.#numberIn(before, from), key, ends);
    return taken ?? this.#store.addOnEdge(key, ends, this.#placed(from, axis, ends));
  }

  /** Between the corner `from` and the next along `axis`. */
  #placed(from: number, axis: number, [valueA, valueB]: readonly [number, number]): Vertex {
    const [a, b] = [this.#at(from), this.#at(from + AXES[axis]!)];
    if (valueA === CUT || valueB === CUT) return this.#cutOff(from, axis, a, b);
    const { near } = this.#brick;
    const point = this.#point;
    const { step } = this.#bricks.lattice;
    const isSmooth =
      near.branches === 1 &&
      point.newton(near, a, axis, step, this.#crossing(from, axis)) &&
      point.sharpen(this.#values.whole, near.error, a, axis, step);
    if (!isSmooth) point.search(near, a, b, valueA, valueB);
    const { x, y, z, nx, ny, nz } = point;
    return {
      at: [x, y, z],
      normal: [nx, ny, nz],
      colour: this.#colourAt([x, y, z]),
      branch: near.branch(x, y, z),
    };
  }

  /** Where the cubic through four corners of the brick around an edge crosses it. */
  #crossing(from: number, axis: number): number {
    this.#tally.work += CROSSING_FLOPS / FLOPS;
    const stride = AXES[axis]!;
    const along = Math.floor(from / stride) % SIDE;
    const first = along < 2 ? 0 : 1;
    const own = this.#own;
    const at = (i: number) => own[from + (first - along + i) * stride]!;
    return cubicCrossing(at(0), at(1), at(2), at(3), along - first);
  }

  /** What leaves the lattice ends half a cell within it. */
  #cutOff(from: number, axis: number, a: Vec3, b: Vec3): Vertex {
    const { counts } = this.#bricks.lattice;
    const low = this.#node(from);
    const side = (along: 0 | 1 | 2) => {
      const high = low[along] + (along === axis ? 1 : 0);
      return low[along] === 0 ? -1 : high === counts[along] - 1 ? 1 : 0;
    };
    const out: Vec3 = [side(0), side(1), side(2)];
    const at = scale3(add3(a, b), 0.5);
    return { at, normal: scale3(out, 1 / length3(out)), colour: this.#colourAt(at), branch: NO_BRANCH };
  }

  #colourAt(at: Vec3): Vec3 {
    const { near } = this.#brick;
    if (near.plain) return near.plain;
    const paint = this.#paint;
    near.colour(...at, paint);
    return [paint[0]!, paint[1]!, paint[2]!];
  }

  /** The node of the lattice at a corner of the brick. */
  #node(c: number): Vec3 {
    const { i, j, k } = this.#brick;
    return [
      BRICK * i + (c % SIDE),
      BRICK * j + (Math.floor(c / SIDE) % SIDE),
      BRICK * k + Math.floor(c / (SIDE * SIDE)),
    ];
  }

  #number(c: number): number {
    const [x, y, z] = this.#node(c);
    const { counts } = this.#bricks.lattice;
    return x + counts[0] * (y + counts[1] * z);
  }

  /** What it was before an edit, since when the lattice may have grown. */
  #numberIn(before: BrickMesh, c: number): number {
    const [x, y, z] = this.#node(c);
    const [dx, dy, dz] = this.#more;
    const { counts } = before.#bricks.lattice;
    return x - dx + counts[0] * (y - dy + counts[1] * (z - dz));
  }

  #at(c: number): Vec3 {
    const { origin, step } = this.#bricks.lattice;
    const [x, y, z] = this.#node(c);
    return [origin[0] + x * step, origin[1] + y * step, origin[2] + z * step];
  }
}
