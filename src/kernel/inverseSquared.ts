/**
 * The inverse squared kernel 1/r² (Jin & Tai 2002), in units of the skel's size.
 *
 * Segments: evenMoments.ts. Polygons, which no paper has: value by quadrature, gradient closed (powerEdge.ts); on
 * the plate itself it diverges like a logarithm.
 */
import { PI } from '../math/trig.ts';
import { powerChange } from './change.ts';
import { LINE_FLOOR2, PLATE_FLOOR2 } from './floor.ts';
import { inversePower } from './inversePower.ts';
import type { Kernel } from './kernel.ts';
import { powerEdge } from './powerEdge.ts';

export const inverseSquared: Kernel = {
  name: 'inverseSquared',
  label: 'Inverse squared',
  params: [],
  homogeneity: -2,
  support: Infinity,
  floor2: { line: LINE_FLOOR2, plate: PLATE_FLOOR2[2] },
  unit: (_, size) => size,
  value: (r2) => 1 / r2,
  slope: (r2) => -1 / (r2 * r2),
  change: powerChange(0, 2),
  line: (frame, out) => inversePower(frame, Math.max(frame.rho2, frame.floor2), 2, out),
  edge: (frame, out) => powerEdge(frame, Math.max(frame.z * frame.z, frame.floor2), 2, out),
  wholeLine: (r2) => PI / Math.sqrt(r2),
  wholePlane: null,
};
