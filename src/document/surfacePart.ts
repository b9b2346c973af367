/**
 * What parametric surfaces are made of beside their construction curves: sections across them, a back, bends, and how finely
 * they are cut. Strokes as they were drawn are the truth; outlines, patches and meshes are derived (`build.ts`).
 */
import type { Stroke } from '../stroke/stroke.ts';
import type { SurfaceKind } from '../surface/index.ts';

/** A stroke that is a section, or a part of one. */
export interface SectionStroke {
  readonly stroke: Stroke;
  /**
   * Null: drawn across on the drawing plane; its ends belong on the construction curves, and it is turned by 90° about its chord.
   * Else it lies on the section's own plane: x from the chord's middle towards q_r, y out of the drawing plane, mm, when half
   * the chord was so long, mm.
   */
  readonly half: number | null;
}

/** A cross section where it was drawn. */
export interface Section {
  /** along the construction curves, 0–1 */
  readonly u: number;
  /** null: the half circle of rotational surfaces */
  readonly front: SectionStroke | null;
  /** null: the mirrored front */
  readonly back: SectionStroke | null;
  /** what was drawn over it, one after the other */
  readonly redraws: readonly RedrawnStroke[];
  /** it is what lies there between the others, with what was drawn over it; front and back are null */
  readonly follows?: true;
}

/** Drawn over a section, on its own plane. */
export interface RedrawnStroke extends SectionStroke {
  readonly half: number;
}

/** As tubes and round forms have it, all along. */
export const ROUND: Omit<Section, 'u'> = { front: null, back: null, redraws: [] };

/** Thesis A.2.2: surfaces have no back, a mirrored front, or (future work there) one of their own. */
export const BACKS = ['none', 'front', 'drawn'] as const;
export type Back = (typeof BACKS)[number];

/** How sections go over into each other; `plain`: rows of points without a spline (fig. 5.13(b)). */
export const BETWEENS = ['cubic', 'linear', 'plain'] as const;
export type Between = (typeof BETWEENS)[number];

/** Thesis 6.1: the centre line anew, as seen from the side. */
export interface Bend {
  /** d(u); its plane faces the view it was drawn in, in the part's own space */
  readonly stroke: Stroke;
  /** the length of the part stays; else it reaches as far as the stroke */
  readonly keepsLength: boolean;
  /** not in force */
  readonly isOff: boolean;
}

/** Thesis A.4: spans of the control mesh, and how often each is halved. Surfaces without one have rows · 2^u quads. */
export interface Detail {
  /** along the construction curves; null: as many as they need */
  readonly rows: number | null;
  /** across, per section */
  readonly columns: number;
  /** subdivisions along and across */
  readonly u: number;
  readonly v: number;
}

export const DEFAULT_DETAIL: Detail = { rows: null, columns: 16, u: 2, v: 2 };

/** As nobody set it. */
export const isPlainDetail = ({ rows, columns, u, v }: Detail): boolean =>
  rows === DEFAULT_DETAIL.rows &&
  columns === DEFAULT_DETAIL.columns &&
  u === DEFAULT_DETAIL.u &&
  v === DEFAULT_DETAIL.v;

/** What is derived from, whoever has it: a part, or the unfinished form. */
export interface SurfaceForm {
  /** one or two construction curves, all on one plane */
  readonly strokes: readonly Stroke[];
  /** u ascending */
  readonly sections: readonly Section[];
  readonly back: Back;
  readonly between: Between;
  /** one after the other */
  readonly bends: readonly Bend[];
  readonly detail: Detail;
}

/** Lists are shared, so that what has none of its own compares by reference. */
export const PLAIN: Omit<SurfaceForm, 'strokes'> = {
  sections: [],
  back: 'none',
  between: 'cubic',
  bends: [],
  detail: DEFAULT_DETAIL,
};

interface Counts {
  readonly least: number;
  readonly most: number;
}

/** What each kind is made of. Tubes and round forms may keep sections that a person stepped back from. */
export const MADE_OF: Readonly<Record<SurfaceKind, { readonly strokes: Counts; readonly sections: number }>> =
  {
    tube: { strokes: { least: 1, most: 1 }, sections: 0 },
    rotational: { strokes: { least: 2, most: 2 }, sections: 0 },
    crossSection: { strokes: { least: 1, most: 2 }, sections: 1 },
    bspline: { strokes: { least: 1, most: 2 }, sections: 2 },
  };

/** The number of strokes decides. */
export function kindOfStrokes({ strokes, sections }: Pick<SurfaceForm, 'strokes' | 'sections'>): SurfaceKind {
  if (sections.length > 1) return 'bspline';
  if (sections.length > 0) return 'crossSection';
  return strokes.length > 1 ? 'rotational' : 'tube';
}

const STEPS: readonly SurfaceKind[] = ['tube', 'rotational', 'crossSection', 'bspline'];

