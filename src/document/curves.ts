/** Strokes as smooth curves, cached by reference. */
import { curveOf } from '../stroke/arcLength.ts';
import type { Curve } from '../stroke/curve.ts';
import { filterStroke } from '../stroke/filter.ts';
import type { Stroke } from '../stroke/stroke.ts';
import type { Brush } from './document.ts';
import { FRONT_VIEW } from './drawing.ts';

const curves = new WeakMap<Stroke['samples'], { key: string; curve: Curve | null }>();

/** The filtered stroke; null when it is too short to be a line. */
export function curveOfStroke(
  stroke: Stroke,
  { filter, levels }: Pick<Brush, 'filter' | 'levels'>,
): Curve | null {
  const { samples, closed } = stroke;
  // A hand trembles on the screen: drawn closer up, the same trembling is fewer millimetres. The grain is 1 mm in the first view.
  const grain = stroke.view.height / FRONT_VIEW.height;
  const key = `${filter} ${levels} ${closed} ${grain}`;
  const known = curves.get(samples);
  if (known?.key === key) return known.curve;
  const filtered = filterStroke(samples, { filter, levels, closed, grain });
  const curve = filtered && curveOf(filtered);
  curves.set(samples, { key, curve });
  return curve;
}
