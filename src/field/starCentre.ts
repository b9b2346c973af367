/**
 * The point of a loop that sees all of it, for polar profiles: its centroid if that does, else the centroid of the kernel
 * (the points that do), else the point of a grid that sees most.
 */
import { add2, cross2, length2, scale2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import { FieldError } from '../skeleton/skeleton.ts';

export interface StarCentre {
  readonly at: Vec2;
  /** false: parts of the loop are hidden even from here */
  readonly seesAll: boolean;
}

const GRID = 24;

/** FieldError for fewer than three points or a loop without area. */
export function starCentre(loop: readonly Vec2[]): StarCentre {
  const { area, centroid } = areaAndCentroid(loop);
  if (loop.length < 3 || !(Math.abs(area) > 0 && Math.abs(area) < Infinity)) {
    throw new FieldError('a profile needs a loop with an area');
  }
  const turned = area > 0 ? loop : [...loop].reverse();
  if (hidden(turned, centroid) === 0) return { at: centroid, seesAll: true };
  const kernel = visibleFrom(turned);
  const inner = areaAndCentroid(kernel);
  if (inner.area > 1e-9 * Math.abs(area)) return { at: inner.centroid, seesAll: true };
  return { at: leastHidden(turned), seesAll: false };
}

function areaAndCentroid(loop: readonly Vec2[]): { readonly area: number; readonly centroid: Vec2 } {
  const origin = loop[0] ?? [0, 0];
  let area = 0;
  let moment: Vec2 = [0, 0];
  for (let i = 0; i < loop.length; i++) {
    const a = sub2(loop[i]!, origin);
    const b = sub2(loop[(i + 1) % loop.length]!, origin);
    const twice = cross2(a, b);
    area += twice / 2;
    moment = add2(moment, scale2(add2(a, b), twice / 6));
  }
  return { area, centroid: add2(origin, scale2(moment, 1 / area)) };
}

/** Length of the edges whose outside faces `p`. */
function hidden(loop: readonly Vec2[], p: Vec2): number {
  return loop.reduce((sum, a, i) => {
    const edge = sub2(loop[(i + 1) % loop.length]!, a);
    return cross2(edge, sub2(p, a)) > 0 ? sum : sum + length2(edge);
  }, 0);
}

/** The loop's box cut by the line of every edge. */
function visibleFrom(loop: readonly Vec2[]): readonly Vec2[] {
  const { low, high } = extent(loop);
  const box: readonly Vec2[] = [low, [high[0], low[1]], high, [low[0], high[1]]];
  return loop.reduce((rest, a, i) => cut(rest, a, sub2(loop[(i + 1) % loop.length]!, a)), box);
}

/** What of a convex loop lies on the left of a line. */
function cut(loop: readonly Vec2[], a: Vec2, along: Vec2): readonly Vec2[] {
  const side = (p: Vec2) => cross2(along, sub2(p, a));
  return loop.flatMap((p, i) => {
    const q = loop[(i + 1) % loop.length]!;
    const [sp, sq] = [side(p), side(q)];
    const kept = sp >= 0 ? [p] : [];
    return sp >= 0 === sq >= 0 ? kept : [...kept, add2(p, scale2(sub2(q, p), sp / (sp - sq)))];
  });
}

function leastHidden(loop: readonly Vec2[]): Vec2 {
  const { low, high } = extent(loop);
  const step = scale2(sub2(high, low), 1 / GRID);
  let best: Vec2 = loop[0]!;
  let least = Infinity;
  for (let i = 0.5; i < GRID; i++) {
    for (let j = 0.5; j < GRID; j++) {
      const p: Vec2 = [low[0] + i * step[0], low[1] + j * step[1]];
      const amount = isInside(loop, p) ? hidden(loop, p) : Infinity;
      if (amount < least) [best, least] = [p, amount];
    }
  }
  return best;
}

function isInside(loop: readonly Vec2[], p: Vec2): boolean {
  return loop.reduce((inside, a, i) => {
    const b = loop[(i + 1) % loop.length]!;
    if (a[1] > p[1] === b[1] > p[1]) return inside;
    const x = a[0] + ((p[1] - a[1]) * (b[0] - a[0])) / (b[1] - a[1]);
    return x > p[0] ? !inside : inside;
  }, false);
}

function extent(loop: readonly Vec2[]): { readonly low: Vec2; readonly high: Vec2 } {
  const [xs, ys] = [loop.map((p) => p[0]), loop.map((p) => p[1])];
  return { low: [Math.min(...xs), Math.min(...ys)], high: [Math.max(...xs), Math.max(...ys)] };
}
