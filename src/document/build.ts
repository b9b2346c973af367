/**
 * From strokes to meshes: everything derived from a document, cached by reference. An unchanged part is never
 * filtered or meshed twice, because commands share what they do not touch.
 */
import type { Mesh } from '../mesh/mesh.ts';
import { curveOf } from '../stroke/arcLength.ts';
import type { Curve } from '../stroke/curve.ts';
import { filterStroke } from '../stroke/filter.ts';
import type { Stroke } from '../stroke/stroke.ts';
import { buildSurface, type SurfaceKind } from '../surface/index.ts';
import { type Brush, type Document, type Part, readingOf } from './document.ts';

/** Quads along and around a parametric surface. */
export interface Resolution {
  readonly u: number;
  readonly v: number;
}

export const RESOLUTION: Resolution = { u: 64, v: 64 };

/** A mesh with what it is shown by. */
export interface Solid {
  readonly id: string;
  readonly kind: SurfaceKind;
  readonly colour: string;
  readonly mesh: Mesh;
}

/** mm: the first view, to which the filter's grain of 1 mm belongs */
const FRONT_HEIGHT = 200;

const curves = new WeakMap<Stroke, { filter: string; levels: number; curve: Curve | null }>();

/** The filtered stroke; null when it is too short to be a line. */
export function curveOfStroke(stroke: Stroke, brush: Pick<Brush, 'filter' | 'levels'>): Curve | null {
  const known = curves.get(stroke);
  if (known && known.filter === brush.filter && known.levels === brush.levels) return known.curve;
  const { filter, levels } = brush;
  // A hand trembles on the screen: drawn closer up, the same trembling is fewer millimetres.
  const grain = stroke.view.height / FRONT_HEIGHT;
  const filtered = filterStroke(stroke.samples, { filter, levels, closed: stroke.closed, grain });
  const curve = filtered && curveOf(filtered);
  curves.set(stroke, { filter, levels, curve });
  return curve;
}

/** One surface from the strokes of one form; null when they are too short. */
export function buildForm(
  kind: SurfaceKind,
  strokes: readonly Stroke[],
  brush: Brush,
  resolution: Resolution = RESOLUTION,
): Mesh | null {
  const plane = strokes[0]?.plane;
  const found = strokes.map((stroke) => curveOfStroke(stroke, brush));
  if (!plane || found.some((curve) => curve === null)) return null;
  const { radius, pressure, caps } = brush;
  return buildSurface(kind, found as Curve[], plane, { radius, pressure, caps, ...resolution });
}

const parts = new WeakMap<Part, Solid | null>();

function solidOf(part: Part): Solid | null {
  const known = parts.get(part);
  if (known !== undefined) return known;
  const mesh = buildForm(part.kind, part.strokes, part.brush);
  const solid = mesh && { id: part.id, kind: part.kind, colour: part.brush.colour, mesh };
  parts.set(part, solid);
  return solid;
}

/** The kept parts as meshes. */
export function solids(document: Document): Solid[] {
  return document.parts.map(solidOf).filter((solid) => solid !== null);
}

const drafts = new WeakMap<readonly Stroke[], { brush: Brush; kind: SurfaceKind; solids: Solid[] }>();

/** The unfinished form as meshes: one, or one a stroke while every stroke stays a tube. */
export function draftSolids(document: Document): Solid[] {
  const kind = readingOf(document);
  const strokes = document.draft?.strokes;
  if (kind === null || !strokes) return [];
  const known = drafts.get(strokes);
  if (known && known.kind === kind && known.brush === document.brush) return known.solids;
  const forms = kind === 'tube' ? strokes.map((stroke) => [stroke]) : [strokes];
  const found = forms.flatMap((form, i) => {
    const mesh = buildForm(kind, form, document.brush);
    return mesh ? [{ id: `draft-${i}`, kind, colour: document.brush.colour, mesh }] : [];
  });
  drafts.set(strokes, { brush: document.brush, kind, solids: found });
  return found;
}
