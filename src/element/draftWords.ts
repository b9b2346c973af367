/** What is said of the unfinished form, and what it joins. */

import type { Command } from '../document/command/index.ts';
import { recreatedOf } from '../document/command/keep.ts';
import { type Document, type Joins, readingOf, type SolidPart } from '../document/document.ts';
import { formOf, joinedOf } from '../document/draftPart.ts';
import { isRing, sectionThere } from '../document/surfacePart.ts';
import type { Stroke } from '../stroke/stroke.ts';
import { type Across, lackingBacks } from '../tool/across.ts';
import {
  FORMS,
  type FormWord,
  type JoinWord,
  PART_WORDS,
  RECREATE_WORDS,
  SECTION_WORDS,
  SILHOUETTE_WORDS,
  SURFACE,
  WORDS,
} from './words.ts';

/** Chips say which of these it is; null: neither, as of two open strokes. */
export function formWord(document: Document): FormWord | null {
  const kind = readingOf(document);
  if (kind === 'tube') return 'tube';
  if (kind !== 'solid') return null;
  return document.draft?.carves ? 'carve' : formOf(document);
}

/** In full. */
export function longName(document: Document): string {
  const kind = readingOf(document);
  const word = formWord(document);
  if (kind === 'solid' && word) return FORMS[word].long;
  // on one stroke sections are carried along a tube
  if (document.draft?.strokes.length === 1 && (kind === 'crossSection' || kind === 'bspline'))
    return SECTION_WORDS.onTube(document.draft.sections?.length ?? 0);
  return kind ? SURFACE[kind].long : '';
}

/** On the chip. */
export function shortName(document: Document): string {
  const again = recreatedOf(document);
  if (again) return again.name;
  const kind = readingOf(document);
  const isLong = kind === 'crossSection' || document.draft?.strokes.length === 1;
  return kind && kind !== 'solid' && !isLong ? SURFACE[kind].name : longName(document);
}

export function previewWords(document: Document): string {
  const again = recreatedOf(document);
  if (again) return RECREATE_WORDS.said(again.name);
  const kind = readingOf(document);
  const sections = document.draft?.sections?.length ?? 0;
  if (kind !== 'solid' && document.draft?.strokes.length === 1)
    return SILHOUETTE_WORDS.preview(longName(document));
  if (kind === 'bspline') return `${WORDS.preview(kind)}, ${SECTION_WORDS.sections(sections)}`;
  if (kind && kind !== 'solid') return WORDS.preview(kind);
  const joined = joinedOf(document)?.name ?? null;
  if (joined && document.draft?.carves) return SILHOUETTE_WORDS.carving(joined);
  const { joins, sitsOn } = SILHOUETTE_WORDS.previewOf;
  if (joined) return (document.draft?.joins?.component ? joins : sitsOn)(longName(document), joined);
  return SILHOUETTE_WORDS.preview(longName(document));
}

/** When it was kept: `document` is the one before. */
export function keptWords(document: Document): string | null {
  const kind = readingOf(document);
  if (!kind) return null;
  const again = recreatedOf(document);
  if (again) return RECREATE_WORDS.kept(again.name);
  const joined = joinedOf(document);
  if (joined)
    return document.draft?.carves
      ? SILHOUETTE_WORDS.carved(joined.name)
      : SILHOUETTE_WORDS.added(longName(document), joined.name);
  const made = kind === 'tube' ? (document.draft?.strokes.length ?? 0) : 1;
  return WORDS.kept(longName(document), document.parts.length + made);
}

/** One fact, under the name on the chip. */
export function fact(document: Document): string {
  if (recreatedOf(document)) return RECREATE_WORDS.inHand;
  const { draft, brush } = document;
  const strokes = draft?.strokes.length ?? 0;
  const across = sectionsFact(document);
  if (across) return across;
  const word = formWord(document);
  const joined = joinedOf(document)?.name;
  if (joined) {
    const { carve, blend, attach } = SILHOUETTE_WORDS.joinsFact;
    if (word === 'carve') return carve(joined);
    return draft?.joins?.component ? blend(joined) : attach(joined);
  }
  if (word === 'soft' || word === 'carve')
    return strokes > 1 ? SILHOUETTE_WORDS.holes(strokes - 1) : PART_WORDS.strokes(strokes);
  if (word === 'plate') return SILHOUETTE_WORDS.thick(2 * brush.radius);
  if (word && strokes === 1) return SILHOUETTE_WORDS.radius(brush.radius);
  return PART_WORDS.strokes(strokes);
}

/** Where its one section is, or how many there are. */
function sectionsFact(document: Document): string | null {
  const { sections = [] } = document.draft ?? {};
  const [first] = sections;
  const kind = readingOf(document);
  if (!first || (kind !== 'crossSection' && kind !== 'bspline')) return null;
  return sections.length > 1
    ? SECTION_WORDS.sections(sections.length)
    : SECTION_WORDS.sectionAt(Math.round(100 * first.u));
}

/** Sections whose backs are still to be drawn, "at 49 %"; null: none is. */
export function backsToDraw(of: Pick<Across, 'sections' | 'back'>): string | null {
  const lacking = lackingBacks(of);
  return lacking.length > 0 ? SECTION_WORDS.places(lacking.map(({ u }) => Math.round(100 * u))) : null;
}

/** After the front of a section, or when backs are to be drawn, one is awaited: where, in words. Null: none is, or something else was done. */
export function awaitedBack({ draft }: Document, commands: readonly Command[]): string | null {
  const { strokes = [], sections = [], back = 'none' } = draft ?? {};
  const last = commands.at(-1);
  const isFront = last?.type === 'addSection' && last.side !== 'back';
  if (!isFront && !(last?.type === 'setSurface' && last.change.back === 'drawn')) return null;
  const just = isFront
    ? [sectionThere(sections, last.u, isRing({ strokes }))].filter((one) => one !== null)
    : sections;
  return backsToDraw({ sections: just, back });
}

/** When it was dropped: `document` is the one before. */
export function droppedWords(document: Document): string {
  const again = recreatedOf(document);
  return again ? RECREATE_WORDS.dropped(again.name) : WORDS.dropped;
}

// A form that was set apart can be joined again as long as its strokes are there.
const started = new WeakMap<Stroke, Joins>();

/** Its stroke starts on a solid. */
export function rememberStart(stroke: Stroke, joins: Joins): void {
  started.set(stroke, joins);
}

/** The solid that the unfinished form starts on, or is told to join; null: none that is there. */
export function startedOn(document: Document): { readonly solid: SolidPart; readonly joins: Joins } | null {
  const { draft } = document;
  const first = draft?.strokes[0];
  const joins = (first && started.get(first)) ?? draft?.joins;
  const solid = document.parts.find(({ id }) => id === joins?.solid);
  if (!joins || solid?.kind !== 'solid' || solid.hidden) return null;
  return { solid, joins: { ...joins, component: joins.component ?? solid.components[0]?.id ?? null } };
}

/** How it goes with what it starts on. */
export function joinWord({ draft }: Document): JoinWord {
  if (!draft?.joins) return 'apart';
  return draft.joins.component === null ? 'attach' : 'blend';
}
