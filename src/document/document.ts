/**
 * A document is plain immutable data: the strokes people drew and what they asked for. Surfaces, meshes and
 * pictures are derived (`build.ts`) and never stored, so every stroke stays editable.
 */
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

/** One kept form. */
export interface Part {
  readonly id: string;
  readonly name: string;
  readonly kind: SurfaceKind;
  readonly strokes: readonly Stroke[];
  readonly brush: Brush;
  /** where it was moved to from where it was drawn */
  readonly placement: Placement;
  readonly hidden: boolean;
}

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
