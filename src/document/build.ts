/**
 * From strokes to meshes: everything derived from a document, cached by reference. An unchanged part is never
 * filtered or meshed twice, because commands share what they do not touch. Bodies take longer: they are made beside
 * (`bodies.ts`), and show what was made last.
 */
import type { Mesh } from '../mesh/mesh.ts';
import { placed } from '../mesh/placed.ts';
import type { Stroke } from '../stroke/stroke.ts';
import { type SurfaceKind, sheetMesh } from '../surface/index.ts';
import { bodyMade } from './bodies.ts';
import { curveOfStroke } from './curves.ts';
import {
  type Brush,
  colourOf,
  type Document,
  type Draft,
  finishOf,
  formOfDraft,
  isSurface,
  type Part,
  readingOf,
  tubesOf,
} from './document.ts';
import { draftPart, hasDraftGroup, joinedOf } from './draftPart.ts';
import type { Finish } from './finish.ts';
import { type Resolution, sheetOf } from './sheets.ts';
import { nodeOf } from './solidNode.ts';
import type { SurfaceForm } from './surfacePart.ts';

export { quadsOf, type Resolution } from './sheets.ts';

/** Quads that surfaces have when nobody set any. */
export const RESOLUTION: Resolution = { u: 64, v: 64 };

/** A mesh with what it is shown by. */
export interface Solid {
  readonly id: string;
  readonly name: string;
  readonly kind: Part['kind'];
  /** #rrggbb; where the mesh has colours of its own those count */
  readonly colour: string;
  readonly finish: Finish;
  readonly mesh: Mesh;
}

/** One surface from the strokes of one form; null when they are too short. Without a resolution as finely as the form says. */
export function buildForm(
  kind: SurfaceKind,
  form: SurfaceForm,
  brush: Brush,
  resolution: Resolution | null = null,
): Mesh | null {
  if (form.strokes.some((stroke) => !curveOfStroke(stroke, brush))) return null;
  return sheetMesh(sheetOf(kind, form, brush, resolution), form.strokes[0]!.plane);
}

interface Shape extends Pick<SurfaceForm, 'sections' | 'bends'> {
  readonly kind: SurfaceKind;
  /** of what is no list; without colour and finish, which no mesh depends on */
  readonly key: string;
  readonly mesh: Mesh | null;
}

// By strokes, so that a part that is moved, hidden, named or coloured is not filtered and meshed again.
const shapes = new WeakMap<readonly Stroke[], Shape[]>();

/** A kept part where it was drawn; null when its strokes are too short, or the body is not made yet. */
export function shapeOf(part: Part, resolution: Resolution | null = null): Mesh | null {
  return isSurface(part)
    ? surfaceOf(part.kind, part, part.brush, resolution)
    : (bodyMade(nodeOf(part))?.mesh ?? null);
}

function surfaceOf(
  kind: SurfaceKind,
  form: SurfaceForm,
  brush: Brush,
  resolution: Resolution | null = null,
): Mesh | null {
  const { strokes, sections, bends, back, between, detail } = form;
  const key = JSON.stringify([{ ...brush, colour: '', finish: null }, back, between, detail, resolution]);
  const known = shapes.get(strokes) ?? [];
  const isIt = (shape: Shape) =>
    shape.kind === kind && shape.key === key && shape.sections === sections && shape.bends === bends;
  const found = known.find(isIt);
  if (found) return found.mesh;
  const mesh = buildForm(kind, form, brush, resolution);
  shapes.set(strokes, [{ kind, key, sections, bends, mesh }, ...known].slice(0, KEPT_SHAPES));
  return mesh;
}

/** of the same strokes: a slider that goes back and forth finds what it showed before */
const KEPT_SHAPES = 4;

/** By what a part's mesh depends on beside the part. */
const parts = new WeakMap<Part, { readonly source: object | null; readonly solid: Solid | null }>();

/** A kept part as a mesh, where it was moved to; null when there is none (see `shapeOf`). */
export function solidOf(part: Part, resolution: Resolution | null = null): Solid | null {
  const source = isSurface(part) ? resolution : bodyMade(nodeOf(part));
  const known = parts.get(part);
  if (known && known.source === source) return known.solid;
  const mesh = shapeOf(part, resolution);
  const { id, name, kind } = part;
  const solid = mesh && { id, name, kind, ...painted(part, mesh) };
  parts.set(part, { source, solid });
  return solid;
}

/** of bodies nobody painted, #rrggbb: what a tree takes for it (field/bind.ts), as it is shown */
export const CLAY = '#cbcbcb';

/** In its place; one colour covers those of the mesh, and says more exactly what all of its groups have. */
function painted(part: Part, shape: Mesh): Pick<Solid, 'colour' | 'finish' | 'mesh'> {
  const colour = colourOf(part);
  const { colours, ...plain } = shape;
  const mesh = colour === null || !colours ? shape : plain;
  return { colour: colour ?? CLAY, finish: finishOf(part), mesh: placed(mesh, part.placement) };
}

/** The kept parts that are not hidden, as meshes, but for one that the unfinished form becomes a part of, or was. */
export function solids(document: Document, resolution: Resolution | null = null): Solid[] {
  const inHand = [joinedOf(document)?.id, document.draft?.recreates?.part];
  const shown = document.parts.filter(({ hidden, id }) => !hidden && !inHand.includes(id));
  return shown.map((part) => solidOf(part, resolution)).filter((solid) => solid !== null);
}

/** Keeping the unfinished form would make only parts that can be seen. */
export function draftIsWhole(document: Document): boolean {
  const kind = readingOf(document);
  if (kind === null) return true;
  if (kind === 'solid') return hasDraftGroup(document);
  const forms = kind === 'tube' ? (document.draft?.strokes.length ?? 0) : 1;
  try {
    const found = draftSolids(document);
    return found.length === forms && found.every(({ mesh }) => mesh.indices.length > 0);
  } catch {
    return false;
  }
}

const drafts = new WeakMap<Draft, { brush: Brush; kind: SurfaceKind; solids: Solid[] }>();

/** The unfinished form as meshes: one, or one a stroke while every stroke stays a tube; of a solid all of it, when it is made. */
export function draftSolids(document: Document): Solid[] {
  const kind = readingOf(document);
  const { draft, brush } = document;
  if (kind === null || !draft) return [];
  if (kind === 'solid') {
    const part = draftPart(document);
    const solid = part && solidOf(part);
    return solid ? [solid] : [];
  }
  const known = drafts.get(draft);
  if (known && known.kind === kind && known.brush === brush) return known.solids;
  const whole = formOfDraft(draft);
  const forms = kind === 'tube' ? tubesOf(whole) : [whole];
  const found = forms.flatMap((form, i) => {
    const mesh = surfaceOf(kind, form, brush);
    return mesh
      ? [{ id: `draft-${i}`, name: '', kind, colour: brush.colour, finish: brush.finish, mesh }]
      : [];
  });
  drafts.set(draft, { brush, kind, solids: found });
  return found;
}

/** Strokes may enclose nothing. */
export const hasSurface = (solid: Solid | null): solid is Solid =>
  solid !== null && solid.mesh.indices.length > 0;
