/** Closed outlines as fine polygons, and how often these go round a place. */
import { expect } from 'vitest';
import { cross2, distance2, sub2 } from '../../src/math/tuple.ts';
import type { Vec2 } from '../../src/math/vec.ts';
import type { Outline } from '../../src/surface/outline.ts';

/** Of so many chords, those between its corners aside. */
export function polygonOf({ point, corners }: Outline, chords = 512): Vec2[] {
  const vs = [...Array.from({ length: chords }, (_, i) => i / chords), ...corners].sort((a, b) => a - b);
  return vs.map(point);
}

/** How often the polygon goes round p clockwise. */
export function windingOf(polygon: readonly Vec2[], p: Vec2): number {
  let winding = 0;
  polygon.forEach((b, i) => {
    const a = polygon.at(i - 1)!;
    if (a[1] <= p[1] === b[1] <= p[1]) return;
    const left = cross2(sub2(b, a), sub2(p, a)) > 0;
    if (left === b[1] > a[1]) winding += b[1] > a[1] ? -1 : 1;
  });
  return winding;
}

function nearest(polygon: readonly Vec2[], p: Vec2): number {
  return Math.min(...polygon.map((q) => distance2(p, q)));
}

/** half chords: as near to the line webs and slivers may be */
const NEAR = 0.02;

export function expectOdd(
  found: Outline,
  drawn: readonly Vec2[],
  places: readonly Vec2[],
  chords = 512,
): void {
  const polygon = polygonOf(found, chords);
  for (const p of places) {
    if (nearest(drawn, p) < NEAR) continue;
    expect(windingOf(polygon, p)).toBe(Math.abs(windingOf(drawn, p)) % 2);
  }
}

/** in half chords, beside whole numbers */
export const grid = Array.from(
  { length: 900 },
  (_, i): Vec2 => [-3 + (6 * ((i % 30) + 0.37)) / 30, -3 + (6 * (Math.floor(i / 30) + 0.41)) / 30],
);
