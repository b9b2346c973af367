/**
 * The Cauchy kernel over a line with a linear weight: what skeletons are mostly made of, so it goes from the point to the
 * field in one piece.
 *
 * Theory: ∫ Q⁻² and ∫ Q⁻³, Q = M² + τ², from one arc tangent: θ, in which the line is seen across M.
 * Departures: the first end is the origin wherever the point is, and the perpendicular is taken once, since 1 is added to its
 * square: all that is lost is 1e-16 of the length in kernel units (LONGEST). Beyond an end that form cancels; there, with σ the sum of both
 * ends' angles, every term is positive (`outer`), and five Gauss points take what is far (FAR).
 * Nanoseconds near, beyond an end and far: 34, 47, 46; through a LineFrame with general moments and ten Gauss points 77, 151,
 * 194. Tried: this very form through a LineFrame, a third longer (a call, and numbers stored to be read again); the nearer end as
 * origin, a tenth.
 */
import { fastAtan2 } from '../math/atan.ts';
import { GAUSS } from '../math/gaussLegendre.ts';
import type { LinearLine, LineField } from './kernel.ts';
import { sineGap, sineGap4 } from './sineGap.ts';

/** kernel units: longer lines go through a frame */
const LONGEST = 64;
/** Q0 Q1 in units of l⁴ beyond which the weight about the foot would lose more than a digit; five points leave 1e-16 there */
const FAR = 1e4;
const { nodes: NODES, weights: NODE_WEIGHTS } = GAUSS[5];

export const cauchyLine = (line: LinearLine): LineField | null =>
  line.length <= LONGEST ? new CauchyLine(line) : null;

/** The point seen from the line, kernel units, and the integrals. The numbers say that these are doubles, no integers. */
class Place {
  /** along the line, from its first end */
  t = 0.5;
  /** the perpendicular, and 1 + its square */
  x = 0.5;
  y = 0.5;
  z = 0.5;
  m2 = 1.5;
  /** 1/(Q0 Q1), of both ends */
  ends = 0.5;
  /** whether the foot is beyond an end by more than M */
  isBeyond = false;
  /** ∫ Q⁻², and where the foot is beyond ∫ Q⁻³ */
  two = 0.5;
  three = 0.5;
  /** what the kernel's contract calls the integral over a line */
  value = 0.5;
  across = 0.5;
  along = 0.5;
}

/** one for all lines, filled again for each evaluation */
const at = new Place();

class CauchyLine implements LineField {
  readonly #a: Float64Array;
  readonly #u: Float64Array;
  readonly #per: number;
  readonly #length: number;
  readonly #far: number;
  readonly #w0: number;
  readonly #w1: number;

  constructor({ a, u, per, length, w0, w1 }: LinearLine) {
    this.#a = Float64Array.from(a);
    this.#u = Float64Array.from(u);
    this.#per = per;
    this.#length = length;
    this.#far = FAR * length * length * length * length;
    this.#w0 = w0;
    this.#w1 = w1;
  }

  value(x: number, y: number, z: number): number {
    this.#see(x, y, z);
    if (this.#isFar(false)) {
      this.#sample();
      return at.value;
    }
    const length = this.#length;
    const w1 = this.#w1;
    const { t } = at;
    const one = length * (0.5 * length - t) * at.ends;
    const foot = this.#w0 + w1 * t;
    return foot * at.two + w1 * one;
  }

