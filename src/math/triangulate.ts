/**
 * Constrained Delaunay triangulation of a region of the plane: its loops are edges of triangles, and only what lies inside is kept.
 *
 * Chew 1989, by delaunator and constrainautor: of the libraries that were tried the fastest that gets hand-drawn outlines right, once points
 * nearer than 1e-6 of the region's size are one (cdt2d took 50 times as long, poly2tri threw at near-duplicates). Where it refuses, ears are
 * cut instead, which gives a triangulation all the same, but no Delaunay one.
 */
import Constrainautor from '@kninnug/constrainautor';
import Delaunator from 'delaunator';
import earcut from 'earcut';
import { cross2, dot2, sub2 } from './tuple.ts';
import type { Vec2 } from './vec.ts';

export interface Triangulation {
  readonly points: readonly Vec2[];
  /** three indices each, counter-clockwise */
  readonly triangles: Uint32Array;
  /** of edge k, from corner k to the next of its triangle: the triangle beyond, −1 where it is of a loop */
  readonly across: Int32Array;
  readonly isDelaunay: boolean;
}

type Loop = readonly Vec2[];
export type Edge = readonly [number, number];

/** share of the box's longer side: points nearer are one */
const WELD = 1e-6;
/** more than the box has grid lines */
const ROW = 2097152;
/** at edges, for each place and edge, before a triangulation is given up; outlines need about ten */
const LOOKS = 300;
/** twice the area over the square of the longest side */
const SLIVER = 1e-9;

/** `loops` do not cross themselves or each other; what is inside an odd number of them is filled. Empty where nothing is. */
export function triangulate(loops: readonly Loop[]): Triangulation {
  const { points, rings } = welded(loops);
  const edges = rings.flatMap((ring) => ring.map((a, i) => [a, ring[(i + 1) % ring.length]!] as const));
  const delaunay = constrained(points, edges);
  const all = delaunay ?? ears(points, rings);
  const triangles = insideOf(all, points, edges);
  return {
    points,
    triangles,
    across: neighbours(triangles, edges, points.length),
    isDelaunay: delaunay !== null,
  };
}

/** Loops as indices of different points; those that vanish are left out. */
export function welded(loops: readonly Loop[]): { points: Vec2[]; rings: number[][] } {
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const loop of loops) {
    for (const [x, y] of loop) {
      left = Math.min(left, x);
      right = Math.max(right, x);
      low = Math.min(low, y);
      high = Math.max(high, y);
    }
  }
  const grid = WELD * Math.max(right - left, high - low) || 1;
  const known = new Map<number, number>();
  const points: Vec2[] = [];
  const indexOf = (p: Vec2): number => {
    const key = Math.round((p[0] - left) / grid) * ROW + Math.round((p[1] - low) / grid);
    const index = known.get(key) ?? points.push(p) - 1;
    known.set(key, index);
    return index;
  };
  const rings = loops
    .map((loop) => loop.map(indexOf).filter((at, i, ring) => at !== ring.at(i - 1)))
    .filter((ring) => ring.length > 2);
  return { points, rings };
}

/** All triangles of the hull, three indices each, the edges among theirs; null where the library refuses, as where edges cross. */
export function constrained(points: readonly Vec2[], edges: readonly Edge[]): Uint32Array | null {
  for (const [cosine, sine] of TURNS) {
    const turned = points.map(([x, y]): [number, number] => [x * cosine - y * sine, x * sine + y * cosine]);
    const triangles = constrainedOnce(turned, edges);
    if (triangles) return triangles;
  }
  return null;
}

/**
 * As given, then turned: rounding falls otherwise on places that were nearly in a row, and what went round in circles seldom does so again.
 * Of 5,000 outlines four did, triangles of three places among them; cut into ears they have no medial axis to speak of.
 */
const TURNS = [
  [1, 0],
  [0.8, 0.6],
  [0.28, 0.96],
  [-0.6, 0.8],
] as const;

