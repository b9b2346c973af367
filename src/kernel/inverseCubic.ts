/**
 * The inverse cubic kernel 1/r³ (Jin & Tai 2002), in units of the skel's size.
 *
 * Segments: oddMoments.ts. Polygons: the solid angle over |z|.
 */
import { PI } from '../math/trig.ts';
import { powerChange } from './change.ts';
import { LINE_FLOOR2, PLATE_FLOOR2 } from './floor.ts';
import { inversePower } from './inversePower.ts';
import type { Kernel } from './kernel.ts';
import { powerEdge } from './powerEdge.ts';

export const inverseCubic: Kernel = {
  name: 'inverseCubic',
  label: 'Inverse cubic',
  params: [],
  homogeneity: -3,
  support: Infinity,
  floor2: { line: LINE_FLOOR2, plate: PLATE_FLOOR2[3] },
  unit: (_, size) => size,
  value: (r2) => 1 / (r2 * Math.sqrt(r2)),
  slope: (r2) => -1.5 / (r2 * r2 * Math.sqrt(r2)),
  change: powerChange(0, 3),
  line: (frame, out) => inversePower(frame, Math.max(frame.rho2, frame.floor2), 3, out),
  edge: (frame, out) => powerEdge(frame, Math.max(frame.z * frame.z, frame.floor2), 3, out),
  wholeLine: (r2) => 2 / r2,
  wholePlane: (r2) => (2 * PI) / Math.sqrt(r2),
};
