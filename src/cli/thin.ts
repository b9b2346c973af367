/** What `rotund mesh` says of bodies that are thinner than their cells. */
import { cellsOfBodies, wanting } from '../document/cells.ts';
import { type Document, isImplicit, type Part } from '../document/document.ts';
import { nodeOf } from '../document/solidNode.ts';
import { RESOLUTION } from '../field/lattice.ts';
import { place3 } from '../math/placement.ts';
import type { Vec3 } from '../math/vec.ts';
import type { MadeBody } from './bodyMaker.ts';
import { counted, namesOf } from './report.ts';

/** In the JSON. */
export interface ThinPlaces {
  readonly places: number;
  /** those of the places where the body is too near to itself */
  readonly gaps: number;
  /** mm; the narrowest gap where there is nothing else */
  readonly least: number;
  /** mm, where the part was moved to */
  readonly at: Vec3;
  /** for --resolution, to show all of it; null: the most cells there are show it no better */
  readonly resolution: number | null;
}

export interface MadePart {
  readonly backend: MadeBody['backend'];
  /** along the longest side; null: made from strokes */
  readonly cells: number | null;
  readonly thin: ThinPlaces | null;
}

/** resolutions are multiples of it */
const ROUND = 8;

export function thinBody(document: Document, part: Part, body: MadeBody | null): MadePart {
  if (!isImplicit(part) || !body) return { backend: 'cpu', cells: null, thin: null };
  const { backend, cells, mesh } = body;
  const { thin } = mesh;
  if (!thin) return { backend, cells, thin: null };
  const share = cellsOfBodies(document, RESOLUTION.max)(nodeOf(part)) / RESOLUTION.max;
  const enough = ROUND * Math.ceil((cells * wanting(thin)) / share / ROUND);
  const { places, gaps, least, at } = thin;
  const resolution = enough <= RESOLUTION.max ? enough : null;
  return { backend, cells, thin: { places, gaps, least, at: place3(part.placement, at), resolution } };
}

/** What made any of the bodies, and where any is thin. */
export function allMade(parts: readonly MadePart[]): Pick<MadePart, 'backend' | 'thin'> {
  const backend = parts.some((part) => part.backend === 'webgpu') ? 'webgpu' : 'cpu';
  return { backend, thin: thinTotal(parts) };
}

/** Of all parts together. */
function thinTotal(parts: readonly MadePart[]): ThinPlaces | null {
  const found = parts.map(({ thin }) => thin).filter((thin) => thin !== null);
  if (found.length === 0) return null;
  const walls = found.filter(({ places, gaps }) => places > gaps);
  const { least, at } = (walls.length > 0 ? walls : found).reduce((a, b) => (b.least < a.least ? b : a));
  const needed = found.map(({ resolution }) => resolution);
  return {
    places: found.reduce((sum, { places }) => sum + places, 0),
    gaps: found.reduce((sum, { gaps }) => sum + gaps, 0),
    least,
    at,
    resolution: needed.includes(null) ? null : Math.max(...needed.map(Number)),
  };
}

type Named = MadePart & { readonly name: string };

/** In words: what may lack pieces, and where gaps may have closed. */
export function thinParts(parts: readonly Named[]): string[] {
  const isThin = ({ thin }: Named) => thin !== null && thin.places > thin.gaps;
  const thin = parts.filter(isThin);
  const near = parts.filter(({ thin }) => thin !== null && thin.gaps > 0);
  return [
    ...told(thin, ({ places, gaps, least }) => {
      const where = `${counts(places - gaps)}, ${Number(least.toPrecision(2))} mm at the thinnest`;
      return `hardly thicker than a cell or two in ${where}, so that pieces may be missing`;
    }),
    ...told(
      near,
      ({ gaps }) => `gaps of a cell or less, which may have closed, in ${counts(gaps)}`,
      // bodies that nearly touch are nearer to each other than any cell sees
      (resolution) =>
        `${resolution ? `--resolution ${resolution} or more` : `not even --resolution ${RESOLUTION.max}`} tells more`,
    ),
  ];
}

function told(
  parts: readonly Named[],
  what: (whole: ThinPlaces) => string,
  helps: (resolution: number | null) => string = remedy,
): string[] {
  const whole = thinTotal(parts);
  return whole ? [`${what(whole)}: ${namesOf(parts)}; ${helps(whole.resolution)}`] : [];
}

const counts = (places: number): string => (places === 1 ? '1 place' : `${places} places`);

/** In words: parts that pass between the cells and have no mesh at all. */
export function lostParts(parts: readonly Named[]): string[] {
  const whole = thinTotal(parts);
  if (!whole) return [];
  return [
    `${counted(parts, 'part')} left out, because no cell is small enough for what is that thin: ${namesOf(parts)}; ${remedy(whole.resolution)}`,
  ];
}

const remedy = (resolution: number | null): string =>
  resolution === null
    ? `not even --resolution ${RESOLUTION.max} shows all of it`
    : `--resolution ${resolution} shows all of it`;
