/** The line that the sections of a surface stand on, as it was drawn: what is seen of it from the side is its axis (thesis 6.1). */
import { mix2 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import type { Curve } from '../stroke/curve.ts';
import { toWorld } from '../stroke/plane.ts';
import { pairCurves } from '../surface/pair.ts';
import { curveOfStroke } from './curves.ts';
import type { SurfacePart } from './document.ts';

/** points of a line, and one more at its end */
const STEPS = 96;

const lines = new WeakMap<SurfacePart['strokes'], readonly Vec3[]>();

/** mm, in the part's own space, before bends; nothing where strokes are too short. */
export function centreLine({ strokes, brush }: Pick<SurfacePart, 'strokes' | 'brush'>): readonly Vec3[] {
  const known = lines.get(strokes);
  if (known) return known;
  const curves = strokes.map((stroke) => curveOfStroke(stroke, brush));
  const plane = strokes[0]?.plane;
  const at = curves.every((curve) => curve !== null) && plane ? centres(curves as Curve[]) : null;
  const found = at ? Array.from({ length: STEPS + 1 }, (_, i) => toWorld(plane!, at(i / STEPS))) : [];
  lines.set(strokes, found);
  return found;
}

function centres([first, second]: readonly Curve[]): ((u: number) => Vec2) | null {
  if (!first) return null;
  if (!second) return (u) => first.point(u);
  const pair = pairCurves(first, second);
  return (u) => {
    const { left, right } = pair.at(u, u === 1 ? -1 : 1);
    return mix2(left, right, 0.5);
  };
}
