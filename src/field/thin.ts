/** Where a body is thinner than the cells that its mesh was made in, so that pieces of it may be missing: what meshes say of that. */
import type { Vec3 } from '../math/vec.ts';
import { BRICK, type Lattice } from './lattice.ts';
import { type Surface, type ThinSpot, thinWalls } from './thinWalls.ts';

/** Of one mesh. */
export interface Thin {
  /** what is a brick or more from the next is another place */
  readonly places: number;
  /** mm: how thick the body is where it is thinnest, as far as the cells tell */
  readonly least: number;
  /** where that is, mm */
  readonly at: Vec3;
  /** mm, the edge of a cell */
  readonly cell: number;
}

/** `unseen`: what lies between the corners of the lattice (unseen.ts). Null where nothing is thinner than a cell. */
export function thinOf(surface: Surface, lattice: Lattice, unseen: readonly ThinSpot[] = []): Thin | null {
  const spots = [...thinWalls(surface, lattice), ...unseen];
  if (spots.length === 0) return null;
  const { at, thickness } = spots.reduce((a, b) => (b.thickness < a.thickness ? b : a));
  return { places: placesOf(spots, lattice), least: thickness, at, cell: lattice.step };
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
