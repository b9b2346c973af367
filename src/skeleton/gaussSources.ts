/**
 * A segment as a few point sources, Gauss points with the weight there: from afar they are the same field.
 *
 * Theory: the error of G points is l^(2G+1) (G!)⁴/((2G+1) ((2G)!)³) times the largest derivative of order 2G of w k along the
 * line. That of a power kernel is bounded like its Taylor remainder (kernel/change.ts): |k^(m)| ≤ m! c_m M^(−n−m),
 * c_m = C(m + n − 1, m); the polynomial weight brings Leibniz' rule along. The bound by ellipses in the complex plane takes a point
 * more for the same error.
 */
import type { RelativeChange } from '../kernel/change.ts';
import { rootPower } from '../kernel/halfPower.ts';
import type { LineFrame } from '../kernel/kernel.ts';
import { GAUSS, type GaussPoints } from '../math/gaussLegendre.ts';
import type { Ball } from './ball.ts';
import { addSource, type Taylor } from './taylor.ts';

/** How many points are taken. Mutable. */
export class Choice {
  /** kernel units: no place is nearer */
  near = 0.5;
  /** what the points may be off by, if they can; what they are */
  enough = 0.5;
  off = 0.5;
  count: GaussPoints = 1;
}

/** What of a skel is made of points. */
export interface Sources {
  /** Sees to `count`, as few as `enough` allows, and `off`. */
  choose(choice: Choice): void;
  /** Adds `factor` times the polynomial of `count` points about the centre of the ball. */
  add(ball: Ball, factor: number, count: GaussPoints, out: Taylor): void;
}

export const MOST_SOURCES = 6;
/** (G!)⁴ / ((2G + 1) ((2G)!)²) */
export const SHARES = Float64Array.of(0, 1 / 12, 1 / 180, 1 / 2800, 1 / 44100, 1 / 698544, 1 / 11099088);
/** numbers of a point: place in mm, weight */
const POINT = 4;

export class GaussSources implements Sources {
  readonly #core: number;
  readonly #exponent: number;
  readonly #most: number;
  readonly #frame: LineFrame;
  /** the first end and the direction */
  readonly #a: Float64Array;
  readonly #u: Float64Array;
  readonly #per: number;
  /** for each count the coefficients of x^2G, x^(2G − 1), … in what it is off by */
  readonly #errors: Float64Array;
  /** of each count, once it is asked for */
  readonly #points: (Float64Array | null)[] = [null, null, null, null, null, null, null];

  /** `most`: the largest |w|; `a` in mm, `per` kernel units of a mm. */
  constructor(
    change: RelativeChange,
    frame: LineFrame,
    most: number,
    a: Float64Array,
    u: Float64Array,
    per: number,
  ) {
    this.#core = change.core;
    this.#exponent = change.power(frame.exponent);
    this.#most = most;
    this.#frame = frame;
    this.#a = a;
    this.#u = u;
    this.#per = per;
    this.#errors = errors(bendsOf(frame, most), this.#exponent);
  }

  choose(choice: Choice): void {
    const errors = this.#errors;
    const { length } = this.#frame;
    const q = 1 / (this.#core + choice.near * choice.near);
    const n = this.#exponent;
    const field = this.#most * length * (n === 4 ? q * q : rootPower(q, n));
    const enough = choice.enough / field;
    const x = length * Math.sqrt(q);
    // x^(2G − 2) and, where there is one, x^(2G − 3)
    let even = 1;
    let odd = 0;
    let off = Infinity;
    for (let count = 1; count <= MOST_SOURCES; count++) {
      const at = 4 * count;
      off = even * (errors[at + 2]! + x * (errors[at + 1]! + x * errors[at]!)) + odd * errors[at + 3]!;
      choice.count = count as GaussPoints;
      if (off <= enough) break;
      odd = even * x;
      even = odd * x;
    }
    choice.off = field * off;
  }

  add({ x, y, z }: Ball, factor: number, count: GaussPoints, out: Taylor): void {
    const points = this.#points[count] ?? this.#made(count);
    const core = this.#core;
    const n = this.#exponent;
    const per2 = this.#per * this.#per;
    for (let i = 0; i < POINT * count; i += POINT) {
      const dx = x - points[i]!;
      const dy = y - points[i + 1]!;
      const dz = z - points[i + 2]!;
      const q = 1 / (core + per2 * (dx * dx + dy * dy + dz * dz));
      // here in so many words: a call would put its number on the heap
      const value = factor * points[i + 3]! * (n === 4 ? q * q : rootPower(q, n));
      const first = -0.5 * n * q * value * per2;
      addSource(out, value, first, -(0.5 * n + 1) * q * first * per2, dx, dy, dz);
    }
  }

  #made(count: GaussPoints): Float64Array {
    const { nodes, weights } = GAUSS[count];
    const { length, weights: w } = this.#frame;
    const half = 0.5 * length;
    const points = new Float64Array(POINT * count);
    for (let i = 0; i < count; i++) {
      const t = half + half * nodes[i]!;
      for (let axis = 0; axis < 3; axis++) {
        points[POINT * i + axis] = this.#a[axis]! + (t / this.#per) * this.#u[axis]!;
      }
      points[POINT * i + 3] = half * weights[i]! * (w[0]! + t * (w[1]! + t * (w[2]! + t * w[3]!)));
    }
    this.#points[count] = points;
    return points;
  }
}

/** With c_m of the power n, four for each count: the share of Σ_j bends[j] c_(2G − j) x^(2G − j). */
function errors(bends: Float64Array, n: number): Float64Array {
  const c = new Float64Array(2 * MOST_SOURCES + 1).fill(1);
  for (let m = 1; m <= 2 * MOST_SOURCES; m++) c[m] = (c[m - 1]! * (m + n - 1)) / m;
  const out = new Float64Array(4 * (MOST_SOURCES + 1));
  for (let count = 1; count <= MOST_SOURCES; count++) {
    for (let j = 0; j <= Math.min(3, 2 * count); j++) {
      out[4 * count + j] = SHARES[count]! * bends[j]! * c[2 * count - j]!;
    }
  }
  return out;
}

/** |w⁽ʲ⁾| l^j / j! in parts of `most`, the largest |w|. */
export const bendsOf = (frame: Pick<LineFrame, 'weights' | 'length'>, most: number): Float64Array =>
  Float64Array.from(frame.weights, (_, j) => (j === 0 ? 1 : bend(frame, j) / most));

/** Σ C(k, j) |w_k| l^k, not less than |w⁽ʲ⁾| l^j / j! on the line. */
function bend({ weights, length }: Pick<LineFrame, 'weights' | 'length'>, j: number): number {
  let sum = 0;
  let choose = 1;
  let power = 1;
  for (let k = 0; k < weights.length; k++) {
    if (k > j) choose = (choose * k) / (k - j);
    if (k >= j) sum += choose * Math.abs(weights[k]!) * power;
    power *= length;
  }
  return sum;
}
