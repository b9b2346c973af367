/** Strokes seen in the frame of a section's chord: half chords, x towards q_r, y out of the drawing plane (outline.ts). */
import { add2, cross2, dot2, length2, scale2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Curve } from '../stroke/curve.ts';

/** Of a stroke on the section's own plane, mm from the chord's middle. */
export function inHalfChords(curve: Curve, half: number): Curve {
  return half > 0 ? mapped(curve, (p) => scale2(p, 1 / half), 1 / half) : curve;
}

/** Of a stroke across the chord on the drawing plane: turned by 90°, so that what lies to the right of q_l → q_r comes out. */
export function acrossChord(curve: Curve, left: Vec2, right: Vec2): Curve {
  const half = length2(sub2(right, left)) / 2;
  if (!(half > 0)) return curve;
  const along = scale2(sub2(right, left), 0.5 / half);
  const middle = scale2(add2(left, right), 0.5);
  const turned = (v: Vec2): Vec2 => [dot2(v, along), -cross2(along, v)];
  return {
    ...mapped(curve, (p) => scale2(turned(sub2(p, middle)), 1 / half), 1 / half),
    tangent: (t, side) => turned(curve.tangent(t, side)),
  };
}

function mapped(curve: Curve, map: (p: Vec2) => Vec2, scale: number): Curve {
  return { ...curve, length: curve.length * scale, point: (t) => map(curve.point(t)) };
}
