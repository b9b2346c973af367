/**
 * Loops that cross themselves or each other, made into loops that do not: the outline of what the outer one goes round (winding number not 0)
 * and the inner ones do not.
 *
 * Edges are cut where they cross, the pieces constrain a triangulation, and its triangles are in or out as a whole: robust where rounding
 * puts a crossing on the wrong side, because the outline is read off the triangles.
 */
import { constrained, isSliver, type Edge as Pair, welded } from './triangulate.ts';
import { cross2, length2, mix2, sub2 } from './tuple.ts';
import type { Vec2 } from './vec.ts';

type Loop = readonly Vec2[];

/** Where two edges cross. */
export interface Crossing {
  readonly at: Vec2;
  /** indices among all edges of all loops, and how far along each, 0–1 */
  readonly edges: readonly [number, number];
  readonly along: readonly [number, number];
}

interface Edge {
  readonly a: Vec2;
  readonly b: Vec2;
}

const edgesOf = (loops: readonly Loop[]): readonly Edge[] =>
  loops.flatMap((loop) => loop.map((a, i) => ({ a, b: loop[(i + 1) % loop.length]! })));

/** Of edges that are not neighbours; touches count. */
export function crossingsOf(loops: readonly Loop[]): readonly Crossing[] {
  const edges = edgesOf(loops);
  const low = ({ a, b }: Edge, axis: 0 | 1) => Math.min(a[axis], b[axis]);
  const high = ({ a, b }: Edge, axis: 0 | 1) => Math.max(a[axis], b[axis]);
  const order = [...edges.keys()].sort((i, j) => low(edges[i]!, 0) - low(edges[j]!, 0));
  const found: Crossing[] = [];
  order.forEach((i, rank) => {
    const e = edges[i]!;
    for (let k = rank + 1; k < order.length; k++) {
      const j = order[k]!;
      const f = edges[j]!;
      if (low(f, 0) > high(e, 0)) break;
      if (low(f, 1) > high(e, 1) || high(f, 1) < low(e, 1)) continue;
      const crossing = e.b === f.a || e.a === f.b ? null : crossing2(e, f);
      if (crossing) found.push({ at: crossing.at, edges: [i, j], along: crossing.along });
    }
  });
  return found;
}

function crossing2(e: Edge, f: Edge): { at: Vec2; along: readonly [number, number] } | null {
  const [p, q, r] = [sub2(e.b, e.a), sub2(f.b, f.a), sub2(f.a, e.a)];
  const area = cross2(p, q);
  if (!(Math.abs(area) > 1e-12 * length2(p) * length2(q))) return null;
  const [s, t] = [cross2(r, q) / area, cross2(r, p) / area];
  if (s < 0 || s > 1 || t < 0 || t > 1) return null;
  return { at: mix2(e.a, e.b, s), along: [s, t] };
}

/** Outlines counter-clockwise and holes clockwise, in no order; what has no area is left out. The loops themselves where none cross. */
export function untangle(outer: Loop, inner: readonly Loop[] = []): readonly Loop[] {
  const loops = [outer, ...inner];
  const crossings = crossingsOf(loops);
  if (crossings.length === 0) return loops;
  const { points, rings } = welded(cutLoops(loops, crossings));
  const pairs = rings.flatMap((ring) => ring.map((a, i): Pair => [a, ring[(i + 1) % ring.length]!]));
  const unique = [
    ...new Map(pairs.map(([a, b]) => [a < b ? `${a} ${b}` : `${b} ${a}`, [a, b] as const])).values(),
  ];
  const triangles = constrained(points, unique);
  if (!triangles) return loops;
  return outlines(
    points,
    inside(
      points,
      triangles,
      (p) => windingOf(outer, p) !== 0 && inner.every((hole) => windingOf(hole, p) === 0),
    ),
  );
}

/** The loops with a corner at each crossing. */
function cutLoops(loops: readonly Loop[], crossings: readonly Crossing[]): readonly Loop[] {
  const cuts = new Map<number, { readonly t: number; readonly at: Vec2 }[]>();
  for (const { at, edges, along } of crossings) {
    for (const k of [0, 1] as const) {
      cuts.set(edges[k], [...(cuts.get(edges[k]) ?? []), { t: along[k], at }]);
    }
  }
  let edge = 0;
  return loops.map((loop) =>
    loop.flatMap((corner) => {
      const own = (cuts.get(edge++) ?? []).sort((a, b) => a.t - b.t);
      return [corner, ...own.map(({ at }) => at)];
    }),
  );
}

function inside(
  points: readonly Vec2[],
  triangles: Uint32Array,
  isIn: (p: Vec2) => boolean,
): readonly number[] {
  const kept: number[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = [triangles[t]!, triangles[t + 1]!, triangles[t + 2]!] as const;
    const [a, b, c] = corners.map((i) => points[i]!) as [Vec2, Vec2, Vec2];
    const middle: Vec2 = [(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3];
    if (isSliver(a, b, c) || !isIn(middle)) continue;
    const [i, j, k] = corners;
    kept.push(...(cross2(sub2(b, a), sub2(c, a)) > 0 ? [i, j, k] : [i, k, j]));
  }
  return kept;
}

/** How often a loop goes round a place, counter-clockwise. */
function windingOf(loop: Loop, [x, y]: Vec2): number {
  let turns = 0;
  loop.forEach((b, i) => {
    const a = loop.at(i - 1)!;
    if (a[1] > y === b[1] > y) return;
    const isLeft = x < a[0] + ((y - a[1]) / (b[1] - a[1])) * (b[0] - a[0]);
    if (isLeft) turns += b[1] > a[1] ? 1 : -1;
  });
  return turns;
}

/** Around the triangles, which lie to the left; pieces that only touch at a corner are loops of their own. */
function outlines(points: readonly Vec2[], triangles: readonly number[]): readonly Loop[] {
  const after = (k: number) => (k % 3 === 2 ? k - 2 : k + 1);
  const byEnds = new Map<string, number>();
  for (const [k, a] of triangles.entries()) byEnds.set(`${a} ${triangles[after(k)]!}`, k);
  const twin = (k: number) => byEnds.get(`${triangles[after(k)]!} ${triangles[k]!}`);
  const rest = new Set(triangles.flatMap((_, k) => (twin(k) === undefined ? [k] : [])));
  const loops: Vec2[][] = [];
  for (const start of rest) {
    const loop: Vec2[] = [];
    for (let k = start; rest.delete(k); ) {
      loop.push(points[triangles[k]!]!);
      k = after(k);
      // around the corner, from triangle to triangle, to the next edge that has nothing beyond
      for (let other = twin(k); other !== undefined; other = twin(k)) k = after(other);
    }
    loops.push(loop);
  }
  return loops.filter((loop) => loop.length > 2);
}
