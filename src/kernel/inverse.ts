/**
 * The inverse kernel 1/r (Jin & Tai 2002): the potential of a charge, in units of the skel's size.
 *
 * Segments: oddMoments.ts. Polygons, which no paper has: d ∫ r⁻¹ − z² (solid angle)/|z|, finite on the plate itself (powerEdge.ts).
 * Whole lines and planes have no finite field: weights need the length or the area of the skel.
 */

import { powerChange } from './change.ts';
import { LINE_FLOOR2, PLATE_FLOOR2 } from './floor.ts';
import { inversePower } from './inversePower.ts';
import type { Kernel } from './kernel.ts';
import { powerEdge } from './powerEdge.ts';

export const inverse: Kernel = {
  name: 'inverse',
  label: 'Inverse',
  params: [],
  homogeneity: -1,
  support: Infinity,
  floor2: { line: LINE_FLOOR2, plate: PLATE_FLOOR2[1] },
  unit: (_, size) => size,
  value: (r2) => 1 / Math.sqrt(r2),
  slope: (r2) => -0.5 / (r2 * Math.sqrt(r2)),
  change: powerChange(0, 1),
  line: (frame, out) => inversePower(frame, Math.max(frame.rho2, frame.floor2), 1, out),
  edge: (frame, out) => powerEdge(frame, Math.max(frame.z * frame.z, frame.floor2), 1, out),
  wholeLine: null,
  wholePlane: null,
};
