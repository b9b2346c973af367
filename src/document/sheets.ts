/** Surfaces as sheets before they are meshes: what tools ask for sections, spines and rows. Cached by reference. */
import type { Vec3 } from '../math/vec.ts';
import type { Curve } from '../stroke/curve.ts';
import type { Stroke } from '../stroke/stroke.ts';
import { controlNet, netLines } from '../surface/controlNet.ts';
import { type BendInput, deform } from '../surface/deform.ts';
import { buildSheet, type PlacedOutline, type SurfaceKind } from '../surface/index.ts';
import type { PatchOptions } from '../surface/patch.ts';
import type { Sheet } from '../surface/sheet.ts';
import { within } from '../surface/sideView.ts';
import { curveOfStroke } from './curves.ts';
import type { Brush } from './document.ts';
import { idleRedraws, outlinesOf } from './outlines.ts';
import type { Bend, Between, Detail, RedrawnStroke, Section, SurfaceForm } from './surfacePart.ts';

/** Quads along and around a parametric surface. */
export interface Resolution {
  readonly u: number;
  readonly v: number;
}

/** spans that a control mesh of as many rows as needed is taken to have, when surfaces are kept small enough */
const USUAL_ROWS = 64;
/** and spans that surfaces without a control mesh have then */
const PLAIN_ROWS = 16;
/** quads of one surface: halving goes no further */
const MOST_QUADS = 1 << 18;

/** How often spans are halved: as a surface says itself, as far as there is room. */
export function timesOf({ rows, columns, u, v }: Detail): Resolution {
  let times = { u, v };
  const quads = () => ((rows ?? USUAL_ROWS) << times.u) * (columns << times.v);
  while (quads() > MOST_QUADS && times.u + times.v > 0)
    times = times.u >= times.v ? { ...times, u: times.u - 1 } : { ...times, v: times.v - 1 };
  return times;
}

/** As finely as a surface says itself; patches divide their spans by themselves. */
export function quadsOf(detail: Detail): Resolution {
  const times = timesOf(detail);
  return { u: (detail.rows ?? PLAIN_ROWS) << times.u, v: detail.columns << times.v };
}

/** The control mesh stays; its spans are halved until there are so many quads. */
function patchOf(between: Between, detail: Detail, resolution: Resolution | null): PatchOptions {
  const { rows, columns } = detail;
  const reaching = (spans: number, quads: number): number => {
    let times = 0;
    while (spans << times < quads) times++;
    return times;
  };
  const subdivisions = resolution
    ? { u: reaching(rows ?? PLAIN_ROWS, resolution.u), v: reaching(columns, resolution.v) }
    : timesOf(detail);
  return { between, rows, columns, subdivisions };
}

interface Known {
  readonly kind: SurfaceKind;
  readonly sections: readonly Section[];
  readonly key: string;
  readonly sheet: Sheet | null;
}

const sheets = new WeakMap<readonly Stroke[], Known[]>();

/** of the same strokes: a slider that goes back and forth finds what it showed before */
const KEPT = 4;

/**
 * The surface with its bends, in the coordinates of its drawing plane; null when its strokes are too short or enclose nothing.
 * Without a resolution as finely as the form says.
 */
export function sheetOf(
  kind: SurfaceKind,
  form: SurfaceForm,
  brush: Brush,
  resolution: Resolution | null = null,
): Sheet | null {
  const straight = unbent(kind, form, brush, resolution);
  const drawing = form.strokes[0]?.plane;
  return straight && drawing
    ? form.bends.reduce((sheet, bend) => withBend(sheet, bend, drawing, brush), straight)
    : straight;
}

/**
 * Of each sheet the bend it had last, so that in a stack what lies below the bend that is drawn stays. What the result depends on
 * beside the bend, the sheet does, too.
 */
const bent = new WeakMap<Sheet, { readonly bend: Bend; readonly sheet: Sheet }>();

