/** Radii become weights and curves segments before they are bound; points, segments and polygons stay what they are. */
import type { Kernel, KernelParams } from '../kernel/kernel.ts';
import { type ArcSkel, expandArc } from '../skeleton/arc.ts';
import { expandNurbs, type NurbsSkel } from '../skeleton/nurbs.ts';
import { expandPolyline, type PolylineSkel } from '../skeleton/polyline.ts';
import { expandProfile, type ProfileSkel } from '../skeleton/profile.ts';
import { expandQuadratic, type QuadraticSkel } from '../skeleton/quadratic.ts';
import { hasRadii, type RoundSkel, weighted } from '../skeleton/radii.ts';
import { FieldError } from '../skeleton/skeleton.ts';
import type { Skel } from '../skeleton/skels.ts';

export type CurveSkel = PolylineSkel | NurbsSkel | ProfileSkel | ArcSkel | QuadraticSkel;
export type AnySkel = Skel | CurveSkel | RoundSkel;

/** FieldError for what cannot be followed. */
export function expanded(
  given: AnySkel,
  kernel: Kernel,
  params: KernelParams,
  threshold: number,
): readonly Skel[] {
  const skel = hasRadii(given) ? weighted(given, kernel, params, threshold) : given;
  switch (skel.type) {
    case 'point':
    case 'segment':
    case 'polygon':
      return [skel];
    case 'polyline':
      return expandPolyline(skel);
    case 'nurbs':
      return expandNurbs(skel);
    case 'profile':
      return expandProfile(skel);
    case 'arc':
      return expandArc(skel, kernel, params);
    case 'quadratic':
      return expandQuadratic(skel, kernel, params);
    default:
      throw new FieldError(`unknown skel '${(skel as { type: string }).type}'`);
  }
}