function constrainedOnce(points: readonly [number, number][], edges: readonly Edge[]): Uint32Array | null {
  try {
    const delaunay = Delaunator.from(points as [number, number][]);
    new Patient(delaunay, LOOKS * (points.length + edges.length)).constrainAll(edges);
    return delaunay.triangles;
  } catch {
    return null;
  }
}

/** What goes round in circles where many places are nearly in a row gives up. */
class Patient extends Constrainautor {
  #looks: number;

  constructor(delaunay: Delaunator<ArrayLike<number>>, looks: number) {
    super(delaunay);
    this.#looks = looks;
  }

  protected override intersectSegments(a: number, b: number, c: number, d: number): boolean {
    this.#look();
    return super.intersectSegments(a, b, c, d);
  }

  protected override isDelaunay(edge: number): boolean {
    this.#look();
    return super.isDelaunay(edge);
  }

  #look(): void {
    if (--this.#looks < 0) throw new Error('the constraints are not met');
  }
}

/** Holes are those loops that lie within the first: all others. */
function ears(points: readonly Vec2[], rings: readonly (readonly number[])[]): Uint32Array {
  const order = rings.flat();
  const starts = rings
    .slice(1)
    .map((_, i) => rings.slice(0, i + 1).reduce((sum, ring) => sum + ring.length, 0));
  const cut: readonly number[] = earcut(
    order.flatMap((at) => points[at]!),
    starts,
    2,
  );
  return Uint32Array.from(cut.map((i) => order[i]!));
}

/** Those whose middle is inside an odd number of loops, counter-clockwise. */
function insideOf(triangles: Uint32Array, points: readonly Vec2[], edges: readonly Edge[]): Uint32Array {
  const ends = Float64Array.from(edges.flatMap(([i, j]) => [...points[i]!, ...points[j]!]));
  const kept: number[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const [i, j, k] = [triangles[t]!, triangles[t + 1]!, triangles[t + 2]!];
    const [a, b, c] = [points[i]!, points[j]!, points[k]!];
    const area = cross2(sub2(b, a), sub2(c, a));
    if (isSliver(a, b, c) || !isInside((a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, ends)) continue;
    if (area > 0) kept.push(i, j, k);
    else kept.push(i, k, j);
  }
  return Uint32Array.from(kept);
}

/** Of three places in a row on one edge: rounding decides on which side it is. */
export function isSliver(a: Vec2, b: Vec2, c: Vec2): boolean {
  const [p, q, r] = [sub2(b, a), sub2(c, b), sub2(a, c)];
  return Math.abs(cross2(p, q)) < SLIVER * Math.max(dot2(p, p), dot2(q, q), dot2(r, r));
}

function isInside(x: number, y: number, ends: Float64Array): boolean {
  let inside = false;
  for (let k = 0; k < ends.length; k += 4) {
    const ay = ends[k + 1]!;
    const by = ends[k + 3]!;
    if (ay > y === by > y) continue;
    if (x < ends[k]! + ((y - ay) / (by - ay)) * (ends[k + 2]! - ends[k]!)) inside = !inside;
  }
  return inside;
}

function neighbours(triangles: Uint32Array, edges: readonly Edge[], count: number): Int32Array {
  const across = new Int32Array(triangles.length).fill(-1);
  const key = (a: number, b: number) => (a < b ? a * count + b : b * count + a);
  const walls = new Set(edges.map(([a, b]) => key(a, b)));
  const open = new Map<number, number>();
  for (let k = 0; k < triangles.length; k++) {
    const end = k % 3 === 2 ? k - 2 : k + 1;
    const name = key(triangles[k]!, triangles[end]!);
    if (walls.has(name)) continue;
    const other = open.get(name);
    open.set(name, k);
    if (other === undefined) continue;
    across[k] = Math.floor(other / 3);
    across[other] = Math.floor(k / 3);
  }
  return across;
}
