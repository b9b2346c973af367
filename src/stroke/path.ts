/** A polyline measured by its length: the form in which strokes pass through the filter. */
import { mix2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';

/** A place on the plane, mm, and how hard the pen was pressed there (0–1). */
export interface Ink {
  readonly x: number;
  readonly y: number;
  readonly pressure: number;
}

export interface Path {
  /** a closed path does not repeat its first point */
  readonly points: readonly Ink[];
  readonly closed: boolean;
  /** mm from the start to each point; a closed path has one more, back at its start */
  readonly lengths: Float64Array;
  /** mm */
  readonly length: number;
}

export function pathOf(points: readonly Ink[], closed: boolean): Path {
  const lengths = new Float64Array(points.length + (closed ? 1 : 0));
  for (let i = 1; i < lengths.length; i++) {
    lengths[i] = lengths[i - 1]! + distance(points[i - 1]!, points[i % points.length]!);
  }
  return { points, closed, lengths, length: lengths[lengths.length - 1] ?? 0 };
}

/** The point at arc length s (mm): clamped on open paths, wrapped on closed ones. */
export function inkAt(path: Path, s: number): Ink {
  const { points, lengths, length } = path;
  const inside = path.closed && length > 0 ? s - Math.floor(s / length) * length : s;
  const i = segmentAt(path, inside);
  const a = points[i]!;
  if (i + 1 >= lengths.length) return a;
  const span = lengths[i + 1]! - lengths[i]!;
  const t = span > 0 ? Math.min(Math.max((inside - lengths[i]!) / span, 0), 1) : 0;
  return mixInk(a, points[(i + 1) % points.length]!, t);
}

/** The index of the segment that holds arc length s, by binary search. */
export function segmentAt(path: Path, s: number): number {
  let low = 0;
  let high = Math.max(path.lengths.length - 2, 0);
  while (low < high) {
    const middle = (low + high) >> 1;
    if (path.lengths[middle + 1]! > s) high = middle;
    else low = middle + 1;
  }
  return low;
}

/** The stretch from s0 to s1 (mm), ends included; on a closed path s1 may lie beyond the length, one turn at most. */
export function between(path: Path, s0: number, s1: number): Ink[] {
  const { points, lengths, length } = path;
  const stretch: Ink[] = [inkAt(path, s0)];
  const turns = path.closed ? 2 : 1;
  // a vertex nearer to an end than this is that end
  const same = 1e-9 * length;
  for (let turn = 0; turn < turns; turn++) {
    for (let i = 0; i < points.length; i++) {
      const s = lengths[i]! + turn * length;
      if (s > s0 + same && s < s1 - same) stretch.push(points[i]!);
    }
  }
  stretch.push(inkAt(path, path.closed && s1 === length ? 0 : s1));
  return stretch;
}

/** The same path drawn from its other end. */
export function reversed(path: Path): Path {
  return pathOf([...path.points].reverse(), path.closed);
}

export function mixInk(a: Ink, b: Ink, t: number): Ink {
  const [x, y] = mix2([a.x, a.y], [b.x, b.y], t);
  return { x, y, pressure: a.pressure * (1 - t) + b.pressure * t };
}

export function distance(a: Ink, b: Ink): number {
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  return Math.sqrt(dx * dx + dy * dy);
}

export function toVec(p: Ink): Vec2 {
  return [p.x, p.y];
}
