/**
 * One circle of a rotational blending surface, and its analytic normals.
 *
 * With h = (q_l − q_r)/2 = ρ x′, y′ = n × x′ and e = cos v x′ ± sin v n, the surface c + ρ e has S_u × S_v along
 *     ± (B e − A y′),   A = (h′ + cos v c′)·x′,   B = (c′ + cos v h′)·y′.
 * ρ is not divided by, so the same formula gives the apex of a cone and the round top of a sphere; at poles only
 * x′, the limit of h/|h|, has to be found: the direction of h′, or of h a little further where strokes start tangent.
 */
import { add2, dot2, length2, mix2, scale2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Circle } from './circle.ts';
import type { Pair } from './pair.ts';

export interface Ring {
  readonly left: Vec2;
  readonly right: Vec2;
  readonly centre: Vec2;
  /** x′, unit, from the centre to q_l */
  readonly axis: Vec2;
  /** ρ ≥ 0, mm; 0 at poles */
  readonly radius: number;
  /** c′ and h′ */
  readonly dCentre: Vec2;
  readonly dHalf: Vec2;
}

/** The way round: 1 = from x′ to n. */
export type Sense = -1 | 1;

/** rings smaller than this part of the strokes' length are points; float32 would fold them anyway */
const POINT = 1e-6;
/** h′ shorter than this part of all derivatives has no direction */
const STILL = 1e-6;
/** how far, in u, the direction of h is looked for instead */
const BEYOND = 1e-4;

/** `side`: at a stop, the ring of the surface before (−1) or after (1) it; `pole` makes it a point. */
export function ringAt(pair: Pair, u: number, side: -1 | 1, pole: boolean): Ring {
  const { left, right, dLeft, dRight } = pair.at(u, side);
  const half = scale2(sub2(left, right), 0.5);
  const dHalf = scale2(sub2(dLeft, dRight), 0.5);
  const dCentre = scale2(add2(dLeft, dRight), 0.5);
  const size = length2(half);
  const point = pole || !(size > POINT * pair.length);
  const centre = mix2(left, right, 0.5);
  return {
    left: point ? centre : left,
    right: point ? centre : right,
    centre,
    axis: point ? limitAxis(pair, u, side, dHalf, dCentre) : scale2(half, 1 / size),
    radius: point ? 0 : size,
    dCentre,
    dHalf,
  };
}

/** lim h/|h| on one side of a pole. */
function limitAxis(pair: Pair, u: number, side: -1 | 1, dHalf: Vec2, dCentre: Vec2): Vec2 {
  const still = STILL * (length2(dHalf) + length2(dCentre));
  if (length2(dHalf) > still) return scale2(dHalf, side / length2(dHalf));
  const beyond = Math.min(Math.max(u + side * BEYOND, 0), 1);
  const { left, right } = pair.at(beyond, side);
  const half = sub2(left, right);
  const across: Vec2 = [-dCentre[1], dCentre[0]];
  for (const wish of [half, across]) if (length2(wish) > 0) return scale2(wish, 1 / length2(wish));
  return [1, 0];
}

/** Points of the circle, x y z for each column; in the plane they are the strokes' own to the last bit. */
export function ringPoints(ring: Ring, sense: Sense, circle: Circle): Float64Array {
  const { centre, axis, radius } = ring;
  const out = new Float64Array(3 * circle.length);
  circle.forEach(([cos, sin], j) => {
    const reach = radius * cos;
    const inPlane = cos > 0 ? ring.left : ring.right;
    const point = sin === 0 ? inPlane : [centre[0] + reach * axis[0], centre[1] + reach * axis[1]];
    out.set([point[0]!, point[1]!, radius * sense * sin], 3 * j);
  });
  return out;
}

/** Unit normals of the surface along the circle. */
export function ringNormals({ axis, dCentre, dHalf }: Ring, sense: Sense, circle: Circle): Float64Array {
  const across: Vec2 = [-axis[1], axis[0]];
  const [cx, cy] = [dot2(dCentre, axis), dot2(dCentre, across)];
  const [hx, hy] = [dot2(dHalf, axis), dot2(dHalf, across)];
  const nothing = 1e-9 * (length2(dCentre) + length2(dHalf));
  const out = new Float64Array(3 * circle.length);
  circle.forEach(([cos, sin], j) => {
    let along = sense * -(hx + cos * cx);
    let outward = sense * (cy + cos * hy);
    let length = length2([along, outward]);
    // the surface stands still here: outward is as good as any direction
    if (!(length > nothing)) [along, outward, length] = [0, 1, 1];
    const radial = (outward / length) * cos;
    out[3 * j] = radial * axis[0] + (along / length) * across[0];
    out[3 * j + 1] = radial * axis[1] + (along / length) * across[1];
    out[3 * j + 2] = (outward / length) * sense * sin;
  });
  return out;
}
