/**
 * A document is plain immutable data: the strokes people drew, the trees of bodies, and what people asked for. Surfaces,
 * meshes and pictures are derived (`build.ts`) and never stored, so every stroke stays editable.
 */
import type { FieldNode } from '../field/node.ts';
import type { Placement } from '../math/placement.ts';
import type { FilterOptions } from '../stroke/filter.ts';
import type { Stroke } from '../stroke/stroke.ts';
import type { SurfaceKind } from '../surface/index.ts';

/** What the next form is made with; a kept part has its own copy. */
export interface Brush {
  /** #rrggbb */
  readonly colour: string;
  /** of tubes, mm, 0.1–200 */
  readonly radius: number;
  /** tubes follow the pen's pressure */
  readonly pressure: boolean;
  /** open ends are closed */
  readonly caps: boolean;
  readonly filter: FilterOptions['filter'];
  /** levels of reverse subdivision, 0–6 */
  readonly levels: number;
}

/** What every part has, whatever it is made of. */
interface Kept {
  readonly id: string;
  readonly name: string;
  /** where it was moved to from where it was drawn */
  readonly placement: Placement;
  readonly hidden: boolean;
}

/** A surface made from the strokes of one form. */
export interface SurfacePart extends Kept {
  readonly kind: SurfaceKind;
  readonly strokes: readonly Stroke[];
  readonly brush: Brush;
}

/** An implicit body: the surface of a field. */
export interface BodyPart extends Kept {
  readonly kind: 'body';
  readonly node: FieldNode;
  /** #rrggbb of all of it; null: as its tree is painted. The mesh does not depend on it. */
  readonly colour: string | null;
}

/** One kept form. */
export type Part = SurfacePart | BodyPart;

export const isBody = (part: Part): part is BodyPart => part.kind === 'body';

/** #rrggbb; null where a part has several. */
export const colourOf = (part: Part): string | null => (isBody(part) ? part.colour : part.brush.colour);

/** What a part is made of. */
export const strokesOf = (part: Part): readonly Stroke[] => (isBody(part) ? [] : part.strokes);

/** The unfinished form: strokes not yet kept. It takes the document's brush until then. */
export interface Draft {
  readonly strokes: readonly Stroke[];
}

export interface Document {
  readonly version: 1;
  readonly parts: readonly Part[];
  readonly draft: Draft | null;
  readonly brush: Brush;
  /** every stroke stays a tube (hair, stalks), however many there are */
  readonly tubesOnly: boolean;
  /** number of the next part's id; no two parts of a document share one */
  readonly nextId: number;
}

/** Thesis: "the default radius of the pipe surface"; 6 mm reads as a stem in the 200 mm view. */
export const DEFAULT_BRUSH: Brush = {
  colour: '#d9cb4a',
  radius: 6,
  pressure: false,
  caps: true,
  filter: 'least-squares',
  levels: 3,
};

export const RADIUS_RANGE = { min: 0.5, max: 60 } as const;

export const EMPTY_DOCUMENT: Document = {
  version: 1,
  parts: [],
  draft: null,
  brush: DEFAULT_BRUSH,
  tubesOnly: false,
  nextId: 1,
};

/** The number of strokes decides the surface; closed and open strokes do not pair. */
export function readingOf(document: Document): SurfaceKind | null {
  const strokes = document.draft?.strokes ?? [];
  if (strokes.length === 0) return null;
  return strokes.length > 1 && !document.tubesOnly ? 'rotational' : 'tube';
}
