/**
 * The inverse quintic kernel 1/r⁵ (Jin & Tai 2002), in units of the skel's size.
 *
 * Segments: oddMoments.ts. Polygons: from the solid angle by recurrence in n (powerEdge.ts).
 */
import { PI } from '../math/trig.ts';
import { powerChange } from './change.ts';
import { LINE_FLOOR2, PLATE_FLOOR2 } from './floor.ts';
import { inversePower } from './inversePower.ts';
import type { Kernel } from './kernel.ts';
import { powerEdge } from './powerEdge.ts';

export const inverseQuintic: Kernel = {
  name: 'inverseQuintic',
  label: 'Inverse quintic',
  params: [],
  homogeneity: -5,
  support: Infinity,
  floor2: { line: LINE_FLOOR2, plate: PLATE_FLOOR2[5] },
  unit: (_, size) => size,
  value: (r2) => 1 / (r2 * r2 * Math.sqrt(r2)),
  slope: (r2) => -2.5 / (r2 * r2 * r2 * Math.sqrt(r2)),
  change: powerChange(0, 5),
  line: (frame, out) => inversePower(frame, Math.max(frame.rho2, frame.floor2), 5, out),
  edge: (frame, out) => powerEdge(frame, Math.max(frame.z * frame.z, frame.floor2), 5, out),
  wholeLine: (r2) => 4 / (3 * r2 * r2),
  wholePlane: (r2) => (2 * PI) / (3 * r2 * Math.sqrt(r2)),
};
