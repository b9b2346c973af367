/**
 * Skels given by radii instead of weights. Each radius becomes the weight of an endless line (a lone point) with its
 * isosurface there (weight.ts), once kernel and threshold are known; where lines have no finite field (1/r), of one as long
 * as the curve, right in its middle. Between two places the weight is linear, so that the radius is not quite.
 *
 * A curve's radii are a coordinate of its points: they are subdivided with it, and become weights afterwards.
 */
import type { Kernel, KernelParams } from '../kernel/kernel.ts';
import type { Vec3 } from '../math/vec.ts';
import type { ArcSkel } from './arc.ts';
import { distance3 } from './curve.ts';
import { type NurbsSkel, nurbsPolyline } from './nurbs.ts';
import { at } from './place.ts';
import { linearSegment, type PolylineSkel } from './polyline.ts';
import { FieldError } from './skeleton.ts';
import type { PointSkel, SegmentSkel } from './skels.ts';
import { lineWeight, pointWeight } from './weight.ts';

type ByRadii<S extends { readonly weights: readonly number[] }> = Omit<S, 'weights'> & {
  /** mm, above 0; where the weights would be */
  readonly radii: S['weights'];
};

export interface RoundPoint {
  readonly type: 'point';
  readonly at: Vec3;
  /** mm, above 0 */
  readonly radius: number;
}

export interface RoundSegment {
  readonly type: 'segment';
  readonly a: Vec3;
  readonly b: Vec3;
  /** mm, above 0, at a and at b */
  readonly radii: readonly [a: number, b: number];
}

export type RoundSkel =
  | RoundPoint
  | RoundSegment
  | ByRadii<PolylineSkel>
  | ByRadii<NurbsSkel>
  | ByRadii<ArcSkel>;

/** FieldError for weights and radii at once. */
export function hasRadii<S extends { readonly type: string }>(skel: S | RoundSkel): skel is RoundSkel {
  const { radii, radius, weights, weight } = skel as Partial<Record<string, unknown>>;
  const has = radii !== undefined || radius !== undefined;
  if (has && (weights !== undefined || weight !== undefined)) {
    throw new FieldError(`a ${skel.type} has weights or radii, not both`);
  }
  return has;
}

/** The same by weights; FieldError for a radius that none reaches. */
export function weighted(
  skel: RoundSkel,
  kernel: Kernel,
  params: KernelParams,
  threshold: number,
): PointSkel | SegmentSkel | PolylineSkel | ArcSkel {
  const weights = (radii: readonly number[], length: number) => {
    if (!kernel.wholeLine && !(length > 0)) {
      throw new FieldError(`radii of the kernel ${kernel.name} need a length above 0 mm`);
    }
    const whole = kernel.wholeLine ? Infinity : length;
    return radii.map((radius, i) =>
      at(`radii[${i}]`, () => lineWeight(kernel, params, radius, threshold, whole)),
    );
  };
  switch (skel.type) {
    case 'point': {
      const { type, at: place, radius } = skel;
      const weight = at('radius', () => pointWeight(kernel, params, radius, threshold));
      return { type, at: place, weight };
    }
    case 'segment':
      return roundSegment(skel, weights);
    case 'polyline':
      return roundLine(skel, weights);
    case 'nurbs':
      return roundCurve(skel, weights);
    case 'arc':
      return roundArc(skel, weights);
    default:
      throw new FieldError(`a ${(skel as { type: string }).type} has weights, not radii`);
  }
}

/** Of radii along a curve of `length` mm. */
type Weights = (radii: readonly number[], length: number) => number[];

function roundLine({ radii, ...line }: ByRadii<PolylineSkel>, weights: Weights): PolylineSkel {
  checkCount(line.points, radii);
  return { ...line, weights: weights(radii, lengthOf(line.points, line.closed)) };
}

function roundCurve({ radii, ...curve }: ByRadii<NurbsSkel>, weights: Weights): PolylineSkel {
  checkCount(curve.points, radii);
  const { weights: along, ...line } = nurbsPolyline({ ...curve, weights: radii });
  // between control points no radius is larger or smaller: what is wrong is named here, by its own number
  weights(radii, lengthOf(line.points, line.closed));
  return roundLine({ ...line, radii: along }, weights);
}

function roundArc({ radii, ...arc }: ByRadii<ArcSkel>, weights: Weights): ArcSkel {
  if (radii.length !== 2) throw new FieldError(`an arc has 2 radii, found ${radii.length}`);
  const [start, end] = weights(radii, distance3(arc.centre, arc.start) * Math.abs(arc.angle));
  return { ...arc, weights: [start!, end!] };
}

function roundSegment({ a, b, radii }: RoundSegment, weights: Weights): SegmentSkel {
  if (radii.length !== 2) throw new FieldError(`a segment has 2 radii, found ${radii.length}`);
  const [w0, w1] = weights(radii, distance3(a, b));
  const segment = linearSegment(a, b, w0!, w1!);
  if (!segment) throw new FieldError('a segment with radii needs ends that are apart');
  return segment;
}

function checkCount(points: readonly Vec3[], radii: readonly number[]): void {
  if (radii.length === points.length) return;
  throw new FieldError(`${points.length} points need as many radii, got ${radii.length}`);
}

/** mm along the points, and back to the first where that closes them. */
export function lengthOf(points: readonly Vec3[], closed: boolean): number {
  return points.reduce((sum, p, i) => {
    const before = i > 0 || closed ? points.at(i - 1)! : p;
    return sum + distance3(before, p);
  }, 0);
}
