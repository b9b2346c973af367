/** Strokes, sections and bends as surfaces are built from them. */
import type { Curve } from '../stroke/curve.ts';
import type { SurfaceInput } from '../surface/index.ts';
import { within } from '../surface/sideView.ts';
import { curveOfStroke } from './curves.ts';
import type { Brush } from './document.ts';
import type { SurfaceForm } from './surfacePart.ts';

/** Null where a construction curve is too short to be a line; bends that are, or are switched off, are left out. */
export function inputOf({ strokes, bends }: SurfaceForm, brush: Brush): SurfaceInput | null {
  const plane = strokes[0]?.plane;
  const curves = strokes.map((stroke) => curveOfStroke(stroke, brush));
  if (!plane || curves.some((curve) => curve === null)) return null;
  const inForce = bends.flatMap(({ stroke, keepsLength, isOff }) => {
    const curve = isOff ? null : curveOfStroke(stroke, brush);
    return curve ? [{ curve, plane: within(stroke.plane, plane), keepsLength }] : [];
  });
  return { curves: curves as Curve[], sections: [], bends: inForce };
}
