/**
 * How a bend moves the section at u (thesis 6.1, eq 6.1): the frame (l, T_l, V) goes to (d, T_d, V). Both share V, so in the
 * side view's coordinates M(u) is a plane motion and z stays:
 *     p′ = A(u)(p − l(u)) + d(u),   A = T_d T_lᵀ + N_d N_lᵀ  (R(V, θ)).
 * In B.2.1 S(u, 1) − S(u, 0) stands for the second axis: that is 0 on closed sections and askew to s_a on others.
 *
 * Near corners of d points slide along T_d, A = T_d(T_l + k N_l)ᵀ + N_d N_lᵀ with k up to ∓tan(turn/2), so that the
 * sections of both legs meet in the bisecting plane (the mitre of slices.ts).
 *
 * Normals. Near a section with plane normal m that sweeps over its points at the rate s = (c′ + ω × (p − c))·m, the bend is
 * a map of space with derivative J = A + g ⊗ m/s, g = A′(p − l) − A l′ + d′, and with a = A⁻¹g
 *     n′ ∝ det J · J⁻ᵀ n ∝ sign(s) A⁻ᵀ(n (s + a·m) − m (a·n)),
 * which keeps to the orientation of the triangles where sections overlap, too.
 */
import { once } from '../math/once.ts';
import { atan2, TAU } from '../math/trig.ts';
import { add2, add3, cross2, cross3, dot2, length3, scale2, scale3, sub2 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import type { Axis, AxisPoint } from './axis.ts';
import type { BendPath, PathPoint } from './bendPath.ts';
import type { Station } from './sheet.ts';
import type { Side2 } from './sideView.ts';
import { slope } from './slope.ts';

/** Rows of a 2 × 2 matrix. */
export type Matrix = readonly [Vec2, Vec2];

/** The plane motion of one section and its derivatives by u. */
export interface Move {
  turn(): Matrix;
  dTurn(): Matrix;
  /** what is turned about and where it goes, mm in the side view */
  from(): Vec2;
  to(): Vec2;
  dFrom(): Vec2;
  dTo(): Vec2;
}

/** How far points slide along d for each mm to the left of it, and its derivative by u. */
export type Slide = (u: number, side: -1 | 1) => readonly [slide: number, rate: number];

export interface Bending {
  readonly view: Side2;
  readonly axis: Axis;
  readonly path: BendPath;
  /** ascending u between which both ways are smooth */
  readonly breaks: readonly number[];
  readonly slide: Slide;
}

export function moveAt({ axis, path, breaks, slide }: Bending, u: number, side: -1 | 1): Move {
  const here = axis.at(u, side);
  const l = once((): Frame => frame(here.direction()));
  const place = once(() => onPath(path, here, side));
  const d = once((): Frame => frame(place().tangent()));
  const angle = (x: number, way: -1 | 1): number => {
    const there = axis.at(x, way);
    return between(there.direction(), onPath(path, there, way).tangent());
  };
  const straying = (x: number, way: -1 | 1): number => between(l()[0], axis.at(x, way).direction());
  return {
    turn: once(() => product(d(), [add2(l()[0], scale2(l()[1], slide(u, side)[0])), l()[1]])),
    dTurn: once(() => {
      const [k, dk] = slide(u, side);
      // the difference in one go, so that d = l turns nothing to the last bit
      const turning = axis.straight ? turningAt(path, here, side) : slope(angle, u, side, breaks, TAU);
      const swing = k === 0 || axis.straight ? 0 : slope(straying, u, side, breaks, TAU);
      return product(d(), [
        add2(scale2(l()[1], dk - turning), scale2(l()[0], -k * swing)),
        add2(scale2(l()[0], turning), scale2(l()[1], (turning + swing) * k)),
      ]);
    }),
    from: here.point,
    to: once(() => place().point()),
    dFrom: here.rate,
    dTo: once(() => scale2(d()[0], path.stretch * here.speed())),
  };
}

/** The place on d; `side` is along u, and the way may lead back there. */
function onPath(path: BendPath, there: AxisPoint, side: -1 | 1): PathPoint {
  return path.at(there.walked(), path.corners.length === 0 ? 1 : onward(there, side));
}

function turningAt(path: BendPath, there: AxisPoint, side: -1 | 1): number {
  return path.turning(there.walked(), onward(there, side)) * there.speed();
}

function onward(there: AxisPoint, side: -1 | 1): -1 | 1 {
  return there.speed() < 0 === (side === 1) ? -1 : 1;
}

type Frame = readonly [Vec2, Vec2];

/** d₀ r₀ᵀ + d₁ r₁ᵀ */
function product(d: Frame, r: Frame): Matrix {
  return [
    add2(scale2(r[0], d[0][0]), scale2(r[1], d[1][0])),
    add2(scale2(r[0], d[0][1]), scale2(r[1], d[1][1])),
  ];
}

const frame = (along: Vec2): Frame => [along, left(along)];
const left = (v: Vec2): Vec2 => [-v[1], v[0]];
const between = (a: Vec2, b: Vec2): number => atan2(cross2(a, b), dot2(a, b));
const times = (m: Matrix, v: Vec2): Vec2 => [dot2(m[0], v), dot2(m[1], v)];
const transposed = ([[a, b], [c, d]]: Matrix): Matrix => [
  [a, c],
  [b, d],
];
/** The inverse: a move's turn has determinant 1. */
export const inverse = ([[a, b], [c, d]]: Matrix): Matrix => [
  [d, -b],
  [-c, a],
];
const flat = (v: Vec3): Vec2 => [v[0], v[1]];
const deep = (v: Vec2, z: number): Vec3 => [v[0], v[1], z];

/** Where a point of the section goes, in the coordinates of the sheet; of whole rows in bentRow.ts. */
function moved(move: Move, view: Side2, p: Vec3): Vec3 {
  const at = view.point(p);
  const away = sub2(at, move.from());
  const still = away[0] === 0 && away[1] === 0;
  const to = still ? move.to() : add2(times(move.turn(), away), move.to());
  // what lies along V is not touched
  return add3(p, view.out(deep(sub2(to, at), 0)));
}

/** What every point of the section gains by u beyond what its turn gives. */
export function gainOf(move: Move): Vec2 {
  return sub2(move.dTo(), times(move.turn(), move.dFrom()));
}

/** g: what the section's point gains by u beyond what its turn gives. */
function strainOf(move: Move): (at: Vec2) => Vec2 {
  const gain = gainOf(move);
  const from = move.from();
  return (at) => {
    const away = sub2(at, from);
    return away[0] === 0 && away[1] === 0 ? gain : add2(times(move.dTurn(), away), gain);
  };
}

/** The station afterwards, so that bends stack. Turns about the section's own normal are left out: they move nothing. */
export function moveStation(move: Move, view: Side2, station: Station): Station {
  const back = once(() => transposed(inverse(move.turn())));
  const m = once(() => view.into(station.normal));
  const carried = once(() => deep(times(back(), flat(m())), m()[2]));
  const normal = once(() => scale3(carried(), 1 / length3(carried())));
  const rate = once(() => {
    const before = view.into(station.rate);
    const at = view.point(station.centre);
    return view.out(deep(add2(times(move.turn(), flat(before)), strainOf(move)(at)), before[2]));
  });
  const spin = once(() => {
    const dBack = transposed(inverse(move.dTurn()));
    const dm = view.into(cross3(station.spin, station.normal));
    const gained = deep(add2(times(back(), flat(dm)), times(dBack, flat(m()))), dm[2]);
    return view.out(cross3(normal(), scale3(gained, 1 / length3(carried()))));
  });
  const centre = once(() => moved(move, view, station.centre));
  return {
    get centre() {
      return centre();
    },
    get rate() {
      return rate();
    },
    get normal() {
      return view.out(normal());
    },
    get spin() {
      return spin();
    },
  };
}
