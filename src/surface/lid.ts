/**
 * Flat lids of any outline as rows of the grid, so that they are closed bit for bit and bend with their end.
 *
 * A fan, where all of the rim is seen from its centroid. Else ears are cut (Meisters 1975), as many at a time as have no
 * neighbour among them: in the next row an ear's tip lies on the corner after it, and the quads between collapse to the ear.
 * Where a rim crosses itself there may be no ear left; then the widest corner is cut all the same, and the lid stays closed.
 */
import { cross2, sub2 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import type { Row } from '../mesh/grid.ts';
import { disc } from './caps.ts';

/** `centre`: of a fan. `rounds`: for each row, at which entry of the rim each entry lies. */
export type Lid = { readonly centre: Vec2 } | { readonly rounds: readonly (readonly number[])[] };

/** area of a triangle that is none, as a part of the rim's */
const SLIVER = 1e-9;

/** both ends of a surface have one rim */
const known = new WeakMap<readonly Vec2[], Lid>();

/** How a rim is covered: its points as entries of a row, the last of which is the first. */
export function lidOf(points: readonly Vec2[]): Lid {
  const lid = known.get(points) ?? newLid(points);
  known.set(points, lid);
  return lid;
}

function newLid(points: readonly Vec2[]): Lid {
  const area = doubleArea(points);
  const centre = centroid(points);
  if (Math.abs(area) > 0 && isSeenFrom(centre, points, area)) return { centre };
  return { rounds: earRounds(points, area < 0 ? -1 : 1) };
}

/** Rows from the rim inward, the rim itself again first. `at`: of a fan's centre; `normal`: unit, of the lid. */
export function lidRows(lid: Lid, rim: Row, at: (p: Vec2) => Vec3, normal: Vec3): Row[] {
  if ('centre' in lid) return disc(rim, at(lid.centre), normal);
  const [start] = disc(rim, normal, normal);
  return [
    start!,
    ...lid.rounds.map((round) => ({ ...start!, points: gathered(rim.points, round), joined: true })),
  ];
}

function gathered(points: Float64Array, entries: readonly number[]): Float64Array {
  const out = new Float64Array(points.length);
  entries.forEach((from, j) => {
    out.set(points.subarray(3 * from, 3 * from + 3), 3 * j);
  });
  return out;
}

/** Twice the area, positive when counter-clockwise. */
function doubleArea(points: readonly Vec2[]): number {
  let sum = 0;
  for (let j = 1; j < points.length; j++) sum += cross2(points[j - 1]!, points[j]!);
  return sum;
}

/** Of the area; the mean of the points where there is none. */
export function centroid(points: readonly Vec2[]): Vec2 {
  const first = points[0]!;
  let [area, x, y] = [0, 0, 0];
  for (let j = 1; j < points.length; j++) {
    const [a, b] = [sub2(points[j - 1]!, first), sub2(points[j]!, first)];
    const part = cross2(a, b);
    area += part;
    x += (part * (a[0] + b[0])) / 3;
    y += (part * (a[1] + b[1])) / 3;
  }
  if (Math.abs(area) > 0) return [first[0] + x / area, first[1] + y / area];
  return [0, 1].map((k) => points.reduce((sum, p) => sum + p[k]!, 0) / points.length) as unknown as Vec2;
}

function isSeenFrom(centre: Vec2, points: readonly Vec2[], area: number): boolean {
  const least = SLIVER * Math.abs(area);
  return points.every((q, j) => {
    const p = points[j - 1] ?? q;
    return isSame(p, q) || cross2(sub2(p, centre), sub2(q, centre)) * Math.sign(area) > least;
  });
}

function earRounds(points: readonly Vec2[], sense: 1 | -1): number[][] {
  // entries in one place (creases, the seam) are one corner
  let ring = points.flatMap((p, j) => (isSame(p, points[j - 1] ?? points.at(-1)!) ? [] : [j]));
  const at = cornersOf(points, ring);
  const least = SLIVER * Math.abs(doubleArea(points));
  const rounds: number[][] = [];
  while (ring.length > 2) {
    const ears = earsOf(points, ring, sense, least);
    const moved = new Map(ears.map((i) => [ring[i]!, ring[(i + 1) % ring.length]!]));
    for (let j = 0; j < at.length; j++) at[j] = moved.get(at[j]!) ?? at[j]!;
    rounds.push([...at]);
    ring = ring.filter((corner) => !moved.has(corner));
  }
  return rounds;
}

/** The corner of the ring in whose place each entry is. */
function cornersOf(points: readonly Vec2[], ring: readonly number[]): number[] {
  let corner = ring[ring.length - 1] ?? 0;
  const starts = new Set(ring);
  return points.map((_, j) => {
    if (starts.has(j)) corner = j;
    return corner;
  });
}

/** Places in the ring of ears that are no neighbours; at least one. */
function earsOf(points: readonly Vec2[], ring: readonly number[], sense: 1 | -1, least: number): number[] {
  const n = ring.length;
  if (n === 3) return [1];
  const corner = (i: number): Vec2 => points[ring[(i + n) % n]!]!;
  const areas = ring.map(
    (_, i) => sense * cross2(sub2(corner(i), corner(i - 1)), sub2(corner(i + 1), corner(i))),
  );
  // what reaches into an ear does so with a hollow corner
  const hollow = ring.filter((_, i) => areas[i]! < 0).map((entry) => points[entry]!);
  const found: number[] = [];
  for (let i = 0; i < n; i++) {
    const isNext = found.at(-1) === i - 1 || (i === n - 1 && found[0] === 0);
    if ((isNext && found.length > 0) || !(areas[i]! > least)) continue;
    const [p, q, r] = [corner(i - 1), corner(i), corner(i + 1)];
    if (hollow.every((at) => !covers(p, q, r, sense, at))) found.push(i);
  }
  return found.length > 0 ? found : [areas.indexOf(Math.max(...areas))];
}

/** Whether a triangle holds a point that is none of its corners; on the edge p r counts. */
function covers(p: Vec2, q: Vec2, r: Vec2, sense: 1 | -1, at: Vec2): boolean {
  if (isSame(at, p) || isSame(at, q) || isSame(at, r)) return false;
  return (
    sense * cross2(sub2(q, p), sub2(at, p)) > 0 &&
    sense * cross2(sub2(r, q), sub2(at, q)) > 0 &&
    sense * cross2(sub2(p, r), sub2(at, r)) >= 0
  );
}

function isSame(a: Vec2, b: Vec2): boolean {
  return a[0] === b[0] && a[1] === b[1];
}
