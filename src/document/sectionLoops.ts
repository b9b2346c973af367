/**
 * Cross sections where they are seen, after bends and placement, to be drawn over (thesis 6.2): their points, and the plane through them
 * in the frame that strokes on sections are kept in. The frame is carried by the bends like a row of the surface, whatever was drawn over
 * the ends of the chord.
 */
import { compose, isUnmoved, type Placement, place3, turnOnto, unplaced } from '../math/placement.ts';
import { add3, cross3, dot3, length2, length3, rotate3, scale3, sub3 } from '../math/tuple.ts';
import type { Quat, Vec3 } from '../math/vec.ts';
import type { Plane, Stroke } from '../stroke/stroke.ts';
import { type BendInput, deform } from '../surface/deform.ts';
import type { SurfaceKind } from '../surface/index.ts';
import { sectionAt } from '../surface/sectionAt.ts';
import type { Sheet } from '../surface/sheet.ts';
import { type Source, sourceOf } from '../surface/source.ts';
import { outOf, turnedOut } from './centreLine.ts';
import { curveOfStroke } from './curves.ts';
import type { Brush } from './document.ts';
import { bendOf, sheetOf } from './sheets.ts';
import type { SurfaceForm } from './surfacePart.ts';

/** A surface as it is seen: a part, or the unfinished form. */
export interface Seen {
  readonly kind: SurfaceKind;
  readonly form: SurfaceForm;
  readonly brush: Brush;
  readonly placement: Placement;
}

export interface SectionLoop {
  readonly u: number;
  /** mm, in the world */
  readonly points: readonly Vec3[];
  readonly closed: boolean;
  /** its plane in the world: from the chord's middle x towards q_r, y out of the drawing plane */
  readonly plane: Plane;
  /** the same before bends, in the part's own space: strokes on it are kept on this */
  readonly own: Plane;
  /** of the chord, mm */
  readonly half: number;
}

interface Derived {
  readonly kind: SurfaceKind;
  readonly form: SurfaceForm;
  readonly brush: Brush;
  readonly sheet: Sheet;
  readonly source: Source;
  readonly bends: readonly BendInput[];
}

const derived = new WeakMap<SurfaceForm['strokes'], Derived>();

/** Null where strokes make nothing. */
function derivedOf({ kind, form, brush }: Seen): Derived | null {
  const known = derived.get(form.strokes);
  const isKnown =
    known?.kind === kind &&
    known.brush === brush &&
    known.form.sections === form.sections &&
    known.form.bends === form.bends &&
    known.form.back === form.back &&
    known.form.between === form.between &&
    known.form.detail === form.detail;
  if (known && isKnown) return known;
  const sheet = sheetOf(kind, form, brush);
  const curves = form.strokes.map((stroke) => curveOfStroke(stroke, brush)).filter((curve) => curve !== null);
  if (!sheet || curves.length < form.strokes.length) return null;
  const drawing = form.strokes[0]!.plane;
  const bends = form.bends.flatMap((bend) => (bend.isOff ? [] : bendOf(bend, drawing, brush)));
  const found = { kind, form, brush, sheet, source: sourceOf({ ...brush, curves }), bends };
  derived.set(form.strokes, found);
  return found;
}

/** no closer to the ends: there sections may be points */
const ENDS = 0.01;

/** Null at tips, and where strokes make nothing. */
export function sectionLoop(seen: Seen, wished: number): SectionLoop | null {
  const found = derivedOf(seen);
  const drawing = seen.form.strokes[0]?.plane;
  if (!found || !drawing) return null;
  const u = Math.min(1 - ENDS, Math.max(ENDS, wished));
  const { centre, axis, radius } = found.source.stand(u, 1);
  const points = sectionAt(found.sheet, u);
  if (!points || !(radius > 1e-6 * found.source.length)) return null;
  const frame: Plane = { origin: [centre[0], centre[1], 0], x: [-axis[0], -axis[1], 0], y: [0, 0, 1] };
  const { placement } = seen;
  const own = outOfPlane(drawing, frame);
  const bent = outOfPlane(drawing, carried(frame, u, found));
  const [first, last] = [points[0]!, points.at(-1)!];
  return {
    u,
    points: points.map((p) => place3(placement, outOf(drawing, p))),
    closed: length3(sub3(first, last)) <= 1e-6 * radius,
    plane: {
      origin: place3(placement, bent.origin),
      x: rotate3(placement.rotation, bent.x),
      y: rotate3(placement.rotation, bent.y),
    },
    own,
    half: radius,
  };
}

