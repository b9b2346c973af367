/** Where a body is thinner than the cells that its mesh was made in, or nearer to itself, so that pieces of it may be missing or gaps closed: what meshes say of that. */
import type { Vec3 } from '../math/vec.ts';
import type { Surface } from './chords.ts';
import { BRICK, type Lattice } from './lattice.ts';
import type { Sided } from './local.ts';
import { type ThinSpot, thinWalls } from './thinWalls.ts';

/** Of one mesh. */
export interface Thin {
  /** what is a brick or more from the next is another place */
  readonly places: number;
  /** mm: how thick the body is where it is thinnest, as far as the cells tell; where there are only gaps, how wide the narrowest is */
  readonly least: number;
  /** where that is, mm */
  readonly at: Vec3;
  /** mm, the edge of a cell */
  readonly cell: number;
  /** times as many cells show all of it */
  readonly finer: number;
  /** of the places, those where the body is not thin but near to itself: gaps that may have closed */
  readonly gaps: number;
}

/** `unseen`: what lies between the corners of the lattice (unseen.ts). Null where nothing is thinner than a cell or two. */
export function thinOf(
  surface: Surface,
  lattice: Lattice,
  field: Sided,
  unseen: readonly ThinSpot[] = [],
): Thin | null {
  const spots = [...thinWalls(surface, lattice, field), ...unseen];
  if (spots.length === 0) return null;
  const walls = spots.filter(({ isGap }) => !isGap);
  const gaps = spots.filter(({ isGap }) => isGap);
  const told = walls.length > 0 ? walls : gaps;
  const { at, thickness } = told.reduce((a, b) => (b.thickness < a.thickness ? b : a));
  const finer = told.reduce((most, spot) => Math.max(most, (spot.across * lattice.step) / spot.thickness), 0);
  const [ofWalls, ofGaps] = [placesOf(walls, lattice), placesOf(gaps, lattice)];
  return { places: ofWalls + ofGaps, gaps: ofGaps, least: thickness, at, cell: lattice.step, finer };
}

/** Groups of bricks that touch each other. */
function placesOf(spots: readonly ThinSpot[], { origin, step, counts }: Lattice): number {
  const brick = (at: Vec3, axis: 0 | 1 | 2) => Math.floor((at[axis] - origin[axis]) / (BRICK * step));
  const [nx, ny] = counts;
  const open = new Set(spots.map(({ at }) => brick(at, 0) + nx * (brick(at, 1) + ny * brick(at, 2))));
  const around = [-1, 0, 1].flatMap((k) =>
    [-1, 0, 1].flatMap((j) => [-1, 0, 1].map((i) => i + nx * (j + ny * k))),
  );
  let places = 0;
  for (const first of open) {
    places++;
    const group = [first];
    for (let at = group.pop(); at !== undefined; at = group.pop()) {
      open.delete(at);
      for (const by of around) if (open.has(at + by)) group.push(at + by);
    }
  }
  return places;
}
