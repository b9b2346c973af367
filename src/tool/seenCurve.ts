/** Curves as they are seen: cut into pieces and brought to the picture once a view, because a pen hovers a hundred times a second. */
import { distance2, dot2, mix2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';

/** pieces a curve is looked at in; the nearest place on them is then exact */
export const PIECES = 128;

/** px, at u = i/(n − 1); null: behind the camera */
export type SeenPoints = readonly (Vec2 | null)[];

export interface Nearest {
  readonly u: number;
  /** px */
  readonly distance: number;
}

export function nearestOn(points: SeenPoints, at: Vec2): Nearest {
  let best: Nearest = { u: 0, distance: Infinity };
  for (let i = 1; i < points.length; i++) {
    const [a, b] = [points[i - 1], points[i]];
    if (!a || !b) continue;
    const t = alongSegment(at, a, b);
    const distance = distance2(at, mix2(a, b, t));
    if (distance < best.distance) best = { u: (i - 1 + t) / (points.length - 1), distance };
  }
  return best;
}

function alongSegment(p: Vec2, a: Vec2, b: Vec2): number {
  const ab = sub2(b, a);
  const square = dot2(ab, ab);
  return square > 0 ? Math.min(Math.max(dot2(sub2(p, a), ab) / square, 0), 1) : 0;
}

/** Keeps what was last made of each owner, for as long as what it was made by is the same. */
export function rememberedBy<Owner extends object, Made>() {
  const known = new WeakMap<Owner, { readonly key: string; readonly made: Made }>();
  return (owner: Owner, by: readonly unknown[], make: () => Made): Made => {
    const key = JSON.stringify(by);
    const old = known.get(owner);
    if (old?.key === key) return old.made;
    const made = make();
    known.set(owner, { key, made });
    return made;
  };
}
