/**
 * Where two strokes cross: chords of both are intersected, then Newton's method on l(a) = r(b) makes the
 * crossing exact. Strokes that only touch, or run on each other, do not cross.
 */
import { cross2, distance2, length2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Side } from './side.ts';

/** Parameters of one place on both sides. */
export interface Match {
  readonly a: number;
  readonly b: number;
}

/** chords a side; two crossings nearer than a chord may be missed */
const CHORDS = 128;
/** crossings nearer than this in both parameters are one (found by two neighbouring chords) */
const SAME = 1e-6;
/** what Newton may leave between the two points, in lengths of the shorter stroke; the estimate of chords is 1e-3 */
const RESIDUAL = 1e-4;

/** All proper crossings, ascending in a. */
export function crossings(l: Side, r: Side): Match[] {
  const left = chords(l);
  const right = chords(r);
  const scale = Math.min(l.length, r.length);
  const found: Match[] = [];
  for (const p of left) {
    for (const q of right) {
      const rough = intersect(p, q);
      if (!rough) continue;
      const refined = refine(l, r, rough);
      const fine = { a: ontoCorner(l, refined.a), b: ontoCorner(r, refined.b) };
      const residual = distance2(l.point(fine.a), r.point(fine.b));
      const known = found.some(({ a, b }) => Math.abs(a - fine.a) < SAME && Math.abs(b - fine.b) < SAME);
      if (residual <= RESIDUAL * scale && !known) found.push(fine);
    }
  }
  return found.sort((x, y) => x.a - y.a);
}

interface Chord {
  readonly u0: number;
  readonly u1: number;
  readonly p: Vec2;
  readonly q: Vec2;
}

/** Chords between even parameters and the corners, so that straight pieces are exact. */
function chords(side: Side): Chord[] {
  const us = [...Array.from({ length: CHORDS + 1 }, (_, i) => i / CHORDS), ...side.corners].sort(
    (a, b) => a - b,
  );
  const points = us.map((u) => side.point(u));
  return us.slice(1).map((u1, i) => ({ u0: us[i]!, u1, p: points[i]!, q: points[i + 1]! }));
}

function intersect(c: Chord, d: Chord): Match | null {
  if (apart(c, d, 0) || apart(c, d, 1)) return null;
  const e = sub2(c.q, c.p);
  const f = sub2(d.q, d.p);
  const between = sub2(d.p, c.p);
  const area = cross2(e, f);
  // parallel to within rounding: on each other at best
  if (Math.abs(area) <= 1e-12 * length2(e) * length2(f)) return null;
  const s = cross2(between, f) / area;
  const t = cross2(between, e) / area;
  if (s < 0 || s > 1 || t < 0 || t > 1) return null;
  return { a: c.u0 + s * (c.u1 - c.u0), b: d.u0 + t * (d.u1 - d.u0) };
}

function apart(c: Chord, d: Chord, axis: 0 | 1): boolean {
  return (
    Math.max(c.p[axis], c.q[axis]) < Math.min(d.p[axis], d.q[axis]) ||
    Math.max(d.p[axis], d.q[axis]) < Math.min(c.p[axis], c.q[axis])
  );
}

/** Newton in both parameters; the best place seen is kept, for corners may throw it about. */
function refine(l: Side, r: Side, start: Match): Match {
  let { a, b } = start;
  let best = start;
  let least = distance2(l.point(a), r.point(b));
  for (let step = 0; step < 12 && least > 0; step++) {
    const gap = sub2(r.point(b), l.point(a));
    const e = l.derivative(a, 1);
    const f = r.derivative(b, 1);
    const area = cross2(e, f);
    if (area === 0) break;
    a = clamp(a + cross2(gap, f) / area);
    b = clamp(b + cross2(gap, e) / area);
    const residual = distance2(l.point(a), r.point(b));
    if (!(residual < least)) break;
    least = residual;
    best = { a, b };
  }
  return best;
}

/** A crossing in a corner is at the corner's own u, so that they are one stop and not two a rounding apart. */
function ontoCorner(side: Side, u: number): number {
  return side.corners.find((corner) => Math.abs(corner - u) < SAME) ?? u;
}

function clamp(u: number): number {
  return Math.min(Math.max(u, 0), 1);
}
