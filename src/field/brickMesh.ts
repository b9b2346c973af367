/**
 * Marching cubes over the active bricks: by loops around each cube (cubeLoops.ts), whose vertices are on edges of the lattice
 * (brickVertices.ts). Where smooth fields meet in an edge (hard unions, boxes) the loop gets a point on the crease (loopPoints.ts) in its
 * middle.
 *
 * Chosen over dual contouring, whose surfaces need repairs to be manifold, and over marching tetrahedra, which have more than
 * twice the triangles for the same field.
 */
import { Growing } from '../math/growing.ts';
import type { Mesh } from '../mesh/mesh.ts';
import type { Brick, Bricks } from './bricks.ts';
import { type BrickValues, CUT } from './brickValues.ts';
import { AXES, BrickVertices } from './brickVertices.ts';
import { CreaseFans } from './creaseFans.ts';
import { AMBIGUOUS, CubeLoops, type Loops, MOST_CROSSINGS, plainLoops } from './cubeLoops.ts';
import { EdgePoint } from './edgePoint.ts';
import { CORNERS, SIDE } from './hermite.ts';
import { isolatedSpots, type OneSided } from './isolated.ts';
import { BRICK } from './lattice.ts';
import { localField } from './local.ts';
import { type LoopPoint, LoopPoints } from './loopPoints.ts';
import { eachTriangle } from './loopTriangles.ts';
import { meanNormals } from './meanNormals.ts';
import type { Tally } from './near.ts';
import { type Thin, thinOf } from './thin.ts';
import type { ThinSpot } from './thinWalls.ts';
import { unseenIn } from './unseen.ts';
import { NO_BRANCH, onSurface, VertexStore } from './vertexStore.ts';

/** A mesh painted by the field. */
export interface FieldMesh extends Mesh {
  readonly colours: Float32Array;
  /** null: nowhere is the body thinner than a cell; left out where nobody looked */
  readonly thin?: Thin | null;
}

/** From the first corner of a cube to the others. */
const CUBE = Int32Array.from(
  { length: 8 },
  (_, corner) => (corner & 1) * AXES[0] + ((corner >> 1) & 1) * AXES[1] + (corner >> 2) * AXES[2],
);
/** From the first corner of a cube to its edges, as BrickVertices numbers them; by corner + 8 axis. */
const EDGES = Int32Array.from({ length: 24 }, (_, edge) => CUBE[edge & 7]! + CORNERS * (edge >> 3));

/** Vertices of a loop at hand, by its length. */
const RINGS = Array.from({ length: MOST_CROSSINGS + 1 }, (_, length) => Array.from({ length }, () => 0));

export class BrickMesh {
  readonly #values: BrickValues;
  readonly #bricks: Bricks;
  readonly #store: VertexStore;
  readonly #vertices: BrickVertices;
  readonly #indices = new Growing(Uint32Array);
  readonly #loops = new CubeLoops();
  readonly #eight = new Float64Array(8);
  readonly #inside = new Uint8Array(CORNERS);
  readonly #point: EdgePoint;
  readonly #fans: CreaseFans;
  readonly #points: LoopPoints;
  readonly #unseen: ThinSpot[] = [];
  readonly #oneSided: OneSided = { empty: [], full: [] };
  #brick: Brick;
  #own: Float64Array = new Float64Array(CORNERS);
  #isKept = false;