function withBend(straight: Sheet, bend: Bend, drawing: Stroke['plane'], brush: Brush): Sheet {
  if (bend.isOff) return straight;
  const known = bent.get(straight);
  if (known?.bend === bend) return known.sheet;
  const sheet = bendOf(bend, drawing, brush).reduce(deform, straight);
  bent.set(straight, { bend, sheet });
  return sheet;
}

function unbent(
  kind: SurfaceKind,
  form: SurfaceForm,
  brush: Brush,
  resolution: Resolution | null,
): Sheet | null {
  const { strokes, sections, back, between, detail } = form;
  const key = JSON.stringify([{ ...brush, colour: '', finish: null }, back, between, detail, resolution]);
  const known = sheets.get(strokes) ?? [];
  const found = known.find(
    (other) => other.kind === kind && other.key === key && other.sections === sections,
  );
  if (found) return found.sheet;
  const curves = curvesOf(strokes, brush);
  const sheet = curves && built(kind, form, brush, curves, resolution);
  sheets.set(strokes, [{ kind, key, sections, sheet }, ...known].slice(0, KEPT));
  return sheet;
}

function built(
  kind: SurfaceKind,
  form: SurfaceForm,
  brush: Brush,
  curves: readonly Curve[],
  resolution: Resolution | null,
): Sheet | null {
  const { radius, pressure, caps } = brush;
  const input = { curves, sections: outlinesOf(kind, form, brush, curves), bends: [] };
  const quads = resolution ?? quadsOf(form.detail);
  const patch = patchOf(form.between, form.detail, resolution);
  return buildSheet(kind, input, { radius, pressure, caps, ...quads, patch });
}

/** The lines of the control net of a patch, bent as it is, in the coordinates of its drawing plane; none of other surfaces. */
export function controlLinesOf(
  kind: SurfaceKind,
  form: SurfaceForm,
  brush: Brush,
): readonly (readonly Vec3[])[] {
  const curves = kind === 'bspline' && form.between !== 'plain' ? curvesOf(form.strokes, brush) : null;
  if (!curves) return [];
  const { radius, pressure } = brush;
  const input = { curves, radius, pressure, caps: 'none' as const };
  const net = controlNet(
    input,
    outlinesOf(kind, form, brush, curves),
    patchOf(form.between, form.detail, null),
  );
  return netLines(bendsOf(form, brush).reduce(deform, net));
}

/** Of each section of a surface, in the order of its list; none where it has no strokes to speak of. */
export function outlinesOfPart(kind: SurfaceKind, form: SurfaceForm, brush: Brush): readonly PlacedOutline[] {
  const curves = curvesOf(form.strokes, brush);
  return curves ? outlinesOf(kind, form, brush, curves) : [];
}

/** What was drawn over parts of its sections that are no longer there (outlines.ts). */
export function idleRedrawsOf(kind: SurfaceKind, form: SurfaceForm, brush: Brush): readonly RedrawnStroke[] {
  const curves = form.sections.length > 0 ? curvesOf(form.strokes, brush) : null;
  return curves ? idleRedraws(kind, form, brush, curves) : [];
}

/** Null where one is too short to be a line. */
function curvesOf(strokes: readonly Stroke[], brush: Brush): readonly Curve[] | null {
  const found = strokes.map((stroke) => curveOfStroke(stroke, brush));
  return found.length > 0 && found.every((curve) => curve !== null) ? (found as Curve[]) : null;
}

/** Those in force, in the coordinates of the drawing plane. */
function bendsOf({ strokes, bends }: SurfaceForm, brush: Brush): readonly BendInput[] {
  return bends.flatMap((bend) => (bend.isOff ? [] : bendOf(bend, strokes[0]!.plane, brush)));
}

/** A bend as sheets take it; none where its stroke is too short. */
export function bendOf(
  { stroke, keepsLength }: Pick<Bend, 'stroke' | 'keepsLength'>,
  drawing: Stroke['plane'],
  brush: Brush,
): readonly BendInput[] {
  const curve = curveOfStroke(stroke, brush);
  return curve ? [{ curve, plane: within(stroke.plane, drawing), keepsLength }] : [];
}
