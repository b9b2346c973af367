/**
 * What a mesh is as a solid, judged by position: copies of a vertex (creases, seams) are welded first.
 *
 * Euler–Poincaré: V − E + F = 2 (components − genus). Where a solid touches itself in a point (strokes that
 * cross pinch it) the two sides are counted as if the point were there twice: V counts the fans of triangles
 * around points, and components hang together by edges. Otherwise a pinch would count as half a hole.
 */
import { cross3, length3, sub3 } from '../math/tuple.ts';
import { eachTriangle } from './measure.ts';
import type { Mesh } from './mesh.ts';
import { weld } from './weld.ts';

export interface Topology {
  /** every edge belongs to exactly two triangles that run through it in opposite directions */
  readonly watertight: boolean;
  /** edges for which that is not so */
  readonly badEdges: number;
  /** V − E + F, pinched points counted once a fan */
  readonly euler: number;
  /** summed over the components; NaN when the mesh is not watertight */
  readonly genus: number;
  /** parts that hang together by edges */
  readonly components: number;
  /** triangles with an area below 1e-10 of their longest edge squared */
  readonly degenerate: number;
  /** no NaN and no infinity in positions, normals and texture coordinates */
  readonly finite: boolean;
}

/** Judges a mesh; one without triangles is watertight with no components. */
export function topology(mesh: Mesh): Topology {
  const { ids, count } = weld(mesh.positions);
  const corners = Uint32Array.from(mesh.indices, (i) => ids[i]!);
  const fans = new Sets(corners.length);
  const parts = new Sets(corners.length / 3);
  const { edges, badEdges } = joinEdges(corners, count, fans, parts);
  const euler = fans.count - edges + corners.length / 3;
  const watertight = badEdges === 0;
  return {
    watertight,
    badEdges,
    euler,
    genus: watertight ? parts.count - euler / 2 : Number.NaN,
    components: parts.count,
    degenerate: countDegenerate(mesh),
    finite: [mesh.positions, mesh.normals, mesh.uvs].every(allFinite),
  };
}

/** Walks all edges; triangles that share a sound one are joined, and so are their corners at both its ends. */
function joinEdges(corners: Uint32Array, count: number, fans: Sets, parts: Sets) {
  const { starts, halves } = halvesByLowerEnd(corners, count);
  let edges = 0;
  let badEdges = 0;
  for (let low = 0; low < count; low++) {
    const end = starts[low + 1]!;
    sortByUpperEnd(halves, starts[low]!, end, corners);
    for (let i = starts[low]!; i < end; ) {
      const high = upperEnd(corners, halves[i]!);
      let following = i + 1;
      while (following < end && upperEnd(corners, halves[following]!) === high) following++;
      edges++;
      const [a, b] = [halves[i]!, halves[i + 1]!];
      if (following - i === 2 && corners[a] !== corners[b]) joinAcross(a, b, fans, parts);
      else badEdges++;
      i = following;
    }
  }
  return { edges, badEdges };
}

/** Insertion sort: six half-edges on average, and no array is made for them. */
function sortByUpperEnd(halves: Uint32Array, from: number, to: number, corners: Uint32Array): void {
  for (let i = from + 1; i < to; i++) {
    const half = halves[i]!;
    const key = upperEnd(corners, half);
    let at = i;
    for (; at > from && upperEnd(corners, halves[at - 1]!) > key; at--) halves[at] = halves[at - 1]!;
    halves[at] = half;
  }
}

/** Half-edges (numbered by the corner they leave) sorted by the lower id of their ends: a counting sort. */
function halvesByLowerEnd(corners: Uint32Array, count: number) {
  const starts = new Uint32Array(count + 1);
  const low = (half: number): number => Math.min(corners[half]!, corners[next(half)]!);
  for (let half = 0; half < corners.length; half++) starts[low(half) + 1]!++;
  for (let id = 0; id < count; id++) starts[id + 1]! += starts[id]!;
  const fill = starts.slice();
  const halves = new Uint32Array(corners.length);
  for (let half = 0; half < corners.length; half++) halves[fill[low(half)]!++] = half;
  return { starts, halves };
}

/** The half-edges run oppositely: where one leaves, the other arrives. */
function joinAcross(a: number, b: number, fans: Sets, parts: Sets): void {
  fans.join(a, next(b));
  fans.join(next(a), b);
  parts.join(Math.floor(a / 3), Math.floor(b / 3));
}

function upperEnd(corners: Uint32Array, half: number): number {
  return Math.max(corners[half]!, corners[next(half)]!);
}

function next(half: number): number {
  return half % 3 === 2 ? half - 2 : half + 1;
}

function countDegenerate(mesh: Mesh): number {
  let found = 0;
  eachTriangle(mesh, (a, b, c) => {
    const sides = [sub3(b, a), sub3(c, a), sub3(c, b)] as const;
    const longest = Math.max(...sides.map(length3));
    if (!(length3(cross3(sides[0], sides[1])) > 2e-10 * longest * longest)) found++;
  });
  return found;
}

function allFinite(values: Float32Array): boolean {
  return values.every((value) => Number.isFinite(value));
}

/** Disjoint sets (union–find with path halving). */
class Sets {
  readonly #parents: Uint32Array;
  count: number;

  constructor(size: number) {
    this.#parents = Uint32Array.from({ length: size }, (_, i) => i);
    this.count = size;
  }

  join(a: number, b: number): void {
    const rootA = this.#root(a);
    const rootB = this.#root(b);
    if (rootA === rootB) return;
    this.#parents[rootA] = rootB;
    this.count--;
  }

  #root(i: number): number {
    const parents = this.#parents;
    let at = i;
    while (parents[at] !== at) {
      parents[at] = parents[parents[at]!]!;
      at = parents[at]!;
    }
    return at;
  }
}
