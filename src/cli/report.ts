/** What of a drawing is left out, and what is in it. */

import { type BodyCounts, countsOfPart, sumOf } from '../document/bodyCounts.ts';
import {
  type Document,
  formOfDraft,
  isImplicit,
  isSurface,
  type Part,
  strokesOf,
} from '../document/document.ts';
import { nodeOf } from '../document/solidNode.ts';
import { strokesOfForm } from '../document/surfacePart.ts';
import { bindField } from '../field/bind.ts';
import { PAGE } from '../field/polygonize.ts';

/** Components, groups and skels are those of bodies. */
export interface Counts extends BodyCounts {
  /** kept, hidden ones too */
  readonly parts: number;
  /** of all parts and of the unfinished form */
  readonly strokes: number;
}

export function countsOf({ parts, draft }: Document): Counts {
  // strokes in hand are those of a part
  const own = parts.filter(({ id }) => id !== draft?.recreates?.part);
  const inParts = own.reduce((sum, part) => sum + strokesOf(part).length, 0);
  const strokes = inParts + (draft ? strokesOfForm(formOfDraft(draft)).length : 0);
  const bodies = parts.filter(isImplicit).map(countsOfPart);
  return { parts: parts.length, strokes, ...sumOf(bodies) };
}

/** What neither meshes nor pictures show. */
export function leftOut({ parts, draft }: Document): string[] {
  const warnings: string[] = [];
  if (draft) {
    const count = strokesOfForm(formOfDraft(draft)).length;
    warnings.push(`the unfinished form (${count} ${count === 1 ? 'stroke' : 'strokes'}) is left out`);
  }
  const hidden = parts.filter(({ hidden }) => hidden);
  if (hidden.length > 0) warnings.push(`${counted(hidden, 'hidden part')} left out: ${namesOf(hidden)}`);
  return warnings;
}

/** Bodies that are shown only as far as a page reaches. */
export function withoutEnd({ parts }: Document): string[] {
  const endless = parts.filter(
    (part) => isImplicit(part) && !part.hidden && bindField(nodeOf(part)).box === null,
  );
  if (endless.length === 0) return [];
  return [`${counted(endless, 'part')} without end and cut off at ±${PAGE} mm: ${namesOf(endless)}`];
}

/** Parts that are shown but have no surface. */
export function withoutSurface(parts: readonly Part[]): string[] {
  const bodies = parts.filter(isImplicit);
  const surfaces = parts.filter(isSurface);
  const left = (some: readonly Part[], why: string) =>
    some.length > 0 ? [`${counted(some, 'part')} left out, because ${why}: ${namesOf(some)}`] : [];
  return [...left(surfaces, 'the strokes make no surface'), ...left(bodies, NOWHERE)];
}

/** Why there is nothing at all. */
export function nothingBecause({ parts, draft }: Document): string {
  if (parts.length === 0) {
    return draft ? 'the drawing holds an unfinished form only; keep it first' : 'the drawing has no parts';
  }
  if (parts.every(({ hidden }) => hidden)) return 'all parts are hidden';
  return parts.some(isImplicit) ? 'its parts make no surface' : 'the strokes of its parts make no surface';
}

const NOWHERE = 'the field is nowhere above 0, or only where no cell sees it';

export const counted = (parts: readonly unknown[], what: string): string =>
  parts.length === 1 ? `1 ${what} is` : `${parts.length} ${what}s are`;

const MOST_NAMES = 5;

export function namesOf(parts: readonly Pick<Part, 'name'>[]): string {
  const names = parts.slice(0, MOST_NAMES).map(({ name }) => `“${name}”`);
  const more = parts.length - names.length;
  return names.join(', ') + (more > 0 ? ` and ${more} more` : '');
}
