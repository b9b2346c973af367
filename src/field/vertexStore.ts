/** The vertices of a mesh that is being made: of edges of the lattice, each at most once, and of others. */
import { Growing } from '../math/growing.ts';
import type { Vec3 } from '../math/vec.ts';
import { EdgeTable } from './edgeTable.ts';

export const NO_BRANCH = -1;

/** A place on the surface and the unit normal there; 0 where the field has no slope. */
export interface OnSurface {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly nx: number;
  readonly ny: number;
  readonly nz: number;
}

export class VertexStore {
  readonly positions = new Growing(Float64Array);
  readonly normals = new Growing(Float32Array);
  readonly colours = new Growing(Float32Array);
  /** numbers of the smooth fields that they are on; NO_BRANCH where that is not told */
  readonly branches: number[] = [];
  /** those without a normal */
  readonly flat: number[] = [];
  readonly #edges = new EdgeTable();
  /** the values at both ends of each vertex' edge, if it is on one; null where there is no next edit */
  readonly #ends: number[] | null;
  /** those that are as they were before an edit */
  readonly #taken = new Set<number>();

  constructor(isLive: boolean) {
    this.#ends = isLive ? [] : null;
  }

  add({ x, y, z, nx, ny, nz }: OnSurface, colour: Vec3, branch: number): number {
    const made = this.branches.length;
    this.positions.push(x, y, z);
    this.normals.push(nx, ny, nz);
    this.colours.push(colour[0], colour[1], colour[2]);
    this.branches.push(branch);
    this.#ends?.push(Number.NaN, Number.NaN);
    if (nx === 0 && ny === 0 && nz === 0) this.flat.push(made);
    return made;
  }

  /** Of an edge; −1 where it has none. */
  onEdge(key: number): number {
    return this.#edges.get(key);
  }

  /** Puts a vertex on an edge with these values at its ends. */
  put(vertex: number, key: number, a: number, b: number): void {
    this.#edges.set(key, vertex);
    if (!this.#ends) return;
    this.#ends[2 * vertex] = a;
    this.#ends[2 * vertex + 1] = b;
  }

  /** That of `before`, whose key was `then`, where the values at the ends are what they were; −1 where there is none. */
  take(before: VertexStore, then: number, key: number, a: number, b: number): number {
    const known = before.onEdge(then);
    const ends = before.#ends;
    if (known < 0 || !ends || ends[2 * known] !== a || ends[2 * known + 1] !== b) return -1;
    const taken = this.#copy(before, known);
    this.put(taken, key, a, b);
    this.#taken.add(taken);
    return taken;
  }

  areTaken(vertices: readonly number[]): boolean {
    return vertices.every((vertex) => this.#taken.has(vertex));
  }

  /** Of positions, normals or colours. */
  mean({ array: of }: VertexStore['positions' | 'colours'], vertices: readonly number[]): Vec3 {
    const along = (axis: number) =>
      vertices.reduce((sum, vertex) => sum + of[3 * vertex + axis]!, 0) / vertices.length;
    return [along(0), along(1), along(2)];
  }

  #copy({ positions, normals, colours, branches }: VertexStore, i: number): number {
    const three = ({ array: of }: VertexStore['positions' | 'normals']): Vec3 => [
      of[3 * i]!,
      of[3 * i + 1]!,
      of[3 * i + 2]!,
    ];
    return this.add(onSurface(three(positions), three(normals)), three(colours), branches[i]!);
  }
}

export const onSurface = ([x, y, z]: Vec3, [nx, ny, nz]: Vec3): OnSurface => ({ x, y, z, nx, ny, nz });
