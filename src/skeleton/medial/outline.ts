/** Outlines of regions: loops of places, the last joined to the first. */
import { dot2, length2, sub2 } from '../../math/tuple.ts';
import type { Vec2 } from '../../math/vec.ts';

/** mm, at least three places, none repeated */
export type Loop = readonly Vec2[];

/** mm from the nearest edge. */
export function distanceTo(p: Vec2, loops: readonly Loop[]): number {
  let least = Infinity;
  for (const loop of loops) {
    for (let i = 0; i < loop.length; i++) {
      const a = loop[i === 0 ? loop.length - 1 : i - 1]!;
      const e = sub2(loop[i]!, a);
      const d = sub2(p, a);
      const t = Math.min(Math.max(dot2(d, e) / (dot2(e, e) || 1), 0), 1);
      least = Math.min(least, square(d[0] - t * e[0]) + square(d[1] - t * e[1]));
    }
  }
  return Math.sqrt(least);
}

/** Inside an odd number of loops. */
export function isInside([x, y]: Vec2, loops: readonly Loop[]): boolean {
  let inside = false;
  for (const loop of loops) {
    for (let i = 0; i < loop.length; i++) {
      const a = loop[i === 0 ? loop.length - 1 : i - 1]!;
      const b = loop[i]!;
      if (a[1] > y === b[1] > y) continue;
      if (x < a[0] + ((y - a[1]) / (b[1] - a[1])) * (b[0] - a[0])) inside = !inside;
    }
  }
  return inside;
}

/** Places along the loops, no further apart than `step` mm, their corners among them. */
export function along(loops: readonly Loop[], step: number): Vec2[] {
  return loops.flatMap((loop) =>
    loop.flatMap((b, i) => {
      const a = loop.at(i - 1)!;
      const e = sub2(b, a);
      const pieces = Math.max(1, Math.ceil(length2(e) / step));
      return Array.from({ length: pieces }, (_, k): Vec2 => {
        const t = (k + 1) / pieces;
        return [a[0] + t * e[0], a[1] + t * e[1]];
      });
    }),
  );
}

const square = (x: number): number => x * x;
