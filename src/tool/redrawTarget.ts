/** What would be drawn over, by where the pen is: a construction curve that is seen as it was drawn, else the section under the pen. */
import type { Whose } from '../document/command/changeForm.ts';
import { curveOfStroke } from '../document/curves.ts';
import { type Document, formOfDraft, isSurface, readingOf, type SurfacePart } from '../document/document.ts';
import { placedStroke } from '../document/placedStroke.ts';
import {
  type SectionLoop,
  type Seen,
  sectionLoop,
  sectionSeenAt,
  sectionThrough,
} from '../document/sectionLoops.ts';
import { isRing, nearestSection } from '../document/surfacePart.ts';
import { UNMOVED } from '../math/placement.ts';
import { cross3, dot3, rotate3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { project, toWorld } from '../stroke/plane.ts';
import type { Plane, Stroke, View } from '../stroke/stroke.ts';
import { pickBeside } from './beside.ts';
import { isEdgeOn } from './penStroke.ts';
import { nearestOn, PIECES, rememberedBy, type SeenPoints } from './seenCurve.ts';
import type { Bench, Pen } from './tool.ts';
import type { Hit, Viewport } from './viewport.ts';

/** px around the pen in which something is found */
const REACH = 24;
/** cosine of the angle (25°) up to which a curve is seen as it was drawn */
const FACING = 0.906;

interface Common {
  readonly whose: Whose;
  /** lit, in the world */
  readonly points: readonly Vec3[];
  readonly closed: boolean;
  /** on which it is drawn over, in the world */
  readonly plane: Plane;
}

export type Lit =
  | (Common & { readonly kind: 'section'; readonly loop: SectionLoop })
  /** a construction curve */
  | (Common & { readonly kind: 'side'; readonly index: number; readonly old: Stroke });

/** Why there is none. */
export type NotLit = 'redraw-what' | EdgeOn;

/** The section there is seen from its edge. */
export interface EdgeOn {
  readonly kind: 'edge-on';
  readonly plane: Plane;
}

interface Candidate extends Seen {
  readonly whose: Whose;
  is(id: string): boolean;
}

export function litAt(pen: Pen, bench: Bench, local: boolean): Lit | NotLit {
  const { document, selection, viewport } = bench;
  const all = candidates(document);
  const chosen = all.filter(({ whose }) => whose.part !== undefined && selection.includes(whose.part));
  const draft = all.filter(({ whose }) => whose.part === undefined);
  for (const first of [...draft, ...(chosen.length === 1 ? chosen : [])]) {
    const lit = litOn(first, pen, hitOf(first, pen, document, viewport), viewport, local);
    if (lit) return lit;
  }
  const hit = pickBeside(pen, viewport, [REACH / 2, REACH]);
  const under = hit && all.find((candidate) => candidate.is(hit.id));
  return (under && litOn(under, pen, hit, viewport, local)) ?? 'redraw-what';
}

function candidates(document: Document): readonly Candidate[] {
  const parts = document.parts.filter(isSurface).filter(({ hidden }) => !hidden);
  const inHand = document.draft?.recreates?.part;
  const kept = parts.filter(({ id }) => id !== inHand).map(candidateOf);
  const { draft, brush } = document;
  const kind = readingOf(document);
  if (!draft || !kind || kind === 'solid' || (kind === 'tube' && draft.strokes.length > 1)) return kept;
  const form = formOfDraft(draft);
  return [{ kind, form, brush, placement: UNMOVED, whose: {}, is: isOfDraft }, ...kept];
}

/** As `draftSolids` names them; a part of a file may be called anything. */
const isOfDraft = (id: string): boolean => /^draft-\d+$/.test(id);

const candidateOf = (part: SurfacePart): Candidate => ({
  kind: part.kind,
  form: part,
  brush: part.brush,
  placement: part.placement,
  whose: { part: part.id },
  is: (id) => id === part.id,
});

/** Through all others. */
function hitOf(of: Candidate, { x, y }: Pen, { parts }: Document, viewport: Viewport): Hit | null {
  const others = parts.map(({ id }) => id).filter((id) => !of.is(id));
  const hit = viewport.pick(x, y, others);
  return hit && of.is(hit.id) ? hit : null;
}

function litOn(
  of: Candidate,
  pen: Pen,
  hit: Hit | null,
  viewport: Viewport,
  local: boolean,
): Lit | NotLit | null {
  return sideOf(of, pen, viewport) ?? sectionOf(of, pen, hit, viewport, local);
}

/** Curves lie where they were drawn only until the form is bent. */
function sideOf(of: Candidate, { x, y }: Pen, viewport: Viewport): Lit | null {
  const { view, size } = viewport;
  const { form, brush, placement, whose } = of;
  if (form.bends.some(({ isOff }) => !isOff)) return null;
  const { plane } = placedStroke(form.strokes[0]!, placement);
  if (facing(plane, view) < FACING) return null;
  let best: { readonly index: number; readonly points: readonly Vec3[]; readonly off: number } | null = null;
  for (const [index, stroke] of form.strokes.entries()) {
    const curve = seenOf(stroke, [brush, plane, view, size], () => seenCurve(stroke, of, plane, viewport));
    if (!curve) continue;
    const off = nearestOn(curve.pixels, [x, y]).distance;
    if (off <= REACH && off < (best?.off ?? Infinity)) best = { index, points: curve.points, off };
  }
  if (!best) return null;
  const { index, points } = best;
  const old = form.strokes[index]!;
  return { kind: 'side', whose, index, old, points, closed: old.closed, plane };
}

interface SeenCurve {
  /** in the world */
  readonly points: readonly Vec3[];
  readonly pixels: SeenPoints;
}

/** By the stroke, on one plane in one view. */
const seenOf = rememberedBy<Stroke, SeenCurve | null>();

function seenCurve(
  stroke: Stroke,
  { brush }: Candidate,
  plane: Plane,
  { view, size }: Viewport,
): SeenCurve | null {
  const curve = curveOfStroke(stroke, brush);
  if (!curve) return null;
  const points = Array.from({ length: PIECES + 1 }, (_, i) => toWorld(plane, curve.point(i / PIECES)));
  return { points, pixels: points.map((p) => project(view, size, p)) };
}

/** Cosine of the angle at which a plane is seen, from either side. */
const facing = ({ x, y }: Plane, { rotation }: View): number =>
  Math.abs(dot3(cross3(x, y), rotate3(rotation, [0, 0, 1])));

function sectionOf(
  of: Candidate,
  { x, y }: Pen,
  hit: Hit | null,
  { view, size }: Viewport,
  local: boolean,
): Lit | NotLit | null {
  const on = hit && of.is(hit.id) ? sectionThrough(of, hit.point) : null;
  const beside = () => {
    const seen = sectionSeenAt(of, (p) => {
      const at = project(view, size, p);
      return at && [at[0] - x, at[1] - y];
    });
    return seen && seen.distance <= REACH ? seen.u : null;
  };
  const u = on ?? beside();
  if (u === null) return null;
  const loop = sectionLoop(of, local ? u : ownPlace(of, u));
  if (!loop) return null;
  const { points, closed, plane } = loop;
  if (isEdgeOn(plane, view)) return { kind: 'edge-on', plane };
  return { kind: 'section', whose: of.whose, loop, points, closed, plane };
}

/** Of patches one of their own sections is redrawn; others are the same all along. */
function ownPlace({ kind, form }: Candidate, u: number): number {
  if (kind !== 'bspline') return u;
  return form.sections[nearestSection(form.sections, u, isRing(form))]?.u ?? u;
}
