/**
 * Where a section can be drawn: across a form between its two construction curves, at the u that the surface itself uses (thesis 5.4.1,
 * fig. 5.10), or across a tube from edge to edge, square to its stroke and as wide as it is there. The chord is straight; the half below
 * it, or on the right-hand side of q_l to q_r, is convex (surface/chordWay.ts).
 */
import { curveOfStroke } from '../document/curves.ts';
import { type Brush, type Document, isSurface, readingOf, type SurfacePart } from '../document/document.ts';
import { pairOf } from '../document/pairs.ts';
import { placedStroke } from '../document/placedStroke.ts';
import { type Back, nearestSection, type Section } from '../document/surfacePart.ts';
import { type Placement, UNMOVED } from '../math/placement.ts';
import { distance2, dot2, mix2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import { isInside } from '../skeleton/medial/outline.ts';
import { project, toWorld } from '../stroke/plane.ts';
import type { Plane, Stroke } from '../stroke/stroke.ts';
import { type Source, sourceOf } from '../surface/source.ts';
import { isEdgeOn } from './penStroke.ts';
import { type Nearest, nearestOn, PIECES, rememberedBy, type SeenPoints } from './seenCurve.ts';
import type { Bench, Pen } from './tool.ts';
import type { Viewport } from './viewport.ts';

/** px from a construction curve in which it is meant */
export const REACH = 24;
/** px along a construction curve from a section without a back in which that is meant */
const BACK_REACH = 48;
/** px: across less nothing can be drawn */
const LEAST_CHORD = 12;

/** The ends of the chord at every u, mm on the plane. */
export interface Chords {
  at(u: number, side: -1 | 1): { readonly left: Vec2; readonly right: Vec2 };
  /** u = 1 is u = 0 */
  readonly closed: boolean;
  /** of a tube: what was drawn lies in the middle, and is meant as much as its edges are */
  readonly isTube?: true;
}

/** What sections can be drawn across. */
export interface Across {
  /** id; without one the unfinished form */
  readonly part?: string;
  /** where that was moved to */
  readonly placement: Placement;
  /** of its strokes, in its own space and in the world */
  readonly own: Plane;
  readonly plane: Plane;
  readonly pair: Chords;
  readonly sections: readonly Section[];
  readonly back: Back;
}

export type NotAcross = 'no-sides' | 'edge-on' | 'bent';

export type SideName = 'left' | 'right';

/** One chord of it. */
export interface Guide {
  readonly across: Across;
  readonly u: number;
  /** q_l(u), q_r(u), mm on the plane */
  readonly left: Vec2;
  readonly right: Vec2;
  /** the curve that the pen is near */
  readonly near: SideName;
  /** what a stroke there would be: a back belongs to the section at u */
  readonly side: 'front' | 'back';
}

/** The unfinished form, else the selected part, else the last that has two sides, else the last tube; or why there is none. */
export function acrossOf({
  document,
  selection,
  viewport,
}: Pick<Bench, 'document' | 'selection' | 'viewport'>): Across | NotAcross {
  const found = document.draft ? ofDraft(document) : ofParts(document, selection);
  if (typeof found === 'string') return found;
  return isEdgeOn(found.plane, viewport.view) ? 'edge-on' : found;
}

function ofDraft(document: Document): Across | NotAcross {
  const { draft, brush } = document;
  const pair = readingOf(document) === 'solid' ? null : chordsOf(draft!.strokes, brush);
  if (!pair) return 'no-sides';
  const { plane } = draft!.strokes[0]!;
  const { sections = [], back = 'none' } = draft!;
  return { placement: UNMOVED, own: plane, plane, pair, sections, back };
}

function ofParts({ parts }: Document, selection: readonly string[]): Across | NotAcross {
  const seen = parts.filter(isSurface).filter(({ hidden }) => !hidden);
  const sided = seen.filter(({ strokes }) => strokes.length === 2);
  const chosen = seen.filter(({ id }) => selection.includes(id)).at(-1) ?? sided.at(-1) ?? seen.at(-1);
  if (!chosen) return 'no-sides';
  // the strokes are where the form was before it was bent
  return chosen.bends.some(({ isOff }) => !isOff) ? 'bent' : (ofPart(chosen) ?? 'no-sides');
}

function ofPart({ id, placement, strokes, brush, sections, back }: SurfacePart): Across | null {
  const pair = chordsOf(strokes, brush);
  const own = strokes[0]!.plane;
  const { plane } = placedStroke(strokes[0]!, placement);
  return pair && { part: id, placement, own, plane, pair, sections, back };
}

/** Between two strokes, or over one; null: they are too short, or too many. */
function chordsOf(strokes: readonly Stroke[], brush: Brush): Chords | null {
  if (strokes.length !== 1) return pairOf(strokes, brush);
  const curve = curveOfStroke(strokes[0]!, brush);
  const { radius, pressure } = brush;
  const source = curve && curve.length > 0 ? sourceOf({ curves: [curve], radius, pressure }) : null;
  if (!source) return null;
  const known = tubes.get(source) ?? { closed: source.closed, at: source.stand, isTube: true };
  tubes.set(source, known);
  return known;
}

const tubes = new WeakMap<Source, Chords>();

/** The chord at the construction curve that is near the pen; null: none is, or nothing is between them there. */
export function guideAt(
  across: Across,
  pen: Pick<Pen, 'x' | 'y'>,
  viewport: Viewport,
  least = LEAST_CHORD,
): Guide | null {
  const at: Vec2 = [pen.x, pen.y];
  const [left, right] = (['left', 'right'] as const).map((side) => nearestSide(across, side, at, viewport));
  const [near, found] =
    left!.distance <= right!.distance ? ['left' as const, left!] : ['right' as const, right!];
  const place = found.distance <= REACH || !across.pair.isTube ? found : nearestMiddle(across, at, viewport);
  if (!(place.distance <= REACH)) return null;
  const guide = guideThrough(across, place.u, near, viewport);
  const [a, b] = endsOf(guide, viewport);
  return a && b && distance2(a, b) >= least ? guide : null;
}

/** Within reach of a section that lacks its back it is that; anywhere else a section of its own. */
function guideThrough(across: Across, u: number, near: SideName, viewport: Viewport): Guide {
  const section = across.sections[nearestSection(across.sections, u, across.pair.closed)];
  const isBack = section && lacksBack(across, section) && isBeside(across, [u, section.u], near, viewport);
  const place = isBack ? section.u : u;
  const { left, right } = across.pair.at(place, 1);
  return { across, u: place, left, right, near, side: isBack ? 'back' : 'front' };
}

/** Sections whose backs are still to be drawn. */
export const lackingBacks = (across: Pick<Across, 'sections' | 'back'>): readonly Section[] =>
  across.sections.filter((section) => lacksBack(across, section));

const lacksBack = ({ back: of }: Pick<Across, 'back'>, { front, back }: Section): boolean =>
  of === 'drawn' && front !== null && back === null;

function isBeside(
  across: Across,
  [a, b]: readonly [number, number],
  near: SideName,
  { view, size }: Viewport,
): boolean {
  const [p, q] = [a, b].map((u) => project(view, size, toWorld(across.plane, across.pair.at(u, 1)[near])));
  return Boolean(p && q && distance2(p, q) <= BACK_REACH);
}

/** Taken hold of at the end that is nearer to the pen. */
export function turned(guide: Guide, pen: Pick<Pen, 'x' | 'y'>, viewport: Viewport): Guide {
  const other = guide.near === 'left' ? 'right' : 'left';
  return progressOf(guide, pen, viewport) > 0.5 ? { ...guide, near: other } : guide;
}

/** q_l(u) and q_r(u), px; null: behind the camera */
export function endsOf(
  { across: { plane }, left, right }: Guide,
  { view, size }: Viewport,
): readonly [Vec2 | null, Vec2 | null] {
  return [project(view, size, toWorld(plane, left)), project(view, size, toWorld(plane, right))];
}

/** From the curve where the pen was near, 0, to the other one, 1, along the chord. */
export function progressOf(guide: Guide, { x, y }: Pick<Pen, 'x' | 'y'>, viewport: Viewport): number {
  const [left, right] = endsOf(guide, viewport);
  if (!left || !right) return 0;
  const [from, to] = guide.near === 'left' ? [left, right] : [right, left];
  const chord = sub2(to, from);
  return dot2(sub2([x, y], from), chord) / dot2(chord, chord);
}

/** px from the curve on the other side */
export function distanceToOther(
  { across, near }: Guide,
  { x, y }: Pick<Pen, 'x' | 'y'>,
  viewport: Viewport,
): number {
  return nearestSide(across, near === 'left' ? 'right' : 'left', [x, y], viewport).distance;
}

/** Between the curves, or within reach of one. */
export function isWithin(across: Across, { x, y }: Pick<Pen, 'x' | 'y'>, viewport: Viewport): boolean {
  const at: Vec2 = [x, y];
  const sides = (['left', 'right'] as const).map((side) => nearestSide(across, side, at, viewport).distance);
  if (Math.min(...sides) <= REACH) return true;
  const { left, right } = seenSides(across, viewport);
  const there = (points: readonly (Vec2 | null)[]) => points.filter((p) => p !== null);
  return isInside(at, [[...there(left), ...there(right).reverse()]]);
}

const nearestSide = (across: Across, side: SideName, at: Vec2, viewport: Viewport): Nearest =>
  nearestOn(seenSides(across, viewport)[side], at);

function nearestMiddle(across: Across, at: Vec2, viewport: Viewport): Nearest {
  const { left, right } = seenSides(across, viewport);
  const middle = left.map((p, i) => {
    const q = right[i];
    return p && q ? mix2(p, q, 0.5) : null;
  });
  return nearestOn(middle, at);
}

type Sides = Readonly<Record<SideName, SeenPoints>>;

/** By the pair, on one plane in one view. */
const sidesOf = rememberedBy<Chords, Sides>();

function seenSides({ pair, plane }: Across, { view, size }: Viewport): Sides {
  return sidesOf(pair, [plane, view, size], () => {
    const chords = Array.from({ length: PIECES + 1 }, (_, i) => pair.at(i / PIECES, 1));
    const pixel = (p: Vec2) => project(view, size, toWorld(plane, p));
    return {
      left: chords.map(({ left }) => pixel(left)),
      right: chords.map(({ right }) => pixel(right)),
    };
  });
}