  /** `before`: the mesh before an edit, which is taken over where nothing changed. */
  constructor(bricks: Bricks, values: BrickValues, tally: Tally, before: BrickMesh | null = null) {
    const { step } = bricks.lattice;
    this.#values = values;
    this.#store = new VertexStore(values.isLive);
    this.#bricks = bricks;
    this.#brick = bricks.active[0]!;
    const earlier = before && { store: before.#store, lattice: before.#bricks.lattice };
    this.#vertices = new BrickVertices(bricks, values.whole, tally, this.#store, earlier);
    this.#point = new EdgePoint(step);
    this.#fans = new CreaseFans(this.#store.branches, this.#triangle);
    this.#points = new LoopPoints(this.#store, step, before === null ? null : before.#points);
  }

  /** The cells of one brick, with the values at its corners; bricks come in order. `isKept`: its field is that of the mesh before. */
  add(brick: Brick, values: Float64Array, isKept = false): void {
    if (this.enter(brick, values, isKept)) this.join();
  }

  /** The vertices of a brick; false where the surface does not come. */
  enter(brick: Brick, values: Float64Array, isKept = false): boolean {
    this.#brick = brick;
    this.#own = values;
    this.#isKept = isKept;
    const inside = this.#inside;
    let count = 0;
    for (let c = 0; c < CORNERS; c++) {
      inside[c] = values[c]! > 0 ? 1 : 0;
      count += inside[c]!;
    }
    if (count === 0 || count === CORNERS) {
      this.#lookBetween(count === 0 ? this.#oneSided.empty : this.#oneSided.full);
      return false;
    }
    this.#vertices.enter(brick, values, inside, isKept);
    return true;
  }

  /** The triangles of the brick that was entered. */
  join(): void {
    for (let k = 0; k < BRICK; k++) {
      for (let j = 0; j < BRICK; j++) {
        for (let i = 0; i < BRICK; i++) this.#cube(i + SIDE * (j + SIDE * k));
      }
    }
  }

  /** Of all bricks that were added; what was before is forgotten. */
  mesh(): FieldMesh {
    this.#fans.finish();
    this.#vertices.forget();
    this.#points.forget();
    const { flat } = this.#store;
    const positions = this.#store.positions.numbers();
    const normals = this.#store.normals.numbers();
    const alone = isolatedSpots(this.#values.whole, this.#bricks, this.#oneSided);
    const seen = { positions, normals };
    const mesh = {
      positions: new Float32Array(positions),
      normals: normals.slice(),
      uvs: new Float32Array((2 * positions.length) / 3),
      indices: this.#indices.numbers().slice(),
      colours: this.#store.colours.numbers().slice(),
      thin: thinOf(seen, this.#bricks.lattice, localField(this.#bricks), [...this.#unseen, ...alone]),
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

  /** `alike`: those that have all corners on one side, too. */
  #lookBetween(alike: number[]): void {
    const missed = unseenIn(this.#brick, this.#own, this.#bricks.lattice, this.#values.whole);
    if (missed) this.#unseen.push(missed);
    else alike.push(this.#bricks.grid[this.#brickNumber()]!);
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
    const { edges, ends, count, isTwisted } =
      AMBIGUOUS[mask] === 1 ? this.#decided(mask, c) : plainLoops(mask);
    const { onEdge } = this.#vertices;
    for (let loop = 0, start = 0; loop < count; loop++) {
      const length = ends[loop]! - start;
      const ring = RINGS[length]!;
      for (let i = 0; i < length; i++) ring[i] = onEdge[c + EDGES[edges[start + i]!]!]!;
      this.#fill(ring, c, loop, isTwisted[loop] === 1);
      start += length;
    }
  }

  /** Of a cube with faces that may hang together either way. */
  #decided(mask: number, c: number): Loops {
    for (let corner = 0; corner < 8; corner++) this.#eight[corner] = this.#decider(c + CUBE[corner]!);
    this.#loops.trace(mask, this.#eight);
    return this.#loops;
  }

  /** What decides how a face hangs together is not interpolated. */
  #decider(c: number): number {
    const value = this.#own[c]!;
    const exact = value === CUT ? value : this.#values.exact(this.#brick, c);
    return exact > 0 === value > 0 ? exact : value;
  }

  /** A piece of surface in a loop. */
  #fill(ring: readonly number[], c: number, loop: number, isTwisted: boolean): void {
    const { near } = this.#brick;
    if (near.branches === 1 && !isTwisted) {
      eachTriangle(ring, null, this.#store.positions.array, this.#triangle);
      return;
    }
    const isSame = this.#isKept && this.#store.areTaken(ring);
    const key = {
      now: loop + 4 * this.#vertices.numberOf(c),
      before: isSame ? loop + 4 * this.#vertices.numberBefore(c) : null,
    };
    const fan = near.branches > 1 ? this.#points.creased(near, this.#values.whole, ring, key) : null;
    if (fan) {
      this.#fans.add(ring, fan);
      return;
    }
    const search = () => this.#middle(ring, c);
    const middle = isTwisted ? this.#points.remembered(key, 'middle', search) : null;
    eachTriangle(ring, middle && this.#addMiddle(ring, middle), this.#store.positions.array, this.#triangle);
  }

  #addMiddle(ring: readonly number[], { at, normals }: LoopPoint): number {
    const store = this.#store;
    return store.add(onSurface(at, normals[0]!), store.mean(store.colours, ring), NO_BRANCH);
  }

  /** On the surface near the mean of a loop, or else towards a corner that is on its other side. */
  #middle(ring: readonly number[], c: number): LoopPoint {
    const mean = this.#store.mean(this.#store.positions, ring);
    const point = this.#point;
    const { near } = this.#brick;
    [point.x, point.y, point.z] = mean;
    if (!point.polish(near)) {
      const value = near.value(...mean);
      const corners = [...CUBE].map((offset) => c + offset).filter((at) => this.#own[at]! > 0 !== value > 0);
      const other = corners.reduce((a, b) => (Math.abs(this.#own[b]!) > Math.abs(this.#own[a]!) ? b : a));
      point.search(near, mean, this.#vertices.at(other), value, this.#own[other]!);
    }
    const { x, y, z, nx, ny, nz } = point;
    return { at: [x, y, z], normals: [[nx, ny, nz]] };
  }
}