  add(x: number, y: number, z: number, factor: number, out: Float64Array): void {
    this.#see(x, y, z);
    const u = this.#u;
    if (this.#isFar(true)) this.#sample();
    else {
      // in here, not in a method: engines inline but so much, and the arc tangent comes last
      const length = this.#length;
      const w0 = this.#w0;
      const w1 = this.#w1;
      const { t, m2, ends, two } = at;
      const rest = length - t;
      const one = length * (0.5 * length - t) * ends;
      const foot = w0 + w1 * t;
      const a = m2 + t * t;
      const b = m2 + rest * rest;
      const a2 = a * a;
      const b2 = b * b;
      const ends2 = ends * ends;
      const three = at.isBeyond ? at.three : (0.25 * ((rest * a2 + t * b2) * ends2 + 3 * two)) / m2;
      at.value = foot * two + w1 * one;
      at.across = -4 * foot * three - 2 * w1 * one * (a + b) * ends;
      at.along = (w0 * b2 - (w0 + w1 * length) * a2) * ends2 + w1 * two;
    }
    const { across } = at;
    const steep = factor * this.#per;
    // what of the perpendicular is along the line has no place in it
    const along = at.along - across * (at.x * u[0]! + at.y * u[1]! + at.z * u[2]!);
    out[0] = out[0]! + factor * at.value;
    out[1] = out[1]! + steep * (across * at.x + along * u[0]!);
    out[2] = out[2]! + steep * (across * at.y + along * u[1]!);
    out[3] = out[3]! + steep * (across * at.z + along * u[2]!);
  }

  #see(x: number, y: number, z: number): void {
    const a = this.#a;
    const u = this.#u;
    const per = this.#per;
    const ux = u[0]!;
    const uy = u[1]!;
    const uz = u[2]!;
    const vx = (x - a[0]!) * per;
    const vy = (y - a[1]!) * per;
    const vz = (z - a[2]!) * per;
    const t = vx * ux + vy * uy + vz * uz;
    const px = vx - t * ux;
    const py = vy - t * uy;
    const pz = vz - t * uz;
    at.t = t;
    at.x = px;
    at.y = py;
    at.z = pz;
    at.m2 = 1 + px * px + (py * py + pz * pz);
  }

  /** Whether the line is far; if not, the integrals are seen to. */
  #isFar(slopes: boolean): boolean {
    const length = this.#length;
    const { t, m2 } = at;
    const m = Math.sqrt(m2);
    const product = t * (t - length);
    // the foot's view of the line as a complex number: its angle is θ, its square Q0 Q1
    const x = m2 + product;
    const y = length * m;
    const square = x * x + y * y;
    if (square > this.#far) return true;
    const theta = fastAtan2(y, x);
    const per = 1 / m2;
    const ends = 1 / square;
    const isBeyond = (t < 0 ? -t : t - length) > m;
    at.ends = ends;
    at.isBeyond = isBeyond;
    if (isBeyond) outer(theta, m * per, x, y, slopes);
    else at.two = 0.5 * per * (m * per * theta + (m2 - product) * length * ends);
    return false;
  }

  /** Value and slopes from afar. */
  #sample(): void {
    const half = 0.5 * this.#length;
    const { t, m2 } = at;
    let value = 0;
    let across = 0;
    let along = 0;
    for (let i = 0; i < 5; i++) {
      const from = half + half * NODES[i]!;
      const q = 1 / (m2 + (from - t) * (from - t));
      const two = half * NODE_WEIGHTS[i]! * (this.#w0 + this.#w1 * from) * q * q;
      value += two;
      across -= 4 * two * q;
      along += 4 * (from - t) * two * q;
    }
    at.value = value;
    at.across = across;
    at.along = along;
  }
}

/**
 * The integrals where the foot lies beyond an end by more than M. There τ = M cot ψ makes them ∫ sin²ψ and ∫ sin⁴ψ over
 * θ = the difference of the ends' angles: with e = 1 − cos σ they are sums of positive terms.
 */
function outer(theta: number, i: number, x: number, y: number, slopes: boolean): void {
  const { m2, ends } = at;
  const root = Math.sqrt(ends);
  const sine = y * root;
  const cosine = x * root;
  // cos σ = (αβ − M²)/√(Q0 Q1), and sin²σ = 1 − cos²σ from (α + β)² = l² + 4 αβ
  const product = x - m2;
  const length2 = y * y * i * i;
  const e = (m2 * (length2 + 4 * product) * ends) / (1 + (product - m2) * root);
  const i3 = i * i * i;
  at.two = 0.5 * i3 * (sineGap(theta) + sine * e);
  if (!slopes) return;
  const gap = (0.5 * sine * sine) / (1 + cosine);
  at.three = i3 * i * i * (sineGap4(theta) + e * sine * (gap + 0.25 * e * cosine));
}
