/**
 * An edge's share of the integral of (m + ρ²)^(−n/2) over a polygon, ρ in its plane: m = z² for inverse powers, z² + 1 for
 * the Cauchy family.
 *
 * Theory: Green over the loops, one recurrence for all n. With P_n = Σ d ∫ (m^(1−n/2) − (m + u)^(1−n/2))/u dτ, u = d² + τ², the polygon is
 * P_n/(n − 2), its gradient −Σ n ∫ (m + u)^(−n/2) dτ in the plane and −z P_(n+2) along z, and
 * P_(n+2) = (P_n + d ∫ (m + u)^(−n/2) dτ)/m. P_2 = 0 starts the even ones, P_3 = the solid angle over √m the odd ones.
 * Departures: n = 2 has a dilogarithm for its value, and other n no closed form: panels of 16 Gauss points in asinh τ, whose
 * integrand is analytic in a strip of half width π/2 however small m and d are (a tangent, as one may take for the
 * Gaussian, leaves a logarithm at its end: 1e-5).
 */
import { fastAtan2 } from '../math/atan.ts';
import { exp, expm1 } from '../math/exp.ts';
import { log, log1p } from '../math/log.ts';
import { EvenMoments } from './evenMoments.ts';
import type { EdgeFrame, Integral } from './kernel.ts';
import { Nodes } from './nodes.ts';
import { OddMoments } from './oddMoments.ts';

const evens = new EvenMoments();
const odds = new OddMoments();
const nodes = new Nodes();

/** Fills `out` as the contract says. m > 0; any n above 0. */
export function powerEdge(frame: EdgeFrame, m: number, n: number, out: Integral): void {
  if (n === 4 || n === 6) evenEdge(frame, m, n, out);
  else if (n === 1 || n === 3 || n === 5) oddEdge(frame, m, n, out);
  else sampledEdge(frame, m, n, out);
}

function evenEdge(
  { d, alpha, beta, length, z, slopes }: EdgeFrame,
  m: number,
  n: number,
  out: Integral,
): void {
  evens.set(m + d * d, alpha, beta, length, slopes ? n / 2 : n / 2 - 1);
  const { zero } = evens;
  const four = (d * zero[1]!) / m;
  const p = n === 4 ? four : (four + d * zero[2]!) / m;
  out[0] = p / (n - 2);
  if (!slopes) return;
  const line = zero[n / 2]!;
  out[1] = -line;
  out[2] = (-z * (p + d * line)) / m;
}

function oddEdge(
  { d, alpha, beta, length, z, slopes }: EdgeFrame,
  m: number,
  n: number,
  out: Integral,
): void {
  odds.set(m + d * d, alpha, beta, length);
  const three = solidAngle(d, alpha, beta, length, m);
  const line = odds.zero(n);
  if (n === 1) {
    out[0] = d * line - m * three;
    out[1] = -line;
    out[2] = -z * three;
    return;
  }
  const p = n === 3 ? three : (three + d * odds.zero(3)) / m;
  out[0] = p / (n - 2);
  if (!slopes) return;
  out[1] = -line;
  out[2] = (-z * (p + d * line)) / m;
}

/** The solid angle of the triangle over the edge, over √m; of what `odds` was set to. */
function solidAngle(d: number, alpha: number, beta: number, length: number, m: number): number {
  const { r0, r1 } = odds;
  const height = Math.sqrt(m);
  const q = d * d + m;
  const ends = alpha * beta;
  const cross = ends > 0 ? (q * length * (alpha + beta)) / (beta * r0 + alpha * r1) : beta * r0 - alpha * r1;
  const y = d * (q * length + height * cross);
  const x = (q + height * r0) * (q + height * r1) + ends * d * d;
  return fastAtan2(y, x) / height;
}

function sampledEdge({ d, alpha, beta, z, slopes }: EdgeFrame, m: number, n: number, out: Integral): void {
  nodes.sinhPanels(Math.sqrt(m + d * d), alpha, beta);
  const k = 0.5 * n - 1;
  const atFoot = exp(-k * log(m));
  let value = 0;
  let line = 0;
  for (let i = 0; i < nodes.count; i++) {
    const u = d * d + nodes.tau[i]! * nodes.tau[i]!;
    const l = log1p(u / m);
    const weight = nodes.weight[i]!;
    value += weight * (u > 0 ? (k === 0 ? l : -expm1(-k * l) / k) / (2 * u) : 0.5 / m);
    if (slopes) line += weight * exp(-(k + 1) * l);
  }
  out[0] = d * atFoot * value;
  if (!slopes) return;
  line *= atFoot / m;
  out[1] = -line;
  out[2] = (-z * (2 * k * out[0] + d * line)) / m;
}
