/**
 * The medial axis of a region, nearly: the circumcentres of its constrained Delaunay triangles, linked where triangles share an edge (Tai et
 * al. 2004, §5.1).
 *
 * Departures: the radius of a place is its distance from the outline, not the circumradius, which is wrong where an edge of the outline cuts
 * the circle; and a circumcentre outside the region, as obtuse triangles beside an edge have it, gives way to the middle of the triangle's
 * longest inner edge, which is inside. Of triangles without an inner edge only the largest circle inside is kept.
 */

import { type Triangulation, triangulate } from '../../math/triangulate.ts';
import { cross2, dot2, length2, mix2, scale2, sub2 } from '../../math/tuple.ts';
import type { Vec2 } from '../../math/vec.ts';
import { distanceFrom, edgesOf, isWithin, type Loop } from './outline.ts';

/** A circle inside the region, mm. */
export interface MedialNode {
  readonly at: Vec2;
  readonly radius: number;
}

/** Circles, and which follow on which. */
export interface MedialGraph {
  readonly nodes: readonly MedialNode[];
  /** indices of nodes, each pair once */
  readonly links: readonly (readonly [number, number])[];
}

export interface MedialAxis extends MedialGraph {
  /** inner edges of each node's triangle: 3 a junction, 2 a sleeve, 1 an end */
  readonly degrees: readonly number[];
  readonly triangulation: Triangulation;
}

/** Of a region whose loops do not cross; holes are loops too. No nodes where the loops hold nothing. */
export function medialAxis(loops: readonly Loop[]): MedialAxis {
  const triangulation = triangulate(loops);
  const { triangles, across } = triangulation;
  const count = triangles.length / 3;
  const edges = edgesOf(loops);
  const nodes = Array.from({ length: count }, (_, t) => nodeOf(triangulation, t, edges));
  const links = Array.from(across, (other, k) => [Math.floor(k / 3), other] as const).filter(
    ([t, other]) => other > t,
  );
  const degrees = nodes.map((_, t) => [0, 1, 2].filter((i) => across[3 * t + i]! >= 0).length);
  return { nodes, links, degrees, triangulation };
}

function nodeOf({ points, triangles, across }: Triangulation, t: number, edges: Float64Array): MedialNode {
  const corners = [0, 1, 2].map((i) => points[triangles[3 * t + i]!]!);
  const centre = circumcentre(corners[0]!, corners[1]!, corners[2]!);
  const inner = [0, 1, 2].filter((i) => across[3 * t + i]! >= 0);
  if (inner.length === 0) return incircle(corners);
  if (centre && isWithin(edges, ...centre)) return { at: centre, radius: distanceFrom(edges, ...centre) };
  const middles = inner
    .map((i) => [corners[i]!, corners[(i + 1) % 3]!] as const)
    .sort(([a, b], [c, d]) => length2(sub2(c, d)) - length2(sub2(a, b)));
  const at = mix2(...middles[0]!, 0.5);
  return { at, radius: distanceFrom(edges, ...at) };
}

/** null where rounding leaves no triangle. */
function circumcentre(a: Vec2, b: Vec2, c: Vec2): Vec2 | null {
  const [p, q] = [sub2(b, a), sub2(c, a)];
  const area = 2 * cross2(p, q);
  if (!(Math.abs(area) > 1e-12 * length2(p) * length2(q))) return null;
  const [pp, qq] = [dot2(p, p), dot2(q, q)];
  return [a[0] + (q[1] * pp - p[1] * qq) / area, a[1] + (p[0] * qq - q[0] * pp) / area];
}

function incircle(corners: readonly Vec2[]): MedialNode {
  const [a, b, c] = corners as [Vec2, Vec2, Vec2];
  const sides = [length2(sub2(b, c)), length2(sub2(c, a)), length2(sub2(a, b))] as const;
  const whole = sides[0] + sides[1] + sides[2];
  const sum = (axis: 0 | 1) => sides[0] * a[axis] + sides[1] * b[axis] + sides[2] * c[axis];
  return { at: scale2([sum(0), sum(1)], 1 / whole), radius: cross2(sub2(b, a), sub2(c, a)) / whole };
}
