/** The vertices of a mesh that is being made: of edges of the lattice, each at most once, and of others. */
import type { Vec3 } from '../math/vec.ts';

export const NO_BRANCH = -1;

/** The values at both ends of a vertex' edge. */
export type Ends = readonly [a: number, b: number];

export interface Vertex {
  readonly at: Vec3;
  /** unit; 0 where the field has no slope */
  readonly normal: Vec3;
  readonly colour: Vec3;
  /** number of the smooth field that it is on; NO_BRANCH where that is not told */
  readonly branch: number;
}

export class VertexStore {
  readonly positions: number[] = [];
  readonly normals: number[] = [];
  readonly colours: number[] = [];
  readonly branches: number[] = [];
  /** those without a normal */
  readonly flat: number[] = [];
  readonly #edges = new Map<number, { readonly vertex: number; readonly ends: Ends }>();
  /** those that are as they were before an edit */
  readonly #taken = new Set<number>();

  add({ at, normal, colour, branch }: Vertex): number {
    const made = this.branches.length;
    this.positions.push(at[0], at[1], at[2]);
    this.normals.push(normal[0], normal[1], normal[2]);
    this.colours.push(colour[0], colour[1], colour[2]);
    this.branches.push(branch);
    if (normal[0] === 0 && normal[1] === 0 && normal[2] === 0) this.flat.push(made);
    return made;
  }

  /** Of an edge that has one. */
  onEdge(key: number): number | undefined {
    return this.#edges.get(key)?.vertex;
  }

  addOnEdge(key: number, ends: Ends, vertex: Vertex): number {
    const made = this.add(vertex);
    this.#edges.set(key, { vertex: made, ends });
    return made;
  }

  /** That of `before`, whose key was `then`, where the values at the ends are what they were. */
  take(before: VertexStore, then: number, key: number, ends: Ends): number | null {
    const known = before.#edges.get(then);
    if (!known || known.ends[0] !== ends[0] || known.ends[1] !== ends[1]) return null;
    const taken = this.addOnEdge(key, ends, before.#vertex(known.vertex));
    this.#taken.add(taken);
    return taken;
  }

  areTaken(vertices: readonly number[]): boolean {
    return vertices.every((vertex) => this.#taken.has(vertex));
  }

  /** Of positions, normals or colours. */
  mean(of: readonly number[], vertices: readonly number[]): Vec3 {
    const along = (axis: number) =>
      vertices.reduce((sum, vertex) => sum + of[3 * vertex + axis]!, 0) / vertices.length;
    return [along(0), along(1), along(2)];
  }

  #vertex(i: number): Vertex {
    const three = (of: readonly number[]): Vec3 => [of[3 * i]!, of[3 * i + 1]!, of[3 * i + 2]!];
    return {
      at: three(this.positions),
      normal: three(this.normals),
      colour: three(this.colours),
      branch: this.branches[i]!,
    };
  }
}
