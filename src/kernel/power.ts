/**
 * The generalised Cauchy kernel (1 + s²r²)^(−n/2), 1 < n ≤ 8, in units of 1/s: a kernel whose smoothness is a parameter.
 *
 * Jin & Tai 2002 have a kernel “with smoothness control”; its definition was not in the text at hand, so this is not theirs.
 * n = 2…6 are closed (inversePower.ts, powerEdge.ts; the plate of n = 2 is sampled), other n are panels of 16 Gauss points in
 * asinh τ: 1e-12 of the whole line.
 */

import { powerChange } from './change.ts';
import { halfPower } from './halfPower.ts';
import { farLine, inversePower, powersAt } from './inversePower.ts';
import type { Integral, Kernel, LineFrame } from './kernel.ts';
import { Nodes, sumLine } from './nodes.ts';
import { N, S } from './params.ts';
import { powerEdge } from './powerEdge.ts';
import { wholeLineOfPower, wholePlaneOfPower } from './wholePower.ts';

const nodes = new Nodes();

export const power: Kernel = {
  name: 'power',
  label: 'Generalised Cauchy',
  params: [S, N],
  homogeneity: 0,
  support: Infinity,
  floor2: { line: 0, plate: 0 },
  unit: ({ s = S.default }) => 1 / s,
  value: (r2, n) => halfPower(1 + r2, n),
  slope: (r2, n) => (-0.5 * n * halfPower(1 + r2, n)) / (1 + r2),
  change: powerChange(1),
  line,
  edge: (frame, out) => powerEdge(frame, 1 + frame.z * frame.z, frame.exponent, out),
  wholeLine: (r2, n) => wholeLineOfPower(1 + r2, n),
  wholePlane: (r2, n) => wholePlaneOfPower(1 + r2, n),
};

function line(frame: LineFrame, out: Integral): void {
  const { rho2, alpha, beta, length, exponent } = frame;
  const m2 = 1 + rho2;
  const far = 2 * m2 + alpha * alpha + beta * beta > 5 * length * length;
  if (exponent <= 6 && Number.isInteger(exponent)) inversePower(frame, m2, exponent, out);
  else if (far) farLine(frame, m2, exponent, out);
  else {
    nodes.sinhPanels(Math.sqrt(m2), alpha, beta);
    powersAt(nodes, m2, exponent);
    sumLine(frame, nodes, out);
  }
}
