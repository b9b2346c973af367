/**
 * The Gaussian exp(−s²r²) (Blinn; Jin & Tai 2002), in units of 1/s.
 *
 * Segments: its closed form has an error function and cancels beyond the ends, so it is integrated: panels
 * of 16 Gauss points at most 3.2 long leave 1e-15 of the value even in the tails (ten points either side of the foot: 1e-8).
 * Polygons: d ∫ (1 − e^−u)/(2u) dτ, u = d² + τ², an edge (Green). Beyond u = 40 the integrand is 1/(2u) to 4e-18, which is an
 * angle, as for the quartic; inside the same panels do (16 points in one tangent: 3e-7).
 */
import { exp, expm1 } from '../math/exp.ts';
import { PI } from '../math/trig.ts';
import type { Dimension, Step } from './change.ts';
import { angleOutside, clamped } from './clip.ts';
import type { EdgeFrame, Integral, Kernel, LineFrame } from './kernel.ts';
import { Nodes, sumLine } from './nodes.ts';
import { S } from './params.ts';

/** squared distance, beyond the nearest, at which 4e-18 is left */
const REACH2 = 40;
const PANEL = 3.2;
/** r² at which (1 + 4πr²) f² is largest */
const STEEPEST = 0.5 - 0.25 / PI;
const nodes = new Nodes();

export const gaussian: Kernel = {
  name: 'gaussian',
  label: 'Gaussian',
  params: [S],
  homogeneity: 0,
  support: Infinity,
  floor2: { line: 0, plate: 0 },
  unit: ({ s = S.default }) => 1 / s,
  value: (r2) => exp(-r2),
  slope: (r2) => -exp(-r2),
  change: { type: 'absolute', slopes },
  line,
  edge,
  wholeLine: (r2) => Math.sqrt(PI) * exp(-r2),
  wholePlane: (r2) => PI * exp(-r2),
};

/**
 * The first derivative along e is −2x f, the second (4x² − 2) f, x the part of the distance along e. Integrals over lines and
 * planes: in closed form where x is across, half of it along; 4x² f integrates to what −2f needs to come to 2f again.
 */
function slopes(step: Step, dimension: Dimension): void {
  const r2 = step.near * step.near;
  const f = exp(-r2);
  const [line, bend] = [Math.max(r2, STEEPEST), Math.max(r2, 1)];
  switch (dimension) {
    case 0:
      step.slope = r2 < 0.5 ? Math.SQRT2 * exp(-0.5) : 2 * Math.sqrt(r2) * f;
      step.bend = r2 < 1.5 ? Math.max(2 * f, 4 * exp(-1.5)) : (4 * r2 - 2) * f;
      return;
    case 1:
      step.slope = Math.sqrt(1 + 4 * PI * line) * exp(-line);
      step.bend = 2 * Math.sqrt(PI) * Math.max(f, 2 * bend * exp(-bend));
      return;
    case 2:
      step.slope = Math.sqrt(PI * (1 + 4 * PI * line)) * exp(-line);
      step.bend = 2 * PI * Math.max(1 + r2, 2 * r2) * f;
  }
}

function line(frame: LineFrame, out: Integral): void {
  const { rho2, alpha, beta } = frame;
  const nearest = alpha > 0 ? alpha : beta < 0 ? beta : 0;
  const reach = Math.sqrt(nearest * nearest + REACH2);
  nodes.panels(clamped(alpha, reach), clamped(beta, reach), PANEL);
  for (let i = 0; i < nodes.count; i++) {
    const tau = nodes.tau[i]!;
    const f = exp(-(rho2 + tau * tau));
    nodes.value[i] = f;
    nodes.slope[i] = -f;
  }
  sumLine(frame, nodes, out);
}

function edge({ d, alpha, beta, z, slopes }: EdgeFrame, out: Integral): void {
  const g = Math.sqrt(Math.max(REACH2 - d * d, 0));
  const low = clamped(alpha, g);
  const high = clamped(beta, g);
  nodes.panels(low, high, PANEL);
  let value = 0;
  let across = 0;
  for (let i = 0; i < nodes.count; i++) {
    const u = d * d + nodes.tau[i]! * nodes.tau[i]!;
    const grown = expm1(-u);
    const weight = nodes.weight[i]!;
    value += weight * (u > 0 ? -grown / u : 1);
    across -= weight * (1 + grown);
  }
  const above = exp(-z * z);
  out[0] = 0.5 * above * (d * value + angleOutside(d, alpha, beta, low, high));
  if (!slopes) return;
  out[1] = above * across;
  out[2] = -2 * z * out[0];
}
