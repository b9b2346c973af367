/**
 * ∫ τ^k Q^−n along a line, Q = M² + τ², n = 1…4: what Cauchy kernels and even inverse powers are made of.
 *
 * One arc tangent, then recurrences upwards in n; ∫ τ^k Q^−n = ∫ τ^(k−2) Q^(1−n) − M² ∫ τ^(k−2) Q^−n.
 * Departure: beyond an end the recurrence for k = 0 cancels (by (M/τ)², 1e-10 at M = 1e-5 τ). A series of
 * sin^2n in the angle takes two arc tangents; here v = 1/τ makes it ∫ v^(2n−2) (1 + M²v²)^−n dv, smooth where M v < 2/3, and
 * ten Gauss points leave 1e-16 for all n at once, without a root, a series or an arc tangent.
 */
import { fastAtan2 } from '../math/atan.ts';
import { GAUSS } from '../math/gaussLegendre.ts';
import { log1p } from '../math/log.ts';

/** |τ| of the nearer end in units of M beyond which 1/τ is the variable */
const OUTER = 1.5;

export class EvenMoments {
  /** ∫ Q^−n at n, n = 0…4 */
  readonly zero = new Float64Array(5);
  private m2 = 0;
  private length = 0;
  /** Q at the ends */
  private a = 0;
  private b = 0;
  private sum = 0;

  /** Sees to `zero` up to `top` ≤ 4. */
  set(m2: number, alpha: number, beta: number, length: number, top: number): void {
    const { zero } = this;
    const m = Math.sqrt(m2);
    this.m2 = m2;
    this.length = length;
    this.a = m2 + alpha * alpha;
    this.b = m2 + beta * beta;
    this.sum = alpha + beta;
    zero[0] = length;
    zero[1] = fastAtan2(length * m, m2 + alpha * beta) / m;
    const nearer = alpha > 0 ? alpha : -beta;
    if (nearer > OUTER * m) this.#outer(nearer, length, top);
    else this.#inner(alpha, beta, top);
  }

  /** ∫ τ^k Q^−n for k = 0…degree. */
  moments(n: number, degree: number, out: Float64Array): void {
    const { zero, m2 } = this;
    out[0] = zero[n]!;
    if (degree > 0) out[1] = this.#one(n);
    if (degree > 1) out[2] = zero[n - 1]! - m2 * out[0]!;
    if (degree > 2) out[3] = this.#one(n - 1) - m2 * out[1]!;
  }

  #inner(alpha: number, beta: number, top: number): void {
    const { zero, m2, a, b, length } = this;
    if (top < 2) return;
    const ab = 1 / (a * b);
    zero[2] = (zero[1]! + length * (m2 - alpha * beta) * ab) / (2 * m2);
    if (top > 2) zero[3] = ((beta * a * a - alpha * b * b) * ab * ab + 3 * zero[2]!) / (4 * m2);
    if (top > 3) {
      const ends = (beta * a * a * a - alpha * b * b * b) * ab * ab * ab;
      zero[4] = (ends + 5 * zero[3]!) / (6 * m2);
    }
  }

  #outer(nearer: number, length: number, top: number): void {
    const { zero, m2 } = this;
    const { nodes, weights } = GAUSS[10];
    const farther = nearer + length;
    const half = (0.5 * length) / (nearer * farther);
    const middle = 1 / farther + half;
    let [two, three, four] = [0, 0, 0];
    for (let i = 0; i < 10; i++) {
      const v = middle + half * nodes[i]!;
      const v2 = v * v;
      const c = 1 / (1 + m2 * v2);
      const term = half * weights[i]! * v2 * c * c;
      two += term;
      if (top < 3) continue;
      three += term * v2 * c;
      four += term * v2 * c * v2 * c;
    }
    zero[2] = two;
    zero[3] = three;
    zero[4] = four;
  }

  /** ∫ τ Q^−n */
  #one(n: number): number {
    const { a, b, length, sum } = this;
    if (n === 0) return 0.5 * length * sum;
    const rise = length * sum;
    if (n === 1) return 0.5 * (sum > 0 ? log1p(rise / a) : -log1p(-rise / b));
    const ab = 1 / (a * b);
    if (n === 2) return 0.5 * rise * ab;
    if (n === 3) return 0.25 * rise * (a + b) * ab * ab;
    return (rise * (a * a + a * b + b * b) * ab * ab * ab) / 6;
  }
}
