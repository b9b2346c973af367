/**
 * Sections as outlines in the frame of their chord: strokes filtered like all others, turned about their chords, closed by a back, and
 * drawn over. Cached by reference.
 */
import { once } from '../math/once.ts';
import { distance2, dot3, rotate3 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Curve } from '../stroke/curve.ts';
import type { Stroke } from '../stroke/stroke.ts';
import { runsLeft } from '../surface/chordWay.ts';
import type { PlacedOutline, SurfaceKind } from '../surface/index.ts';
import { joined, round } from '../surface/joined.ts';
import { mixedOutline } from '../surface/mixed.ts';
import { isReversed, type Outline, outlineOf, roundHalf } from '../surface/outline.ts';
import { redrawn } from '../surface/oversketch.ts';
import { type Source, sourceOf } from '../surface/source.ts';
import { uncrossed } from '../surface/uncrossed.ts';
import { curveOfStroke } from './curves.ts';
import type { Brush } from './document.ts';
import {
  type Back,
  type RedrawnStroke,
  type Section,
  type SectionStroke,
  type SurfaceForm,
  sectionsInForce,
} from './surfacePart.ts';

/** How strokes become curves, and how wide a tube is. */
type Filter = Pick<Brush, 'filter' | 'levels' | 'radius' | 'pressure'>;

/** The sections that a surface of this kind follows, u ascending; all closed, or without a back all open. */
export function outlinesOf(
  kind: SurfaceKind,
  form: Pick<SurfaceForm, 'strokes' | 'sections' | 'back' | 'between'>,
  brush: Filter,
  curves: readonly Curve[],
): readonly PlacedOutline[] {
  const sections = sectionsInForce(kind, form.sections);
  if (sections.length === 0) return [];
  const source = once(() => sourceOf({ ...brush, curves }));
  const place = (section: Section): PlacedOutline => ({
    u: placeOf(section),
    outline: outlineIn(section, form.back, brush, source),
  });
  const own = sections.filter(({ follows }) => !follows).map(place);
  const isRound = curves.every(({ closed }) => closed);
  return sections.map((section) => {
    if (!section.follows) return own.find(({ u }) => u === placeOf(section))!;
    const u = placeOf(section);
    const base = own.length > 0 ? mixedOutline(own, u, form.between, isRound) : circle(form.back);
    return { u, outline: drawnOver(base, section, brush) };
  });
}

/** u nearer to an end than this is that end: nothing lies between */
const END = 1e-6;

const placeOf = ({ u }: Section): number => (u < END ? 0 : u > 1 - END ? 1 : u);

/** Without any stroke. */
const circle = (back: Back): Outline => (back === 'none' ? roundHalf : round);

const outlines = new WeakMap<Section, { readonly key: string; readonly outline: Outline }>();

function outlineIn(section: Section, back: Back, brush: Filter, source: () => Source): Outline {
  const { front, back: own } = section;
  const turned = [front, own].map((drawn) => drawn && isTurned(drawn, brush, source));
  const isAcross = [front, own].some((drawn) => drawn?.half === null);
  const below = !isAcross || !runsLeft((u) => source().stand(u, 1));
  const key = JSON.stringify([brush.filter, brush.levels, back, turned, below]);
  const known = outlines.get(section);
  if (known?.key === key) return known.outline;
  const over = (front && halfOf(front, { reversed: turned[0]!, below }, brush)) ?? roundHalf;
  const under = (back === 'drawn' && own && halfOf(own, { reversed: turned[1]!, below }, brush)) || 'mirror';
  const whole =
    back === 'none' ? over : over === roundHalf && under === 'mirror' ? round : joined(over, under);
  const outline = drawnOver(whole, section, brush);
  outlines.set(section, { key, outline });
  return outline;
}

const drawnOver = (outline: Outline, { redraws }: Section, brush: Filter): Outline =>
  redraws.reduce((before, drawn) => withRedraw(before, drawn, brush), outline);

