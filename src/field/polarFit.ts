/**
 * A drawn loop becomes a polar profile (Tai et al. appendix A).
 *
 * Theory: least squares of r_{k,j} against samples of R(θ). Departure: one joint system of 24 unknowns in which the
 * joints are already the halves of their neighbours. The paper's order (average two samples at each joint, fit, then move
 * the joints) is up to 250 times worse: ellipse 0.017 instead of 0.0016, five-pointed star 0.080 instead of 0.0084.
 */
import { leastSquares } from '../math/lstsq.ts';
import { cos, sin, TAU } from '../math/trig.ts';
import { cross2, dot2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import { FieldError } from '../skeleton/skeleton.ts';
import { controlRadii, LEAST_RADIUS, type PolarProfile, PROFILE_SEGMENTS } from './polarProfile.ts';
import { type StarCentre, starCentre } from './starCentre.ts';

export interface FittedProfile {
  readonly profile: PolarProfile;
  /** what in the drawing became the skel */
  readonly centre: StarCentre;
  /** some parts of the loop were hidden from the centre, and were left out */
  readonly isStar: boolean;
}

/** an odd number, so that few samples fall on joints */
const SAMPLES = 361;

/**
 * Scaled to area π, so that a drawn circle changes nothing. FieldError for fewer than three points or a loop without
 * area; either orientation.
 */
export function fitPolarProfile(loop: readonly Vec2[]): FittedProfile {
  const centre = starCentre(loop);
  const samples = Array.from({ length: SAMPLES }, (_, i) =>
    farthestHit(loop, centre.at, (i * TAU) / SAMPLES),
  );
  const radii = fitRadii(samples);
  const size = Math.sqrt(profileArea(radii) / Math.PI);
  if (!(size > 0)) throw new FieldError('the loop has no area');
  const profile = { type: 'polar', radii: radii.map((r) => Math.max(r / size, LEAST_RADIUS)) } as const;
  return { profile, centre, isStar: centre.seesAll };
}

/** The 24 radii nearest to samples of R at even angles. */
export function fitRadii(samples: readonly number[]): number[] {
  const count = 2 * PROFILE_SEGMENTS;
  const rows = samples.map((_, i) => {
    const u = (i * PROFILE_SEGMENTS) / samples.length;
    const k = Math.floor(u);
    const t = u - k;
    const s = 1 - t;
    const row = new Array<number>(count).fill(0);
    const addTo = (index: number, share: number) => {
      row[(index + count) % count]! += share;
    };
    const [start, end] = [0.5 * s * s * s, 0.5 * t * t * t];
    addTo(2 * k - 1, start);
    addTo(2 * k, start + 3 * s * s * t);
    addTo(2 * k + 1, end + 3 * s * t * t);
    addTo(2 * k + 2, end);
    return row;
  });
  return leastSquares(rows, samples);
}

/** ½ ∫ R² dθ, exactly: 10 products of Bernstein polynomials a segment. */
export function profileArea(radii: readonly number[]): number {
  const control = controlRadii(radii);
  const binomial = [1, 3, 3, 1];
  const sixth = [1, 6, 15, 20, 15, 6, 1];
  let sum = 0;
  for (let k = 0; k < PROFILE_SEGMENTS; k++) {
    for (let i = 0; i < 4; i++) {
      for (let j = 0; j < 4; j++) {
        const share = (binomial[i]! * binomial[j]!) / (7 * sixth[i + j]!);
        sum += share * control[4 * k + i]! * control[4 * k + j]!;
      }
    }
  }
  return (0.5 * sum * TAU) / PROFILE_SEGMENTS;
}

/** Where the ray leaves the loop for good; 0 when it meets nothing. */
function farthestHit(loop: readonly Vec2[], centre: Vec2, angle: number): number {
  const ray: Vec2 = [cos(angle), sin(angle)];
  let farthest = 0;
  loop.forEach((p, i) => {
    const a = sub2(p, centre);
    const b = sub2(loop[(i + 1) % loop.length]!, centre);
    const [left, right] = [cross2(ray, a), cross2(ray, b)];
    // half open, so that a corner belongs to one edge
    if (left < 0 === right < 0) return;
    const t = left / (left - right);
    farthest = Math.max(farthest, dot2(ray, a) * (1 - t) + dot2(ray, b) * t);
  });
  return farthest;
}
