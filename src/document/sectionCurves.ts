/** Strokes of sections where the form has them, with their ends on the construction curves, or on the edges of a tube. */
import { distance2, length2 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import { type Source, sourceOf } from '../surface/source.ts';
import { curveOfStroke } from './curves.ts';
import type { Brush } from './document.ts';
import { type OfSection, type SurfaceForm, strokesOfSections } from './surfacePart.ts';

export interface SectionCurve extends Pick<OfSection, 'section' | 'as'> {
  /** mm on the drawing plane and out of it; none where the stroke is too short to be a line */
  readonly points: readonly Vec3[];
  /** 0–1 at each of them */
  readonly pressure: readonly number[];
  /** q_l(u) and q_r(u) of its section, mm on the drawing plane */
  readonly ends: readonly [Vec2, Vec2];
}

const STEPS = 96;

/** All of them, in the order of `strokesOfSections`; none without construction curves. */
export function sectionCurves(
  { strokes, sections }: Pick<SurfaceForm, 'strokes' | 'sections'>,
  brush: Brush,
): readonly SectionCurve[] {
  const source = sections.length > 0 ? sourceOfStrokes(strokes, brush) : null;
  if (!source) return [];
  return strokesOfSections(sections).map((of) => {
    const { left, right } = source.stand(sections[of.section]!.u, 1);
    const ends = [left, right] as const;
    return { section: of.section, as: of.as, ends, ...placed(of, ends, brush) };
  });
}

const sources = new WeakMap<readonly object[], { readonly brush: Brush; readonly source: Source | null }>();

function sourceOfStrokes(strokes: SurfaceForm['strokes'], brush: Brush): Source | null {
  const known = sources.get(strokes);
  if (known?.brush === brush) return known.source;
  const curves = strokes.map((stroke) => curveOfStroke(stroke, brush)).filter((curve) => curve !== null);
  const isWhole = curves.length === strokes.length && curves.length > 0 && curves.length < 3;
  const made = isWhole ? sourceOf({ ...brush, curves }) : null;
  const source = made && made.length > 0 ? made : null;
  sources.set(strokes, { brush, source });
  return source;
}

const NOTHING: Pick<SectionCurve, 'points' | 'pressure'> = { points: [], pressure: [] };

function placed(
  { drawn: { stroke, half } }: OfSection,
  ends: SectionCurve['ends'],
  brush: Brush,
): Pick<SectionCurve, 'points' | 'pressure'> {
  const curve = curveOfStroke(stroke, brush);
  if (!curve) return NOTHING;
  const map = half === null ? snapped(curve.point(0), curve.point(1), ends) : standing(half, ends);
  const us = Array.from({ length: STEPS + 1 }, (_, i) => i / STEPS);
  return map ? { points: us.map((t) => map(curve.point(t))), pressure: us.map(curve.pressure) } : NOTHING;
}

type Place = (p: Vec2) => Vec3;

/** On a plane of its own: x along the chord from its middle, y out of the drawing plane. */
function standing(half: number, [left, right]: SectionCurve['ends']): Place {
  const [x, y] = [(right[0] - left[0]) / (2 * half), (right[1] - left[1]) / (2 * half)];
  const out = length2([x, y]);
  const [mx, my] = [(left[0] + right[0]) / 2, (left[1] + right[1]) / 2];
  return ([px, py]) => [mx + px * x, my + px * y, py * out];
}

/** By the similarity that brings its ends to q_l(u) and q_r(u); the end that is nearer to q_l is the left one. Null: its ends are one. */
function snapped(a: Vec2, b: Vec2, [left, right]: SectionCurve['ends']): Place | null {
  const isForward = distance2(a, left) + distance2(b, right) <= distance2(a, right) + distance2(b, left);
  return isForward ? similarity(a, b, left, right) : similarity(a, b, right, left);
}

/** Turns, scales and moves a to c and b to d. */
function similarity(a: Vec2, b: Vec2, c: Vec2, d: Vec2): Place | null {
  const [x, y] = [b[0] - a[0], b[1] - a[1]];
  const square = x * x + y * y;
  if (!(square > 0)) return null;
  const [vx, vy] = [d[0] - c[0], d[1] - c[1]];
  const re = (vx * x + vy * y) / square;
  const im = (vy * x - vx * y) / square;
  return ([px, py]) => {
    const [dx, dy] = [px - a[0], py - a[1]];
    return [c[0] + re * dx - im * dy, c[1] + im * dx + re * dy, 0];
  };
}
