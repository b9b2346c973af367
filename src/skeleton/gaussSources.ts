/**
 * A segment as a few point sources, Gauss points with the weight there: from afar they are the same field.
 *
 * Theory: the error of G points is l^(2G+1) (G!)⁴/((2G+1) ((2G)!)³) times the largest derivative of order 2G of w k along the
 * line. That of a power kernel is bounded like its Taylor remainder (kernel/change.ts): |k^(m)| ≤ m! c_m M^(−n−m),
 * c_m = C(m + n − 1, m); the polynomial weight brings Leibniz' rule along. The bound by ellipses in the complex plane takes a point
 * more for the same error.
 */
import type { RelativeChange } from '../kernel/change.ts';
import { halfPower } from '../kernel/halfPower.ts';
import type { LineFrame } from '../kernel/kernel.ts';
import { GAUSS, type GaussPoints } from '../math/gaussLegendre.ts';
import { addSource, type Taylor } from './taylor.ts';

/** What of a skel is made of points. */
export interface Sources {
  /** of them, as the last `error` chose it */
  readonly count: GaussPoints;
  error(near: number, enough: number): number;
  add(x: number, y: number, z: number, factor: number, count: GaussPoints, out: Taylor): void;
}

export const MOST_SOURCES = 6;
/** (G!)⁴ / ((2G + 1) ((2G)!)²) */
export const SHARES = Float64Array.of(0, 1 / 12, 1 / 180, 1 / 2800, 1 / 44100, 1 / 698544, 1 / 11099088);

export class GaussSources implements Sources {
  readonly #change: RelativeChange;
  readonly #exponent: number;
  readonly #frame: LineFrame;
  /** the first end and the direction */
  readonly #a: Float64Array;
  readonly #u: Float64Array;
  readonly #per: number;
  /** |w⁽ʲ⁾| l^j / j! in parts of the largest |w| */
  readonly #bends: Float64Array;
  /** c_m x^m */
  readonly #terms = new Float64Array(2 * MOST_SOURCES + 1);
  /** sources for the last `error` */
  count: GaussPoints = 1;

  /** `most`: the largest |w|; `a` in mm, `per` kernel units of a mm. */
  constructor(
    change: RelativeChange,
    frame: LineFrame,
    most: number,
    a: Float64Array,
    u: Float64Array,
    per: number,
  ) {
    this.#change = change;
    this.#exponent = change.power(frame.exponent);
    this.#frame = frame;
    this.#a = a;
    this.#u = u;
    this.#per = per;
    this.#bends = bendsOf(frame, most);
  }

  /**
   * Chooses as many sources as `enough` allows and says by how much they are off, both in parts of most · l · k(near), at all places
   * that are `near` or farther (kernel units).
   */
  error(near: number, enough: number): number {
    const x = this.#frame.length / Math.sqrt(this.#change.core + near * near);
    const terms = this.#terms;
    terms[0] = 1;
    let off = Infinity;
    for (let count = 1; count <= MOST_SOURCES; count++) {
      for (let m = 2 * count - 1; m <= 2 * count; m++) {
        terms[m] = (terms[m - 1]! * x * (m + this.#exponent - 1)) / m;
      }
      let sum = 0;
      for (let j = 0; j <= Math.min(this.#frame.degree, 2 * count); j++) {
        sum += this.#bends[j]! * terms[2 * count - j]!;
      }
      off = SHARES[count]! * sum;
      this.count = count as GaussPoints;
      if (off <= enough) break;
    }
    return off;
  }

  /** Adds `factor` times the polynomial of `count` sources about (x, y, z), mm. */
  add(x: number, y: number, z: number, factor: number, count: GaussPoints, out: Taylor): void {
    const { nodes, weights } = GAUSS[count];
    const { core } = this.#change;
    const { length, weights: w } = this.#frame;
    const [a, u, per, n] = [this.#a, this.#u, this.#per, this.#exponent];
    const half = 0.5 * length;
    for (let i = 0; i < nodes.length; i++) {
      const t = half + half * nodes[i]!;
      const mm = t / per;
      const dx = x - a[0]! - mm * u[0]!;
      const dy = y - a[1]! - mm * u[1]!;
      const dz = z - a[2]! - mm * u[2]!;
      const q = 1 / (core + per * per * (dx * dx + dy * dy + dz * dz));
      const weight = w[0]! + t * (w[1]! + t * (w[2]! + t * w[3]!));
      const value = factor * half * weights[i]! * weight * halfPower(1 / q, n);
      const first = -0.5 * n * q * value * per * per;
      addSource(out, value, first, -(0.5 * n + 1) * q * first * per * per, dx, dy, dz);
    }
  }
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
