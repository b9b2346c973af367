/** Two strokes as the sides of one surface, cached by reference: what a surface is made of is what a guide shows. */
import type { Stroke } from '../stroke/stroke.ts';
import { type Pair, pairCurves } from '../surface/pair.ts';
import { curveOfStroke } from './curves.ts';
import type { Brush } from './document.ts';

const pairs = new WeakMap<Stroke, { key: string; other: Stroke; pair: Pair | null }>();

/** Null unless there are two, long enough to be lines. */
export function pairOf(
  [first, second, ...more]: readonly Stroke[],
  brush: Pick<Brush, 'filter' | 'levels'>,
): Pair | null {
  if (!first || !second || more.length > 0) return null;
  const key = `${brush.filter} ${brush.levels}`;
  const known = pairs.get(first);
  if (known?.other === second && known.key === key) return known.pair;
  const [left, right] = [curveOfStroke(first, brush), curveOfStroke(second, brush)];
  const pair = left && right && pairCurves(left, right);
  const found = pair && pair.length > 0 ? pair : null;
  pairs.set(first, { key, other: second, pair: found });
  return found;
}
