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
import { atan2, TAU } from '../math/trig.ts';
import { add2, cross2, dot2, scale2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Axis, AxisPoint } from './axis.ts';
import type { BendPath, PathPoint } from './bendPath.ts';
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

export function moveAt(bending: Bending, u: number, side: -1 | 1): Move {
  return new SectionMove(bending, u, side);
}

/** Worked out as it is asked for, and with as few objects as can be: bends one on another ask for tens of thousands. */
class SectionMove implements Move {
  readonly #bending: Bending;
  readonly #u: number;
  readonly #side: -1 | 1;
  readonly #here: AxisPoint;
  #place: PathPoint | null = null;
  #l: Frame | null = null;
  #d: Frame | null = null;
  #turned: Matrix | null = null;
  #turning: Matrix | null = null;

  constructor(bending: Bending, u: number, side: -1 | 1) {
    this.#bending = bending;
    this.#u = u;
    this.#side = side;
    this.#here = bending.axis.at(u, side);
  }

  from(): Vec2 {
    return this.#here.point();
  }

  dFrom(): Vec2 {
    return this.#here.rate();
  }

  to(): Vec2 {
    return this.#onPath().point();
  }

  dTo(): Vec2 {
    return scale2(this.#after()[0], this.#bending.path.stretch * this.#here.speed());
  }

  turn(): Matrix {
    if (!this.#turned) {
      const [along, left] = this.#before();
      const [k] = this.#bending.slide(this.#u, this.#side);
      this.#turned = product(this.#after(), [add2(along, scale2(left, k)), left]);
    }
    return this.#turned;
  }

  dTurn(): Matrix {
    this.#turning ??= this.#newTurning();
    return this.#turning;
  }

  #newTurning(): Matrix {
    const { axis, path, breaks, slide } = this.#bending;
    const [u, side] = [this.#u, this.#side];
    const [along, left] = this.#before();
    const angle = (x: number, way: -1 | 1): number => {
      const there = axis.at(x, way);
      return between(there.direction(), onPath(path, there, way).tangent());
    };
    const straying = (x: number, way: -1 | 1): number => between(along, axis.at(x, way).direction());
    const [k, dk] = slide(u, side);
    // the difference in one go, so that d = l turns nothing to the last bit
    const turning = axis.straight ? turningAt(path, this.#here, side) : slope(angle, u, side, breaks, TAU);
    const swing = k === 0 || axis.straight ? 0 : slope(straying, u, side, breaks, TAU);
    return product(this.#after(), [
      add2(scale2(left, dk - turning), scale2(along, -k * swing)),
      add2(scale2(along, turning), scale2(left, (turning + swing) * k)),
    ]);
  }

  #onPath(): PathPoint {
    this.#place ??= onPath(this.#bending.path, this.#here, this.#side);
    return this.#place;
  }

  /** T_l, N_l */
  #before(): Frame {
    this.#l ??= frame(this.#here.direction());
    return this.#l;
  }

  /** T_d, N_d */
  #after(): Frame {
    this.#d ??= frame(this.#onPath().tangent());
    return this.#d;
  }
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
export const times = (m: Matrix, v: Vec2): Vec2 => [dot2(m[0], v), dot2(m[1], v)];
/** The inverse: a move's turn has determinant 1. */
export const inverse = ([[a, b], [c, d]]: Matrix): Matrix => [
  [d, -b],
  [-c, a],
];
/** What every point of the section gains by u beyond what its turn gives. */
export function gainOf(move: Move): Vec2 {
  return sub2(move.dTo(), times(move.turn(), move.dFrom()));
}
