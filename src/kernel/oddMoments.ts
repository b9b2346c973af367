/**
 * ∫ τ^k r^−n along a line, r² = M² + τ², n = 1, 3, 5, 7: what odd inverse powers are made of.
 *
 * ∫ r⁻¹ is ln((r0 + r1 + l)/(r0 + r1 − l)), the others follow by parts; S = τ/r turns n = 5 and 7 into polynomials of S, which three Gauss
 * points integrate exactly. Departure: the logarithm of n = 1 as log1p, so that it keeps its digits for far edges.
 */
import { log1p } from '../math/log.ts';

/** Gauss nodes of [0, 1] */
const G0 = 0.1127016653792583;
const G2 = 0.8872983346207417;

export class OddMoments {
  /** r at the ends */
  r0 = 0;
  r1 = 0;
  private m2 = 0;
  private alpha = 0;
  private beta = 0;
  private length = 0;
  /** ((r0 + r1)² − length²)/2 */
  private e = 0;

  set(m2: number, alpha: number, beta: number, length: number): void {
    this.m2 = m2;
    this.alpha = alpha;
    this.beta = beta;
    this.length = length;
    this.r0 = Math.sqrt(m2 + alpha * alpha);
    this.r1 = Math.sqrt(m2 + beta * beta);
    const product = this.r0 * this.r1;
    const ends = alpha * beta;
    this.e =
      ends > 0 ? product + ends + m2 : m2 * (1 + (m2 + alpha * alpha + beta * beta) / (product - ends));
  }

  /** ∫ r^−n */
  zero(n: number): number {
    const { r0, r1, length, e } = this;
    if (n === 1) return log1p((length * (r0 + r1 + length)) / e);
    const three = (length * (r0 + r1)) / (r0 * r1 * e);
    return n === 3 ? three : three * this.#average(n === 5 ? 1 : 2, 0);
  }

  /** ∫ τ^k r^−n for k = 0…degree. */
  moments(n: number, degree: number, out: Float64Array): void {
    const { m2, alpha, beta, r0, r1 } = this;
    out[0] = this.zero(n);
    if (degree > 0) out[1] = this.#one(n);
    if (n === 1) {
      if (degree > 1) out[2] = 0.5 * (beta * r1 - alpha * r0 - m2 * out[0]);
      if (degree > 2) out[3] = (beta * beta * r1 - alpha * alpha * r0) / 3 - (2 / 3) * m2 * out[1]!;
      return;
    }
    if (degree > 1)
      out[2] = n === 3 ? this.zero(1) - m2 * out[0] : this.zero(3) * this.#average(n === 5 ? 0 : 1, 1);
    if (degree > 2) out[3] = this.#one(n - 2) - m2 * out[1]!;
  }

  /** ∫ τ r^−n */
  #one(n: number): number {
    const { r0, r1, length, alpha, beta } = this;
    const one = (length * (alpha + beta)) / (r0 + r1);
    if (n === 1) return one;
    const a = 1 / r0;
    const b = 1 / r1;
    const three = one * a * b;
    if (n === 3) return three;
    const [aa, ab, bb] = [a * a, a * b, b * b];
    if (n === 5) return (three * (aa + ab + bb)) / 3;
    return (three * (aa * aa + aa * ab + ab * ab + ab * bb + bb * bb)) / 5;
  }

  /** The mean of C^c S^2s between the ends, C = (1 − S²)/M². */
  #average(c: 0 | 1 | 2, s: 0 | 1): number {
    const { alpha, beta, r0, r1, m2 } = this;
    if (alpha * beta > 0) {
      // (1 − |S|)/M² from the ends: C itself cancels there
      const d0 = 1 / (r0 * (r0 + Math.abs(alpha)));
      const d1 = 1 / (r1 * (r1 + Math.abs(beta)));
      const node = (g: number) => d0 + (d1 - d0) * g;
      return mean(
        outerTerm(node(G0), m2, c, s),
        outerTerm(node(0.5), m2, c, s),
        outerTerm(node(G2), m2, c, s),
      );
    }
    const s0 = alpha / r0;
    const s1 = beta / r1;
    const node = (g: number) => s0 + (s1 - s0) * g;
    return mean(innerTerm(node(G0), m2, c, s), innerTerm(node(0.5), m2, c, s), innerTerm(node(G2), m2, c, s));
  }
}

const mean = (a: number, b: number, c: number): number => (5 * (a + c) + 8 * b) / 18;

function outerTerm(d: number, m2: number, c: number, s: number): number {
  const S = 1 - m2 * d;
  return powers(d * (1 + S), S, c, s);
}

function innerTerm(S: number, m2: number, c: number, s: number): number {
  return powers(((1 - S) * (1 + S)) / m2, S, c, s);
}

function powers(C: number, S: number, c: number, s: number): number {
  return (c === 0 ? 1 : c === 1 ? C : C * C) * (s === 0 ? 1 : S * S);
}