const outOfPlane = (drawing: Plane, { origin, x, y }: Plane): Plane => ({
  origin: outOf(drawing, origin),
  x: turnedOut(drawing, x),
  y: turnedOut(drawing, y),
});

/** By the bends, one after the other. */
function carried({ origin, x, y }: Plane, u: number, { source, bends }: Derived): Plane {
  if (bends.length === 0) return { origin, x, y };
  const row = {
    points: new Float64Array([...origin, ...add3(origin, x), ...add3(origin, y)]),
    normals: new Float64Array([0, 0, 1, 0, 0, 1, 0, 0, 1]),
    joined: false,
    at: { u, side: 1 as const },
  };
  const columns = { vs: [0, 0.5, 1], joined: [false, true, true] };
  const { rows } = bends.reduce<Sheet>(deform, { rows: [row], columns, spine: source.spine });
  const [at, right, out] = [0, 3, 6].map((k) => [...rows[0]!.points.slice(k, k + 3)] as unknown as Vec3);
  const along = unit(sub3(right!, at!));
  const up = sub3(out!, at!);
  return { origin: at!, x: along, y: unit(sub3(up, scale3(along, dot3(up, along)))) };
}

const unit = (v: Vec3): Vec3 => scale3(v, 1 / length3(v));

/** u of the section through the point of the surface nearest to `p` (mm, in the world); null where there is no surface. */
export function sectionThrough(seen: Seen, p: Vec3): number | null {
  const found = derivedOf(seen);
  const drawing = seen.form.strokes[0]?.plane;
  if (!found || !drawing) return null;
  const own = isUnmoved(seen.placement) ? p : place3(unplaced(seen.placement), p);
  const from = sub3(own, drawing.origin);
  const local: Vec3 = [
    dot3(from, drawing.x),
    dot3(from, drawing.y),
    dot3(from, cross3(drawing.x, drawing.y)),
  ];
  return nearestU(found.sheet, (k, points) => [
    points[k]! - local[0],
    points[k + 1]! - local[1],
    points[k + 2]! - local[2],
  ]);
}

/** u of the section that is seen nearest to a place, and how far it is from it; `shown`: where a point of the world is seen, less that place. */
export function sectionSeenAt(
  seen: Seen,
  shown: (p: Vec3) => readonly [number, number] | null,
): { readonly u: number; readonly distance: number } | null {
  const found = derivedOf(seen);
  const drawing = seen.form.strokes[0]?.plane;
  if (!found || !drawing) return null;
  let least = Infinity;
  const u = nearestU(found.sheet, (k, points) => {
    const world = place3(seen.placement, outOf(drawing, [points[k]!, points[k + 1]!, points[k + 2]!]));
    const at = shown(world);
    if (at) least = Math.min(least, length2(at));
    return at ? [at[0], at[1], 0] : null;
  });
  return u === null ? null : { u, distance: least };
}

/** Between the two rows around the nearest point; `away`: from the place to the point at k. */
function nearestU({ rows }: Sheet, away: (k: number, points: Float64Array) => Vec3 | null): number | null {
  let best = { row: -1, k: 0, off: Infinity };
  rows.forEach(({ points, at }, row) => {
    if (at.rigid) return;
    for (let k = 0; k < points.length; k += 3) {
      const v = away(k, points);
      const off = v ? dot3(v, v) : Infinity;
      if (off < best.off) best = { row, k, off };
    }
  });
  const row = rows[best.row];
  if (!row) return null;
  let found = { u: row.at.u, off: best.off };
  const from = away(best.k, row.points)!;
  for (const other of [rows[best.row - 1], rows[best.row + 1]]) {
    const to = other && !other.at.rigid ? away(best.k, other.points) : null;
    if (!other || !to) continue;
    const way = sub3(to, from);
    const t = Math.min(1, Math.max(0, -dot3(from, way) / (dot3(way, way) || 1)));
    const there = add3(from, scale3(way, t));
    const off = dot3(there, there);
    if (off < found.off) found = { u: row.at.u + t * (other.at.u - row.at.u), off };
  }
  return found.u;
}

const turned = (rotation: Quat): Placement => ({ rotation, translation: [0, 0, 0] });

/** A stroke on a section, as it is kept: from where it was drawn is kept with it, turned as the section is by bends and placement. */
export function ontoSection(stroke: Stroke, { own, plane }: SectionLoop): Stroke {
  const { view } = stroke;
  const back = compose(turned(turnOnto(own.x, own.y)), unplaced(turned(turnOnto(plane.x, plane.y))));
  const { rotation } = compose(back, turned(view.rotation));
  return { ...stroke, plane: own, view: { ...view, rotation } };
}
