/**
 * Rays onto a sum of skels by spheres that surely hold no surface (Hart 1996): steps of |F| over one Lipschitz bound for all of space, the
 * sum of what each skel's slope comes to at most. Plain, to be compared with: every value asks all skels.
 */

import { bindField, boundTerms } from '../../src/field/bind.ts';
import type { SkelsNode } from '../../src/field/node.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import type { SegmentSkel } from '../../src/skeleton/skels.ts';

/** steps of one ray; who needs more gives up */
const MOST_STEPS = 20_000;
/** places beside a skel where its slope is looked at, of the kernel's width */
const PLACES = 64;
/** what lies between them */
const SAFE = 1.02;

export class SphereTracing {
  /** asked of skels, in values of one */
  work = 0;
  /** rays that gave up */
  lost = 0;
  readonly #field: ReturnType<typeof bindField>;
  readonly #skels: number;
  readonly #slope: number;

  /** Cauchy segments. */
  constructor(node: SkelsNode) {
    this.#field = bindField(node);
    this.#skels = node.skels.length;
    this.#slope = node.skels.reduce((sum, term) => {
      const [bound] = boundTerms(term, node);
      return sum + SAFE * steepest(bound!.field, term.skel as SegmentSkel, 1 / node.params.s!);
    }, 0);
  }

  /** mm along the ray to the hit, between `start` and `end`; null for none. `close`: mm from the surface. */
  cast(from: Vec3, ray: Vec3, start: number, end: number, close: number): number | null {
    let t = start;
    for (let i = 0; i < MOST_STEPS; i++) {
      this.work += this.#skels;
      const value = this.#field.value(from[0] + t * ray[0], from[1] + t * ray[1], from[2] + t * ray[2]);
      const step = -value / this.#slope;
      if (step < close) return t;
      t += step;
      if (t > end) return null;
    }
    this.lost++;
    return null;
  }
}

/** Of a segment with linear weights: straight beside its ends and its middle, and before the ends. */
function steepest(
  field: ReturnType<typeof boundTerms>[number]['field'],
  { a, b }: SegmentSkel,
  width: number,
) {
  const along = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const length = Math.hypot(...along);
  const u = along.map((x) => x / length);
  const least = u.map(Math.abs).indexOf(Math.min(...u.map(Math.abs)));
  const aside = u.map((x, i) => (i === least ? 1 : 0) - x * u[least]!);
  const size = Math.hypot(...aside);
  const value = new Float64Array(4);
  let most = 0;
  for (let share = 0; share <= 8; share++) {
    for (let i = 0; i <= PLACES; i++) {
      const r = (3 * width * i) / PLACES;
      for (const [over, out] of [
        [r, 0],
        [0, r],
      ] as const) {
        const at = a.map((x, k) => x + (share / 8) * along[k]! + (over * aside[k]!) / size - out * u[k]!);
        value.fill(0);
        field.add(at[0]!, at[1]!, at[2]!, 1, value);
        most = Math.max(most, Math.hypot(value[1]!, value[2]!, value[3]!));
      }
    }
  }
  return most;
}
