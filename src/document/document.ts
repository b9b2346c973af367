/**
 * A document is plain immutable data: the strokes people drew, the trees of bodies, and what people asked for. Surfaces,
 * meshes and pictures are derived (`build.ts`) and never stored, so every stroke stays editable.
 */
import type { FieldNode } from '../field/node.ts';
import type { Placement } from '../math/placement.ts';
import type { FilterOptions } from '../stroke/filter.ts';
import type { Stroke } from '../stroke/stroke.ts';
import type { SurfaceKind } from '../surface/index.ts';
import { DEFAULT_FINISH, type Finish } from './finish.ts';
import { type Component, type Form, groupsOf, isForm } from './solid.ts';
import { PLAIN, type SurfaceForm, steppedBack, strokesOfForm } from './surfacePart.ts';

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
  /** how it answers light */
  readonly finish: Finish;
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
export interface SurfacePart extends Kept, SurfaceForm {
  readonly kind: SurfaceKind;
  readonly brush: Brush;
}

/** An implicit body: the surface of a field. */
export interface BodyPart extends Kept {
  readonly kind: 'body';
  readonly node: FieldNode;
  /** #rrggbb of all of it; null: as its tree is painted. The mesh does not depend on it. */
  readonly colour: string | null;
}

/** An implicit body made from strokes: components that stand side by side, each of groups that blend (Tai et al. 2004, §6). */
export interface SolidPart extends Kept {
  readonly kind: 'solid';
  readonly components: readonly Component[];
}

/** One kept form. */
export type Part = SurfacePart | BodyPart | SolidPart;

/** Its tree is its truth. */
export const isBody = (part: Part): part is BodyPart => part.kind === 'body';
/** Its tree is derived from strokes (solidNode.ts). */
export const isSolid = (part: Part): part is SolidPart => part.kind === 'solid';
export const isSurface = (part: Part): part is SurfacePart => !isBody(part) && !isSolid(part);

/** A field has its surface: of a tree, or of strokes. */
export const isImplicit = (part: Part): part is BodyPart | SolidPart => !isSurface(part);

/** #rrggbb; null where a part has several. */
export function colourOf(part: Part): string | null {
  if (isBody(part)) return part.colour;
  if (isSurface(part)) return part.brush.colour;
  const [first, ...others] = groupsOf(part).map(({ brush }) => brush.colour);
  return others.every((colour) => colour === first) ? (first ?? null) : null;
}

/** A solid is of one material, that of its first form; colours alone blend. */
export function finishOf(part: Part): Finish {
  if (isSurface(part)) return part.brush.finish;
  return isSolid(part) ? groupsOf(part)[0]!.brush.finish : DEFAULT_FINISH;
}

/** What a part is made of. */
export function strokesOf(part: Part): readonly Stroke[] {
  if (isSolid(part)) return groupsOf(part).flatMap(({ strokes }) => strokes);
  return isBody(part) ? [] : strokesOfForm(part);
}

/** The unfinished form: strokes not yet kept. It takes the document's brush until then. */
export interface Draft extends Partial<Omit<SurfaceForm, 'strokes' | 'bends'>> {
  readonly strokes: readonly Stroke[];
  /** what a person chose to make of them; without it their number decides, and whether they are closed */
  readonly form?: Form | SurfaceKind;
  /** of a solid: it takes away from what it joins */
  readonly carves?: true;
  /** of a solid: which one it becomes a part of */
  readonly joins?: Joins;
  /** the strokes of a kept part, to be drawn further; its bends wait until it is kept again */
  readonly recreates?: Recreated;
  /** Only shown, while the pen moves: roughly, and at once. No file has it. */
  readonly isRough?: true;
}

/** A part whose strokes are in hand again. */
export interface Recreated {
  /** its id */
  readonly part: string;
  /** what the next form was to be made with */
  readonly brush: Brush;
}

/** Where a group goes: into a component, where it blends, or beside the others of a solid. */
export interface Joins {
  /** id of the part */
  readonly solid: string;
  /** id; null: one of its own */
  readonly component: string | null;
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
  finish: DEFAULT_FINISH,
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

/** What an unfinished form is. */
export type Reading = SurfaceKind | 'solid';

/** What a person chose; else a closed stroke is a silhouette, and of open ones the number decides. */
export function readingOf({ draft, tubesOnly }: Document): Reading | null {
  const { strokes = [], sections = [], form } = draft ?? {};
  if (strokes.length === 0) return null;
  if (form !== undefined && isForm(form)) return 'solid';
  if (form === 'tube' || staysTubes({ draft, tubesOnly })) return 'tube';
  const isUnsaid = form === undefined && sections.length === 0;
  if (strokes[0]!.closed && isUnsaid && !draft?.recreates) return 'solid';
  return steppedBack({ strokes, sections }, form);
}

/** Strokes of a part that are in hand again are what the part was, whatever others become. */
export const staysTubes = ({ draft, tubesOnly }: Pick<Document, 'draft' | 'tubesOnly'>): boolean =>
  tubesOnly && !draft?.recreates;

/** The unfinished form as surfaces are made of it. */
export const formOfDraft = ({ strokes, sections, back, between, detail }: Draft): SurfaceForm => ({
  strokes,
  sections: sections ?? PLAIN.sections,
  back: back ?? PLAIN.back,
  between: between ?? PLAIN.between,
  bends: PLAIN.bends,
  detail: detail ?? PLAIN.detail,
});

// Lists of one stroke, so that meshes are found again by them.
const alone = new WeakMap<Stroke, readonly Stroke[]>();

/** Of strokes that stay tubes. Sections across several are none of a single one; what one stroke has of its own it keeps. */
export function tubesOf(form: SurfaceForm): readonly SurfaceForm[] {
  if (form.strokes.length === 1) return [form];
  return form.strokes.map((stroke) => {
    const strokes = alone.get(stroke) ?? [stroke];
    alone.set(stroke, strokes);
    return { ...PLAIN, detail: form.detail, strokes };
  });
}
