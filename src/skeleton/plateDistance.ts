/**
 * How far a point of the plane is from a region: nothing where the loops go round it, else the nearest edge. Edges are those
 * of outline.ts; a chord whose circle is farther than what has been found stands for its run.
 */
import { CIRCLE, NEXT, STRIDE } from './outline.ts';

export function plateDistance(edges: Float64Array, x: number, y: number): number {
  let best2 = Infinity;
  let winding = 0;
  let next = STRIDE;
  for (let i = 0; i < edges.length; i = next) {
    const end = edges[i + NEXT]!;
    next = i + STRIDE;
    const isEdge = end === next;
    if (!isEdge && !isFar(edges, i, x, y, best2)) continue;
    next = end;
    // a chord leaves the same points on its left as its run, but for those within its circle
    winding += crossing(edges, i, x, y);
    if (isEdge) best2 = Math.min(best2, squared(edges, i, x, y));
  }
  return winding === 0 ? Math.sqrt(best2) : 0;
}

/** Whether the circle around the run at `i` is farther than √best2 and does not hold the point. */
function isFar(edges: Float64Array, i: number, x: number, y: number, best2: number): boolean {
  const dx = edges[i + CIRCLE]! - x;
  const dy = edges[i + CIRCLE + 1]! - y;
  const radius = edges[i + CIRCLE + 2]!;
  const distance = Math.sqrt(dx * dx + dy * dy) - radius;
  return distance > 0 && distance * distance > best2;
}

function squared(edges: Float64Array, i: number, x: number, y: number): number {
  const dx = x - edges[i]!;
  const dy = y - edges[i + 1]!;
  const length = edges[i + 6]!;
  const along = Math.min(Math.max(dx * edges[i + 4]! + dy * edges[i + 5]!, 0), length);
  const ax = dx - along * edges[i + 4]!;
  const ay = dy - along * edges[i + 5]!;
  return ax * ax + ay * ay;
}

/** 1 or −1 where the edge crosses the ray from the point along x, upwards or downwards. */
function crossing(edges: Float64Array, i: number, x: number, y: number): number {
  const x0 = edges[i]! - x;
  const y0 = edges[i + 1]! - y;
  const x1 = edges[i + 2]! - x;
  const y1 = edges[i + 3]! - y;
  if (y0 > 0 === y1 > 0) return 0;
  const side = x0 * y1 - x1 * y0;
  return y1 > 0 ? (side > 0 ? 1 : 0) : side < 0 ? -1 : 0;
}
