/**
 * Arc of a circle with a linear weight, followed by as many chords as the field error asked for needs.
 *
 * Theory: a chord and its arc are paired by the fraction of their lengths, the chord's weight multiplied by arc/chord, so
 * that both carry the same total. Pairs are farthest apart in the middle, R (1 − cos h), h half the angle (checked for
 * h ≤ π/8), and allowedShift (curve.ts) says how far they may be.
 * Departure: instead of the usual fixed number of pieces. The true error was 0.11–0.14 of the bound. Tried: the largest
 * slope times ∫|w|, whose bound is up to 2.3 times larger (1.5 times as many chords).
 */
import type { Kernel, KernelParams } from '../kernel/kernel.ts';
import { cos, PI, sin, TAU } from '../math/trig.ts';
import { add3, cross3, dot3, length3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { checkNumbers, checkPlaces } from './binding.ts';
import { allowedShift, distance3, type Fidelity, MOST_PIECES, steepness } from './curve.ts';
import { FieldError } from './skeleton.ts';
import type { SegmentSkel } from './skels.ts';

export interface ArcSkel extends Fidelity {
  readonly type: 'arc';
  readonly centre: Vec3;
  readonly start: Vec3;
  /** axis of the circle, any length; only its part across start − centre counts */
  readonly axis: Vec3;
  /** counter-clockwise about the axis, radians, −2π…2π, not 0 */
  readonly angle: number;
  /** at both ends */
  readonly weights: readonly [start: number, end: number];
}

/** FieldError for what is no arc, and when more than MOST_PIECES chords were needed. */
export function expandArc(arc: ArcSkel, kernel: Kernel, params: KernelParams): SegmentSkel[] {
  const { centre, start, axis, angle, weights } = arc;
  checkPlaces('the places of an arc', [...centre, ...start, ...axis]);
  checkNumbers('the angle and weights of an arc', [angle, ...weights]);
  if (weights.length !== 2) throw new FieldError(`an arc has 2 weights, found ${weights.length}`);
  const { x, y, radius } = circle(arc);
  const count = chordCount(arc, radius, kernel, params);
  const at = (i: number): Vec3 => {
    const turn = (angle * i) / count;
    return add3(centre, add3(scale3(x, radius * cos(turn)), scale3(y, radius * sin(turn))));
  };
  const weight = (i: number) => weights[0] + ((weights[1] - weights[0]) * i) / count;
  return Array.from({ length: count }, (_, i) => {
    const [a, b] = [at(i), at(i + 1)];
    const chord = distance3(a, b);
    const denser = (radius * Math.abs(angle)) / count / chord;
    const slope = (weight(i + 1) - weight(i)) / chord;
    const constant = denser * weight(i);
    return { type: 'segment', a, b, weights: slope === 0 ? [constant] : [constant, denser * slope] };
  });
}

function circle({ centre, start, axis, angle }: ArcSkel): { x: Vec3; y: Vec3; radius: number } {
  const radius = distance3(centre, start);
  if (!(radius > 0 && radius < Infinity)) throw new FieldError('an arc needs a radius above 0 mm');
  if (!(Math.abs(angle) > 0 && Math.abs(angle) <= TAU)) {
    throw new FieldError(`angle must be −2π…2π and not 0, got ${angle}`);
  }
  const x = scale3(sub3(start, centre), 1 / radius);
  const across = sub3(axis, scale3(x, dot3(axis, x)));
  const length = length3(across);
  if (!(length > 1e-6 * length3(axis))) throw new FieldError('axis must not point along start − centre');
  return { x, y: cross3(scale3(across, 1 / length), x), radius };
}

function chordCount(arc: ArcSkel, radius: number, kernel: Kernel, params: KernelParams): number {
  const { fieldError, distance, angle, weights } = arc;
  if (!(fieldError > 0)) throw new FieldError(`fieldError must be above 0, got ${fieldError}`);
  // a point beside the arc may be nearer to the chord: half the distance is kept
  const steep = steepness(kernel, params, distance / 2);
  const weight = Math.max(Math.abs(weights[0]), Math.abs(weights[1]));
  const turn = Math.abs(angle);
  // what a ball cuts from a circle is at most half its circumference, or all of the circle
  const shift = allowedShift(steep, fieldError, weight, radius * turn, turn > PI ? TAU : PI);
  const apart = Math.min(shift, distance > 0 ? distance / 2 : Infinity);
  // R (1 − cos h) = 2 R sin²(h/2) ≤ apart
  const half = Math.min(2 * Math.sqrt(apart / (2 * radius)), PI / 8);
  const count = Math.ceil(Math.abs(angle) / (2 * half));
  if (!(count <= MOST_PIECES))
    throw new FieldError(`fieldError ${fieldError} needs more than ${MOST_PIECES} chords`);
  return count;
}
