/**
 * The vertices of a mesh on the edges of one brick's cells after the other, each edge with one at most, wherever it is asked for first: so
 * meshes are closed across bricks.
 */
import { add3, length3, scale3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { FLOPS } from '../skeleton/work.ts';
import type { Brick, Bricks } from './bricks.ts';
import { CUT } from './brickValues.ts';
import { CROSSING_FLOPS, cubicCrossing, EdgePoint, UNSURE } from './edgePoint.ts';
import { CORNERS, SIDE } from './hermite.ts';
import { BRICK, type Lattice, nodesBefore } from './lattice.ts';
import type { Near, Tally } from './near.ts';
import { NO_BRANCH, onSurface, type VertexStore } from './vertexStore.ts';

/** from a corner to the next along each axis */
export const AXES = [1, SIDE, SIDE * SIDE] as const;

/** The corners of a brick along each axis. */
const [ACROSS_X, ACROSS_Y, ACROSS_Z] = AXES.map((stride) =>
  Uint8Array.from({ length: CORNERS }, (_, c) => Math.floor(c / stride) % SIDE),
) as [Uint8Array, Uint8Array, Uint8Array];
const ALONG = [ACROSS_X, ACROSS_Y, ACROSS_Z] as const;

/** The vertices of the mesh before an edit, and its lattice. */
export interface Earlier {
  readonly store: VertexStore;
  readonly lattice: Lattice;
}

export class BrickVertices {
  /** Of edges that are crossed their vertices, by the first corner + CORNERS times the axis. */
  readonly onEdge = new Int32Array(3 * CORNERS);
  readonly #bricks: Bricks;
  readonly #whole: Near;
  readonly #tally: Tally;
  readonly #store: VertexStore;
  readonly #point: EdgePoint;
  readonly #paint = new Float64Array(3);
  #before: Earlier | null;
  /** nodes of this lattice before the first of the one before */
  readonly #more: Vec3;
  #brick: Brick;
  #own: Float64Array = new Float64Array(CORNERS);

  /** `whole`: the field by all skels; `before`: the mesh before an edit. */
  constructor(bricks: Bricks, whole: Near, tally: Tally, store: VertexStore, before: Earlier | null = null) {
    this.#bricks = bricks;
    this.#whole = whole;
    this.#tally = tally;
    this.#store = store;
    this.#before = before;
    this.#more = before ? nodesBefore(before.lattice, bricks.lattice) : [0, 0, 0];
    this.#point = new EdgePoint(bricks.lattice.step);
    this.#brick = bricks.active[0]!;
  }

  /**
   * Goes to a brick with these values at its corners, of which some are inside (1); `isKept`: its field is that before the edit.
   */
  enter(brick: Brick, values: Float64Array, inside: Uint8Array, isKept: boolean): void {
    this.#brick = brick;
    this.#own = values;
    for (let axis = 0; axis < 3; axis++) {
      const stride = AXES[axis]!;
      const along = ALONG[axis]!;
      for (let c = 0; c < CORNERS; c++) {
        if (along[c] === BRICK || inside[c] === inside[c + stride]) continue;
        this.onEdge[c + CORNERS * axis] = this.#vertex(c, axis, isKept ? this.#before : null);
      }
    }
  }

  /** Of the lattice, at a corner of the brick. */
  numberOf(c: number): number {
    const { i, j, k } = this.#brick;
    const { counts } = this.#bricks.lattice;
    const x = BRICK * i + ACROSS_X[c]!;
    const y = BRICK * j + ACROSS_Y[c]!;
    const z = BRICK * k + ACROSS_Z[c]!;
    return x + counts[0] * (y + counts[1] * z);
  }

  /** What it was before an edit, since when the lattice may have grown. */
  numberBefore(c: number): number {
    const { i, j, k } = this.#brick;
    const [dx, dy, dz] = this.#more;
    const { counts } = (this.#before ?? this.#bricks).lattice;
    const x = BRICK * i + ACROSS_X[c]! - dx;
    const y = BRICK * j + ACROSS_Y[c]! - dy;
    const z = BRICK * k + ACROSS_Z[c]! - dz;
    return x + counts[0] * (y + counts[1] * z);
  }

  /** What was before. */
  forget(): void {
    this.#before = null;
  }

  at(c: number): Vec3 {
    const { i, j, k } = this.#brick;
    const { origin, step } = this.#bricks.lattice;
    return [
      origin[0] + (BRICK * i + ACROSS_X[c]!) * step,
      origin[1] + (BRICK * j + ACROSS_Y[c]!) * step,
      origin[2] + (BRICK * k + ACROSS_Z[c]!) * step,
    ];
  }

  #vertex(c: number, axis: number, before: Earlier | null): number {
    const store = this.#store;
    const key = axis + 3 * this.numberOf(c);
    const known = store.onEdge(key);
    if (known >= 0) return known;
    const a = this.#own[c]!;
    const b = this.#own[c + AXES[axis]!]!;
    const taken = before ? store.take(before.store, axis + 3 * this.numberBefore(c), key, a, b) : -1;
    if (taken >= 0) return taken;
    const made = a === CUT || b === CUT ? this.#cutOff(c, axis) : this.#placed(c, axis);
    store.put(made, key, a, b);
    return made;
  }

  /** Between the corner and the next along the axis. */
  #placed(c: number, axis: number): number {
    const { near } = this.#brick;
    const point = this.#point;
    const a = this.at(c);
    point.enter(a[0], a[1], a[2], axis);
    const isSmooth =
      near.branches === 1 && point.newton(near, this.#crossing(c, axis)) && point.sharpen(this.#whole, near);
    if (!isSmooth) {
      this.#searched(a, c, c + AXES[axis]!);
    }
    const { x, y, z } = point;
    const colour = near.plain ?? this.#colourAt([x, y, z]);
    return this.#store.add(point, colour, near.branch(x, y, z));
  }

  /** Along the edge between two corners, the first at `a`; by all skels where what the list misses moves the surface. */
  #searched(a: Vec3, c: number, end: number): void {
    const { near } = this.#brick;
    const point = this.#point;
    const [b, atA, atB] = [this.at(end), this.#own[c]!, this.#own[end]!];
    point.search(near, a, b, atA, atB);
    const { x, y, z } = point;
    if (near.errorAt(x, y, z) > UNSURE * Math.abs(atA - atB)) point.search(this.#whole, a, b, atA, atB);
  }

  /** Where the cubic through four corners of the brick around an edge crosses it. */
  #crossing(c: number, axis: number): number {
    this.#tally.work += CROSSING_FLOPS / FLOPS;
    const own = this.#own;
    const stride = AXES[axis]!;
    const along = ALONG[axis]![c]!;
    const first = along < 2 ? 0 : 1;
    const at = c + (first - along) * stride;
    return cubicCrossing(
      own[at]!,
      own[at + stride]!,
      own[at + 2 * stride]!,
      own[at + 3 * stride]!,
      along - first,
    );
  }

  /** What goes on beyond the lattice ends half a cell within it. */
  #cutOff(c: number, axis: number): number {
    const { counts } = this.#bricks.lattice;
    const { i, j, k } = this.#brick;
    const out = [i, j, k].map((brick, way) => {
      const low = BRICK * brick + ALONG[way]![c]!;
      return low === 0 ? -1 : low + (way === axis ? 1 : 0) === counts[way]! - 1 ? 1 : 0;
    }) as unknown as Vec3;
    const at = scale3(add3(this.at(c), this.at(c + AXES[axis]!)), 0.5);
    const colour = this.#brick.near.plain ?? this.#colourAt(at);
    return this.#store.add(onSurface(at, scale3(out, 1 / length3(out))), colour, NO_BRANCH);
  }

  #colourAt(at: Vec3): Vec3 {
    const paint = this.#paint;
    this.#brick.near.colour(...at, paint);
    return [paint[0]!, paint[1]!, paint[2]!];
  }
}
