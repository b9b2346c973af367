/**
 * Where a mesh is thinner than the cells that it was made in, or parts of it are nearer to each other: chords (chords.ts) whose ends lie against
 * each other. With points p, q and normals m, n the thickness there is 2 (q − p)·(n − m) / |n − m|², exact for plates, cylinders and
 * balls, however the line passes through them, and below 0 for gaps.
 *
 * Tried: the distance along the line times the normal's part along it, which takes caps of balls for thin places.
 */
import { length3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { BAR, Bars } from './bars.ts';
import { type Chord, eachChord, type Surface } from './chords.ts';
import type { Lattice } from './lattice.ts';
import type { Sided } from './local.ts';

/** A place, and how thick the body is there, mm. */
export interface ThinSpot {
  readonly at: Vec3;
  /** of a gap its width */
  readonly thickness: number;
  /** of which cells it takes so many across */
  readonly across: number;
  readonly isGap: boolean;
}

/** Cells: needles of less than √2 fall into pieces, plates of less than 1. */
export const THIN = 1.5;
/** Cells: slits of less close here and there. */
const NARROW = 1;
/** cells: crevices that go deeper are gaps */
const DEEP = 8;
/** cosine between the normals of both sides: of edges of more than 37° lines cut off next to nothing */
const OPPOSITE = -0.8;

/** `surface`: vertices of a mesh of `field` that was made on `lattice`. */
export function thinWalls(surface: Surface, lattice: Lattice, field: Sided): ThinSpot[] {
  const spots: ThinSpot[] = [];
  const [walls, gaps] = [false, true].map((isGap) => new Bars(surface, lattice, field, isGap)) as [
    Bars,
    Bars,
  ];
  eachChord(surface, lattice, (chord) => {
    const { p, q, isGap } = chord;
    const { thickness, cosine } = between(surface, p, q, isGap);
    const bars = isGap ? gaps : walls;
    if (!(thickness > 0 && thickness < BAR * lattice.step)) return;
    bars.add(chord, thickness);
    const across = isGap ? NARROW : THIN;
    const isThin = cosine < OPPOSITE && thickness < across * lattice.step;
    if (isThin && !(isGap && isCrevice(surface, chord, thickness, lattice.step, field)))
      spots.push({ at: middleOf(surface, p, q), thickness, across, isGap });
  });
  return [...spots, ...walls.spots(), ...gaps.spots()];
}

/** Of vertices p and q; the cosine is −1 where they lie against each other. */
export function between({ positions, normals }: Surface, p: number, q: number, isGap: boolean) {
  let [along, apart2, cosine] = [0, 0, 0];
  for (let axis = 0; axis < 3; axis++) {
    const [m, n] = [normals[3 * p + axis]!, normals[3 * q + axis]!];
    along += (positions[3 * q + axis]! - positions[3 * p + axis]!) * (n - m);
    apart2 += (n - m) * (n - m);
    cosine += m * n;
  }
  return { thickness: ((isGap ? -2 : 2) * along) / apart2, cosine };
}

/**
 * Whether a gap ends soon, as between balls that touch: with α the angle of its sides it does within 2/α of its width, be they flat or round.
 */
function isCrevice(surface: Surface, { p, q }: Chord, width: number, step: number, field: Sided): boolean {
  const { normals } = surface;
  const sum = (axis: 0 | 1 | 2) => normals[3 * p + axis]! + normals[3 * q + axis]!;
  const open: Vec3 = [sum(0), sum(1), sum(2)];
  // of unit vectors, nearly against each other, α
  const angle = length3(open);
  const reach = (2 * width) / angle;
  if (!(reach < DEEP * step)) return false;
  return field.value(...sub3(middleOf(surface, p, q), scale3(open, reach / angle))) > 0;
}

/** Of two of which nothing but their places and normals is known; null where they do not lie against each other. */
export function wallBetween(surface: Surface): ThinSpot | null {
  const { thickness, cosine } = between(surface, 0, 1, false);
  return cosine < OPPOSITE ? { at: middleOf(surface, 0, 1), thickness, across: THIN, isGap: false } : null;
}

function middleOf({ positions }: Surface, p: number, q: number): Vec3 {
  const middle = (axis: 0 | 1 | 2) => (positions[3 * p + axis]! + positions[3 * q + axis]!) / 2;
  return [middle(0), middle(1), middle(2)];
}
