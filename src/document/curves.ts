/** Strokes as smooth curves, cached by reference. */
import { curveOf } from '../stroke/arcLength.ts';
import type { Curve } from '../stroke/curve.ts';
import { type FilteredStroke, filterStroke } from '../stroke/filter.ts';
import type { Stroke } from '../stroke/stroke.ts';
import type { Brush } from './document.ts';
import { FRONT_VIEW } from './drawing.ts';

interface Known {
  readonly key: string;
  readonly filtered: FilteredStroke | null;
  readonly curve: Curve | null;
}

const curves = new WeakMap<Stroke['samples'], Known>();

type Filter = Pick<Brush, 'filter' | 'levels'>;

/** The filtered stroke; null when it is too short to be a line. */
export const curveOfStroke = (stroke: Stroke, filter: Filter): Curve | null =>
  filteredStroke(stroke, filter).curve;

/** The control points of its pieces, mm on its plane; none when it is too short to be a line. */
export const controlsOfStroke = (stroke: Stroke, filter: Filter): FilteredStroke['pieces'] =>
  filteredStroke(stroke, filter).filtered?.pieces ?? [];

function filteredStroke(stroke: Stroke, { filter, levels }: Filter): Known {
  const { samples, closed } = stroke;
  // A hand trembles on the screen: drawn closer up, the same trembling is fewer millimetres. The grain is 1 mm in the first view.
  const grain = stroke.view.height / FRONT_VIEW.height;
  const key = `${filter} ${levels} ${closed} ${grain}`;
  const known = curves.get(samples);
  if (known?.key === key) return known;
  const filtered = filterStroke(samples, { filter, levels, closed, grain });
  const curve = filtered && curveOf(filtered);
  const found = { key, filtered, curve };
  curves.set(samples, found);
  return found;
}
