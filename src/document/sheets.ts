/**
 * Surfaces before they are meshes, in the coordinates of their drawing plane, cached by reference: where their sections stand after
 * every bend is what tools bend and draw over.
 */
import { buildSheet, type SurfaceKind } from '../surface/index.ts';
import type { Sheet } from '../surface/sheet.ts';
import { quadsOf } from './build.ts';
import type { Brush } from './document.ts';
import { inputOf } from './surfaceInput.ts';
import type { SurfaceForm } from './surfacePart.ts';

/** What a surface is made of: a part, or the unfinished form with the document's brush. */
export interface Made {
  readonly kind: SurfaceKind;
  readonly form: SurfaceForm;
  readonly brush: Brush;
}

interface Known extends Made {
  readonly sheet: Sheet | null;
}

const sheets = new WeakMap<SurfaceForm['strokes'], readonly Known[]>();
/** of the same strokes */
const KEPT = 4;

/** Null where strokes are too short, or enclose nothing. */
export function sheetOf(made: Made): Sheet | null {
  const { kind, form, brush } = made;
  const known = sheets.get(form.strokes) ?? [];
  const found = known.find(
    (other) => other.kind === kind && other.brush === brush && isSame(other.form, form),
  );
  if (found) return found.sheet;
  const sheet = derived(made);
  sheets.set(form.strokes, [{ ...made, sheet }, ...known].slice(0, KEPT));
  return sheet;
}

const isSame = (a: SurfaceForm, b: SurfaceForm): boolean =>
  a.sections === b.sections &&
  a.bends === b.bends &&
  a.back === b.back &&
  a.between === b.between &&
  a.detail === b.detail;

function derived({ kind, form, brush }: Made): Sheet | null {
  const input = inputOf(form, brush);
  const { radius, pressure, caps } = brush;
  return input && buildSheet(kind, input, { radius, pressure, caps, ...quadsOf(form.detail) });
}