/** A person may go back to what fewer strokes make, as far as there are strokes for it; no stroke is lost. */
export function steppedBack(
  form: Pick<SurfaceForm, 'strokes' | 'sections'>,
  wanted: SurfaceKind | undefined,
): SurfaceKind {
  const kind = kindOfStrokes(form);
  if (!wanted || STEPS.indexOf(wanted) >= STEPS.indexOf(kind)) return kind;
  return wanted === 'rotational' && form.strokes.length < 2 ? 'tube' : wanted;
}

/** Those that a surface of this kind follows: who stepped back from a patch has the one nearest to the middle. */
export function sectionsInForce(kind: SurfaceKind, sections: readonly Section[]): readonly Section[] {
  if (kind === 'bspline') return sections;
  if (kind !== 'crossSection' || sections.length < 2)
    return kind === 'crossSection' ? sections : PLAIN.sections;
  return [sections[nearestSection(sections, 0.5)]!];
}

/** All strokes of a form, in the order: curves, sections, bends. */
export function strokesOfForm({
  strokes,
  sections,
  bends,
}: Pick<SurfaceForm, 'strokes' | 'sections' | 'bends'>): readonly Stroke[] {
  if (sections.length === 0 && bends.length === 0) return strokes;
  const ofSections = strokesOfSections(sections).map(({ drawn }) => drawn.stroke);
  return [...strokes, ...ofSections, ...bends.map(({ stroke }) => stroke)];
}

/** A stroke of one of the sections. */
export interface OfSection {
  /** its index */
  readonly section: number;
  readonly as: 'front' | 'back' | 'redraw';
  readonly drawn: SectionStroke;
}

/** In the order in which they are counted: of each section the front, the back, and what was drawn over it. */
export const strokesOfSections = (sections: readonly Section[]): readonly OfSection[] =>
  sections.flatMap(({ front, back, redraws }, section) => [
    ...(front ? [{ section, as: 'front', drawn: front } as const] : []),
    ...(back ? [{ section, as: 'back', drawn: back } as const] : []),
    ...redraws.map((drawn) => ({ section, as: 'redraw', drawn }) as const),
  ]);

/** Made of strokes alone, with nothing set: all that there was before there were sections. */
export const isPlain = ({ sections, back, between, bends, detail }: Omit<SurfaceForm, 'strokes'>): boolean =>
  sections.length === 0 &&
  bends.length === 0 &&
  back === PLAIN.back &&
  between === PLAIN.between &&
  isPlainDetail(detail);

/** Every stroke changed alike; `scale`: what half chords are multiplied by. */
export function withStrokes<F extends Pick<SurfaceForm, 'strokes' | 'sections' | 'bends'>>(
  form: F,
  change: (stroke: Stroke) => Stroke,
  scale = 1,
): F {
  const drawn = <D extends SectionStroke>(section: D): D => ({
    ...section,
    stroke: change(section.stroke),
    half: section.half === null ? null : section.half * scale,
  });
  const sections = form.sections.map((section) => ({
    ...section,
    front: section.front && drawn(section.front),
    back: section.back && drawn(section.back),
    redraws: section.redraws.map(drawn),
  }));
  return {
    ...form,
    strokes: form.strokes.map(change),
    // lists that are empty stay the same, for caches
    sections: sections.length > 0 ? sections : form.sections,
    bends:
      form.bends.length > 0
        ? form.bends.map((bend) => ({ ...bend, stroke: change(bend.stroke) }))
        : form.bends,
  };
}

/**
 * Sections in order, with one more. The nearest one at the same place is replaced, and no other: where two are so near, the new one stands
 * exactly where the old one stood. `isRing`, here and below: u = 1 is u = 0.
 */
export function withSection(
  sections: readonly Section[],
  section: Section,
  isRing = false,
): readonly Section[] {
  const old = sectionThere(sections, section.u, isRing);
  const others = sections.filter((other) => other !== old);
  const u = old && isThere(others, section.u, isRing) ? old.u : section.u;
  return [...others, { ...section, u }].sort((a, b) => a.u - b.u);
}

/** Closed construction curves go round. */
export const isRing = ({ strokes }: Pick<SurfaceForm, 'strokes'>): boolean =>
  strokes.every(({ closed }) => closed);

/** u nearer than this are one place: two sections there would be a step */
export const SAME_PLACE = 0.01;

const isSamePlace = (a: number, b: number, isRing = false): boolean => distanceOf(a, b, isRing) < SAME_PLACE;

function distanceOf(a: number, b: number, isRing: boolean): number {
  const straight = Math.abs(a - b);
  return isRing ? Math.min(straight, 1 - straight) : straight;
}

/** The one at u, whose place another would take; null without any. */
export function sectionThere(sections: readonly Section[], u: number, isRing = false): Section | null {
  const nearest = sections[nearestSection(sections, u, isRing)];
  return nearest && isSamePlace(nearest.u, u, isRing) ? nearest : null;
}

export const isThere = (sections: readonly Section[], u: number, isRing = false): boolean =>
  sectionThere(sections, u, isRing) !== null;

/** Index of the section nearest to u; −1 without any. */
export function nearestSection(sections: readonly Section[], u: number, isRing = false): number {
  const distances = sections.map((section) => distanceOf(section.u, u, isRing));
  return distances.indexOf(Math.min(...distances));
}
