/**
 * The Cauchy kernel 1/(1 + s²r²)² (Zhu et al. 2011 §3.2; Jin & Tai 2002), in units of 1/s.
 *
 * Segments: cauchyLine.ts for linear weights, inversePower.ts for others. Polygons: cauchyEdge.ts: one arc
 * tangent an edge, where Zhu's (16) has four, lacks its bracket, and divides by a component of the edge.
 */
import { PI } from '../math/trig.ts';
import { cauchyEdge } from './cauchyEdge.ts';
import { cauchyLine } from './cauchyLine.ts';
import { powerChange } from './change.ts';
import { inversePower } from './inversePower.ts';
import type { Kernel } from './kernel.ts';
import { S } from './params.ts';

export const cauchy: Kernel = {
  name: 'cauchy',
  label: 'Cauchy',
  params: [S],
  homogeneity: 0,
  support: Infinity,
  floor2: { line: 0, plate: 0 },
  unit: ({ s = S.default }) => 1 / s,
  value: (r2) => 1 / ((1 + r2) * (1 + r2)),
  slope: (r2) => -2 / ((1 + r2) * (1 + r2) * (1 + r2)),
  change: powerChange(1, 4),
  line: (frame, out) => inversePower(frame, 1 + frame.rho2, 4, out),
  linear: cauchyLine,
  edge: cauchyEdge,
  wholeLine: (r2) => (0.5 * PI) / ((1 + r2) * Math.sqrt(1 + r2)),
  wholePlane: (r2) => PI / (1 + r2),
};
