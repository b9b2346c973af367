/**
 * Rays onto a sum of skels as Zhu et al. 2011 §4.2.3 cast them: through bounding volumes (zhuVolumes.ts) in steps of half their radius;
 * where the slope along the ray has turned without a hit, back by half the step, and so on; then bisection. To be compared with
 * raycast.ts (zhuImage.ts): every value asks all skels, and a surface that lies between two steps with the same slope is passed.
 *
 * Departure: the paper does not say when stepping back ends; here at `SMALLEST` of the step, and the march goes on.
 */
import type { Vec3 } from '../math/vec.ts';
import { WITH_GRADIENT } from '../skeleton/work.ts';
import { bindField } from './bind.ts';
import type { SkelsNode } from './node.ts';
import { piecesOf } from './pieces.ts';
import type { TreeField } from './treeField.ts';
import { boundingVolumes, OVERLAP, type Volume, within } from './zhuVolumes.ts';

/** parts of a step */
const SMALLEST = 1 / 64;
/** halvings between a place outside and one inside */
const BISECTIONS = 20;

export class ZhuMarch {
  /** asked of skels, in values of one (skeleton/work.ts) */
  work = 0;
  readonly volumes: readonly Volume[];
  readonly field: TreeField;
  readonly #skels: number;
  readonly #value = new Float64Array(4);

  /** FieldError for a tree without a field; skels must be without cross sections. */
  constructor(node: SkelsNode, overlap = OVERLAP) {
    this.field = bindField(node);
    this.#skels = piecesOf(node).length;
    this.volumes = boundingVolumes(node, overlap);
  }

  /** mm along the ray to the hit; null for none from `nearest` mm on. */
  cast(from: Vec3, ray: Vec3, nearest = 0): number | null {
    const parts = this.volumes
      .flatMap((volume) => within(volume, from, ray).map(([s, t]) => ({ s, t, step: 0.5 * volume.radius })))
      .filter(({ t }) => t > nearest)
      .sort((a, b) => a.s - b.s);
    let done = nearest;
    for (const { s, t, step } of parts) {
      const hit = t > done ? this.#march(from, ray, Math.max(s, done), t, step) : null;
      if (hit !== null) return hit;
      done = Math.max(done, t);
    }
    return null;
  }

  #march(from: Vec3, ray: Vec3, start: number, end: number, step: number): number | null {
    let last = start;
    let wasRising = true;
    for (let t = start; ; t = Math.min(t + step, end)) {
      const { value, slope } = this.#at(from, ray, t);
      if (value > 0) return this.#bisected(from, ray, last, t);
      if (slope < 0 && wasRising && t > start) {
        const inside = this.#back(from, ray, t, step);
        if (inside !== null) return this.#bisected(from, ray, last, inside);
      }
      wasRising = slope >= 0;
      last = t;
      if (t >= end) return null;
    }
  }

  /** From a place behind the largest value towards it, by half of what was gone each time. */
  #back(from: Vec3, ray: Vec3, t: number, step: number): number | null {
    let at = t;
    for (let by = 0.5 * step; by > SMALLEST * step; by *= 0.5) {
      const { value, slope } = this.#at(from, ray, at - by);
      if (value > 0) return at - by;
      // still behind: on from there; before it: back to where one was
      if (slope < 0) at -= by;
    }
    return null;
  }

  #bisected(from: Vec3, ray: Vec3, outside: number, inside: number): number {
    let [low, high] = [outside, inside];
    for (let i = 0; i < BISECTIONS && high > low; i++) {
      const middle = 0.5 * (low + high);
      this.work += this.#skels;
      const [x, y, z] = place(from, ray, middle);
      if (this.field.value(x, y, z) > 0) high = middle;
      else low = middle;
    }
    return high;
  }

  #at(from: Vec3, ray: Vec3, t: number) {
    this.work += WITH_GRADIENT * this.#skels;
    const value = this.#value;
    this.field.evaluate(...place(from, ray, t), value);
    return { value: value[0]!, slope: value[1]! * ray[0] + value[2]! * ray[1] + value[3]! * ray[2] };
  }
}

const place = (from: Vec3, ray: Vec3, t: number): Vec3 => [
  from[0] + t * ray[0],
  from[1] + t * ray[1],
  from[2] + t * ray[2],
];
