/**
 * The integral of (M² + τ²)^(−n/2) with a polynomial weight along a line, for whole n from 1 to 6: all inverse powers, the
 * Cauchy kernel and its family.
 *
 * The weight is expanded about the foot of the perpendicular, and each power of τ has a closed form.
 * Far away that expansion cancels, so there ten Gauss points take t itself: where R0² + R1² > 5 l², which is R0 + R1 > 3 l
 * to 5 % without a root.
 */
import { GAUSS } from '../math/gaussLegendre.ts';
import { EvenMoments } from './evenMoments.ts';
import { halfPower } from './halfPower.ts';
import type { Integral, LineFrame } from './kernel.ts';
import { Nodes, sumLine } from './nodes.ts';
import { OddMoments } from './oddMoments.ts';

const evens = new EvenMoments();
const odds = new OddMoments();
const nodes = new Nodes();
/** the weight about the foot, and the moments of f and of the next power */
const C = new Float64Array(4);
const J = new Float64Array(4);
const K = new Float64Array(4);

/** R0² + R1² in units of l² beyond which t itself is sampled; linear weights lose but one digit at a hundred lengths */
const FAR = 5;
const FAR_LINEAR = 1e4;

/** Fills `out` as the contract says. m2 > 0. */
export function inversePower(frame: LineFrame, m2: number, n: number, out: Integral): void {
  const { alpha, beta, length, degree, slopes } = frame;
  const a = m2 + alpha * alpha;
  const b = m2 + beta * beta;
  if (a + b > (degree > 1 ? FAR : FAR_LINEAR) * length * length) {
    farLine(frame, m2, n, out);
    return;
  }
  aboutFoot(frame.weights, -alpha, degree);
  const even = n % 2 === 0;
  if (even) evens.set(m2, alpha, beta, length, slopes ? n / 2 + 1 : n / 2);
  else odds.set(m2, alpha, beta, length);
  if (even) evens.moments(n / 2, degree, J);
  else odds.moments(n, degree, J);
  out[0] = dot(J, degree);
  if (!slopes) return;
  if (even) evens.moments(n / 2 + 1, degree, K);
  else odds.moments(n + 2, degree, K);
  out[1] = -0.5 * n * dot(K, degree);
  out[2] = along(frame, halfPower(a, n), halfPower(b, n));
}

/** The same by quadrature, exact to 1e-14 where both ends are farther than the length. */
export function farLine(frame: LineFrame, m2: number, n: number, out: Integral): void {
  nodes.gauss(GAUSS[10], frame.alpha, frame.beta);
  powersAt(nodes, m2, n);
  sumLine(frame, nodes, out);
}

/** Fills values and slopes of (M² + τ²)^(−n/2). */
export function powersAt(at: Nodes, m2: number, n: number): void {
  for (let i = 0; i < at.count; i++) {
    const tau = at.tau[i]!;
    const q = m2 + tau * tau;
    const f = halfPower(q, n);
    at.value[i] = f;
    at.slope[i] = (-0.5 * n * f) / q;
  }
}

/** Taylor coefficients of the weight at t = h. */
function aboutFoot(w: Float64Array, h: number, degree: number): void {
  const [w1, w2, w3] = [w[1]!, w[2]!, w[3]!];
  C[0] = degree > 0 ? w[0]! + h * (w1 + h * (w2 + h * w3)) : w[0]!;
  C[1] = w1 + h * (2 * w2 + 3 * h * w3);
  C[2] = w2 + 3 * h * w3;
  C[3] = w3;
}

function dot(moments: Float64Array, degree: number): number {
  let sum = C[0]! * moments[0]!;
  for (let k = 1; k <= degree; k++) sum += C[k]! * moments[k]!;
  return sum;
}

/** w f at the start less w f at the end, and ∫ w' f: integration by parts of the derivative along the line. */
function along({ weights: w, length: l, degree }: LineFrame, f0: number, f1: number): number {
  const end = w[0]! + l * (w[1]! + l * (w[2]! + l * w[3]!));
  let sum = w[0]! * f0 - end * f1;
  for (let k = 1; k <= degree; k++) sum += k * C[k]! * J[k - 1]!;
  return sum;
}