/** The outline itself where the stroke lies over no part of it. One that leads a closed outline across itself makes it touch itself. */
function withRedraw(outline: Outline, { stroke, half }: RedrawnStroke, brush: Filter): Outline {
  const curve = curveOfStroke(stroke, brush);
  const over = curve ? redrawn(outline, scaled(curve, 1 / half), sightOn(stroke)) : outline;
  return over.closed && over !== outline ? uncrossed(over) : over;
}

/** What was drawn over parts of sections that are no longer there, as after an earlier redrawing went: it is passed over. */
export function idleRedraws(
  kind: SurfaceKind,
  form: Pick<SurfaceForm, 'strokes' | 'sections' | 'back' | 'between'>,
  brush: Filter,
  curves: readonly Curve[],
): readonly RedrawnStroke[] {
  const sections = sectionsInForce(kind, form.sections);
  return sections.flatMap((section, i) => {
    if (section.redraws.length === 0) return [];
    const bare = sections.map((other) => (other === section ? { ...section, redraws: [] } : other));
    let outline = outlinesOf(kind, { ...form, sections: bare }, brush, curves)[i]!.outline;
    return section.redraws.filter((drawn) => {
      const before = outline;
      outline = withRedraw(before, drawn, brush);
      return outline === before;
    });
  });
}

/** The person who drew it, as seen on its plane. */
function sightOn({ plane: { x, y }, view }: Stroke): Vec2 {
  const back = rotate3(view.rotation, [0, 0, 1]);
  return [dot3(back, x), dot3(back, y)];
}

/** A front or a back; null where the stroke is too short to say anything. */
function halfOf(
  { stroke, half }: SectionStroke,
  { reversed, below }: { readonly reversed: boolean; readonly below: boolean },
  brush: Filter,
): Outline | null {
  const curve = lineOf(stroke, brush);
  return curve && outlineOf(curve, { reversed, across: half === null && below });
}

/** One end belongs to one side and one to the other, though they meet. */
const lineOf = (stroke: SectionStroke['stroke'], brush: Filter): Curve | null =>
  curveOfStroke(stroke.closed ? opened(stroke) : stroke, brush);

const openStrokes = new WeakMap<SectionStroke['stroke'], SectionStroke['stroke']>();

function opened(stroke: SectionStroke['stroke']): SectionStroke['stroke'] {
  const known = openStrokes.get(stroke);
  if (known) return known;
  const open = { ...stroke, closed: false, samples: [...stroke.samples] };
  openStrokes.set(stroke, open);
  return open;
}

/** u at which the sides are compared with the ends of a stroke */
const LOOKS = 64;

/** It was drawn from q_r to q_l: where it lies nearest to the sides. The curves may have become others since. */
function isTurned({ stroke, half }: SectionStroke, brush: Filter, source: () => Source): boolean {
  const curve = lineOf(stroke, brush);
  if (!curve) return false;
  if (half !== null) return isReversed(curve, [-half, 0], [half, 0]);
  const known = turns.get(curve);
  if (known?.source === source()) return known.against;
  const against = isAgainst(curve, source());
  turns.set(curve, { source: source(), against });
  return against;
}

/** By curves and what they were compared with. */
const turns = new WeakMap<Curve, { readonly source: Source; readonly against: boolean }>();

function isAgainst(curve: Curve, source: Source): boolean {
  const [a, b] = [curve.point(0), curve.point(1)];
  const away = Array.from({ length: LOOKS + 1 }, (_, i) => {
    const { left, right } = source.stand(i / LOOKS, 1);
    return {
      along: distance2(a, left) + distance2(b, right),
      against: distance2(b, left) + distance2(a, right),
    };
  });
  return Math.min(...away.map(({ against }) => against)) < Math.min(...away.map(({ along }) => along));
}

const scaled = (curve: Curve, k: number): Curve => ({
  closed: curve.closed,
  length: k * curve.length,
  corners: curve.corners,
  point: (u) => {
    const [x, y] = curve.point(u);
    return [k * x, k * y];
  },
  tangent: curve.tangent,
  pressure: curve.pressure,
});
