/**
 * The quartic polynomial (1 − r²/R²)² within R (Zhu et al. 2011 §3.1), in units of R: nothing beyond.
 *
 * Segments: clipped to the support, where four Gauss points are exact for weights up to degree 3, gradient included
 * (the integrand has degree 7). Polygons: Green, per edge without lists of intersections: three exact points inside the disc
 * and the angle of what is outside. Zhu's (12) is right but sorts at most sixteen intersections; winding numbers with
 * inside angles only are cheaper but wrong for points exactly over an edge or a vertex.
 */
import { GAUSS } from '../math/gaussLegendre.ts';
import { PI } from '../math/trig.ts';
import type { Dimension, Step } from './change.ts';
import { angleOutside, clamped } from './clip.ts';
import type { EdgeFrame, Integral, Kernel, LineFrame } from './kernel.ts';
import { Nodes, sumLine } from './nodes.ts';
import { R } from './params.ts';

const nodes = new Nodes();
/** g² at which the slope of a line is largest, and of a plane */
const STEEPEST_LINE = 2304 / 2964;
const STEEPEST_PLANE = (16 * PI * PI) / (5 * (4 * PI * PI - 256 / 225));

export const quartic: Kernel = {
  name: 'quartic',
  label: 'Quartic polynomial',
  params: [R],
  homogeneity: 0,
  support: 1,
  floor2: { line: 0, plate: 0 },
  unit: ({ R: radius = R.default }) => radius,
  value: (r2) => (r2 < 1 ? (1 - r2) * (1 - r2) : 0),
  slope: (r2) => (r2 < 1 ? -2 * (1 - r2) : 0),
  change: { type: 'absolute', slopes },
  line,
  edge,
  wholeLine: (r2) => (r2 < 1 ? (16 / 15) * (1 - r2) * (1 - r2) * Math.sqrt(1 - r2) : 0),
  wholePlane: (r2) => (r2 < 1 ? (PI / 3) * (1 - r2) * (1 - r2) * (1 - r2) : 0),
};

/**
 * The first derivative along e is −4x (1 − r²), the second 8x² − 4 (1 − r²), x the part of the distance along e. Integrals over
 * lines and planes: in closed form where x is across, half of it along; g² = 1 − r², each no less than farther away.
 */
function slopes(step: Step, dimension: Dimension): void {
  const r2 = step.near * step.near;
  const g2 = Math.max(1 - r2, 0);
  const g = Math.sqrt(g2);
  switch (dimension) {
    case 0:
      step.slope = r2 < 1 / 3 ? 8 / Math.sqrt(27) : 4 * Math.sqrt(r2) * g2;
      step.bend = g2 > 0 ? 8 : 0;
      return;
    case 1: {
      const h = Math.min(g2, STEEPEST_LINE);
      step.slope = h * Math.sqrt(h * (256 / 9 - (247 / 9) * h));
      step.bend = r2 < 2 / 3 ? Math.max((16 / 3) * g2 * g, 32 / Math.sqrt(27)) : 16 * g * r2;
      return;
    }
    case 2: {
      const h = Math.min(g2, STEEPEST_PLANE);
      step.slope = h * h * Math.sqrt(4 * PI * PI * (1 - h) + (256 / 225) * h);
      step.bend = 2 * PI * (r2 < 0.5 ? 1 : 4 * r2 * g2);
    }
  }
}

function line(frame: LineFrame, out: Integral): void {
  const g = frame.rho2 < 1 ? Math.sqrt(1 - frame.rho2) : 0;
  const low = clamped(frame.alpha, g);
  const high = clamped(frame.beta, g);
  nodes.gauss(GAUSS[4], low, high);
  for (let i = 0; i < 4; i++) {
    const tau = nodes.tau[i]!;
    const inside = (g - tau) * (g + tau);
    nodes.value[i] = inside * inside;
    nodes.slope[i] = -2 * inside;
  }
  sumLine(frame, nodes, out);
}

function edge({ d, alpha, beta, z, slopes }: EdgeFrame, out: Integral): void {
  const r2 = Math.max(1 - z * z, 0);
  const g = Math.sqrt(Math.max(r2 - d * d, 0));
  const low = clamped(alpha, g);
  const high = clamped(beta, g);
  const angle = angleOutside(d, alpha, beta, low, high);
  nodes.gauss(GAUSS[3], low, high);
  let [value, across, along] = [0, 0, 0];
  for (let i = 0; i < 3; i++) {
    const u = d * d + nodes.tau[i]! * nodes.tau[i]!;
    const weight = nodes.weight[i]!;
    value += weight * (3 * r2 * r2 - 3 * r2 * u + u * u);
    across -= weight * (r2 - u) * (r2 - u);
    along += weight * (2 * r2 - u);
  }
  out[0] = (d * value + r2 * r2 * r2 * angle) / 6;
  if (!slopes) return;
  out[1] = across;
  out[2] = -z * (d * along + r2 * r2 * angle);
}
