/**
 * Rays onto the surface of a field itself: through bricks (bricks.ts), in each through balls that surely hold none (rayBalls.ts), then by its
 * near list, in steps that surely do not go through one (rayAhead.ts). Once it is sure where the sign has changed at the latest, or where
 * steps have become shorter than a part of a pixel and the sign decides, what lies between is narrowed down.
 *
 * Theory: Zhu et al. §4.2 step by half the radius of bounding volumes, and step back where the slope has turned (zhuMarch.ts); a surface
 * may be passed. Here the first hit is the first but for what is thinner along the ray than `FINEST` of a pixel.
 */
import type { Vec3 } from '../math/vec.ts';
import { INSIDE, OUTSIDE } from './bricks.ts';
import type { Near, Tally } from './near.ts';
import type { Located } from './polygonize.ts';
import { type BrickBalls, ballsIn, type RayBalls } from './rayBalls.ts';
import { RayWalk, type Walked, walked } from './rayWalk.ts';

/** of a pixel: shorter steps are none */
const FINEST = 1 / 64;
/** evaluations between the last two places; mostly one is enough */
const NARROWINGS = 40;
/** of a pixel: after a step of Newton's as short nothing is left to be seen */
const CLOSE = 1e-6;
/** of a pixel: a ray that passes a surface so near may have passed what is thinner than a pixel */
const BESIDE = 0.5;
/** pixels: where the surface is not reached for longer, it is not so near */
const AHEAD = 8;
/** pixels: no balls that are nearer to each other */
const RAYS = 2;
/** shortest steps: what is surely free for longer is not yet worth a look for the place where it ends */
const FAR = 16;
/** of the longest side of the lattice: what near lists miss may move the hit along the ray so far before all skels are asked */
const MISSED = 3e-4;
/** steps with all skels */
const POLISHES = 3;
/** of the longest side: a shorter one is the last */
const POLISHED = 1e-5;

export interface Ray {
  readonly from: Vec3;
  /** unit */
  readonly along: Vec3;
  /** mm along it: where it begins, −Infinity for all of the line */
  readonly nearest: number;
  /** mm: of a pixel where the ray begins, and more for each millimetre along it */
  readonly pixel: number;
  readonly growth: number;
}

/** Mutable: filled again for each ray. */
export class Hit {
  /** mm along the ray */
  t = 0.5;
  readonly at: [number, number, number] = [0, 0, 0];
  /** unit, out of the body; 0 where it has no slope */
  readonly normal: [number, number, number] = [0, 0, 0];
  readonly colour = new Float64Array(3);
}

const value = new Float64Array(4);

export class Raycaster {
  readonly #whole: Near;
  readonly #tally: Tally;
  readonly #walk: RayWalk;
  readonly #walked: Walked;
  readonly #size: number;
  #ray: Ray = { from: [0, 0, 0], along: [1, 0, 0], nearest: 0, pixel: 1, growth: 0 };
  readonly hit = new Hit();
  /** whether the last ray passed a surface by less than `BESIDE` before it met one, if it did: it came as near, and went away again */
  passed = false;
  /** the value next to 0 since the ray has been so near to a surface, without its sign; Infinity: it has not been */
  #nearest = Infinity;
  readonly #balls: BrickBalls;

  constructor({ whole, tally, bricks }: Pick<Located, 'whole' | 'tally' | 'bricks'>) {
    this.#whole = whole;
    this.#tally = tally;
    this.#walked = walked(bricks);
    this.#walk = new RayWalk(this.#walked);
    this.#balls = ballsIn(bricks);
    const { counts, step } = bricks.lattice;
    this.#size = (Math.max(...counts) - 1) * step;
  }

  /** what has been asked of skels, in values of one (skeleton/work.ts) */
  get work(): number {
    return this.#tally.work;
  }

  /** Whether the ray meets the surface within `farthest` mm, in which case `hit` says where. */
  cast(ray: Ray, farthest = Infinity): boolean {
    this.passed = false;
    this.#nearest = Infinity;
    const isHit = this.#meets(ray, farthest);
    // nobody saw it go away, but it met nothing
    if (!isHit && this.#nearest < Infinity) this.passed = true;
    return isHit;
  }

  #meets(ray: Ray, farthest: number): boolean {
    this.#ray = ray;
    const walk = this.#walk;
    if (!walk.begin(ray.from, ray.along, ray.nearest, farthest)) return false;
    const { active } = this.#walked.bricks;
    // outside, where it comes in from beyond
    let isInside: boolean | null = walk.entered < 0 ? null : false;
    do {
      const near = active[walk.state]?.near ?? null;
      // nothing is as near in a brick that holds no surface
      if (walk.state === OUTSIDE && this.#nearest < Infinity) this.passed = true;
      if (isInside === null) isInside = near ? this.#valueAt(near, walk.start) > 0 : walk.state === INSIDE;
      if (near ? this.#through(near, isInside) : walk.state !== (isInside ? INSIDE : OUTSIDE)) {
        return near ? true : this.#border();
      }
    } while (walk.next());
    return false;
  }

  /** The surface in a brick; false where there is none. */
  #through(near: Near, isInside: boolean): boolean {
    const { start, stop } = this.#walk;
    const { pixel, growth, along } = this.#ray;
    const balls = this.#balls.of(this.#walk.state);
    // a ball costs a look, and pays where several rays come by
    const isFine = balls.apart > RAYS * (pixel + growth * Math.max(start, 0));
    let before = -Infinity;
    let atBefore = 0;
    for (let t = start; ; ) {
      const finest = FINEST * (pixel + growth * t);
      const free = isFine ? this.#free(balls, t, stop, isInside, FAR * finest) : t;
      if (free > t) {
        if (free >= stop) return false;
        // nothing is known of the surface from before a ball
        before = -Infinity;
      }
      t = free;
      const [x, y, z] = this.#place(t);
      const value = near.look(along, x, y, z, stop - t);
      if (value > 0 !== isInside) {
        if (before === -Infinity) return this.#border(t);
        return this.#between(
          near,
          before,
          t,
          before + ((t - before) * atBefore) / (atBefore - value),
          isInside,
        );
      }
      const clear = near.clear();
      if (t + clear < stop && clear < FAR * finest) {
        const reached = near.reached(clear);
        if (t + reached <= stop) {
          return this.#between(near, t + clear, t + reached, t + 0.5 * (clear + reached), isInside);
        }
      }
      if (!this.passed) this.#follow(near, Math.abs(value), clear, pixel + growth * t);
      if (t + clear >= stop) return false;
      before = t;
      atBefore = value;
      t = Math.min(t + Math.max(clear, finest), stop);
      if (!(t > before)) return false;
    }
  }

  /**
   * Once the surface is so near that a thin body might be missed, the value goes on towards 0, or the ray has passed. Whether bounds say so again is no
   * sign: they differ from brick to brick, and a quarter of all hits would have passed something. So a sum that does not change any more a radius
   * away from its skels, before a body less than two bricks behind it, is not told.
   */
  #follow(near: Near, value: number, clear: number, pixel: number): void {
    if (this.#nearest < Infinity) this.passed = value > this.#nearest;
    else if (!this.#isBeside(near, clear, pixel)) return;
    this.#nearest = value;
  }

  /** `clear`: of the last look. */
  #isBeside(near: Near, clear: number, pixel: number): boolean {
    if (clear > AHEAD * pixel) return false;
    return (near.around() || clear) < BESIDE * pixel;
  }

  /** Where the balls of the brick leave the ray that comes in at `t`; they are asked until they help on by less than `least` mm. */
  #free(balls: RayBalls, t: number, stop: number, isInside: boolean, least: number): number {
    const { along, pixel, growth } = this.#ray;
    for (let at = t; ; ) {
      const [x, y, z] = this.#place(at);
      const free = balls.clear(along, x, y, z, isInside, BESIDE * (pixel + growth * at));
      if (!(free > least)) return at;
      at += free;
      if (at >= stop) return stop;
    }
  }

  /** Where the ray comes into the body at the border of the lattice, or bricks that miss a little disagree about their border. */
  #border(t = this.#walk.start): true {
    const { hit } = this;
    this.#put(t);
    const { entered: axis, entry } = this.#walk;
    this.#whole.evaluate(...hit.at, value);
    this.#normal();
    if (axis >= 0 && hit.t === entry) {
      hit.normal.fill(0);
      hit.normal[axis] = this.#ray.along[axis]! > 0 ? -1 : 1;
    }
    this.#whole.colour(...hit.at, hit.colour);
    return true;
  }

  /** The hit between two places of the ray of which the second is beyond the surface; `t`: where it is likely. */
  #between(near: Near, before: number, after: number, t: number, isInside: boolean): true {
    const { hit } = this;
    this.#narrow(near, before, after, t, isInside);
    this.#polish(near);
    this.#normal();
    if (near.plain) hit.colour.set(near.plain);
    else near.colour(...hit.at, hit.colour);
    return true;
  }

  /** Newton's steps, or halves where these leave what is left. Leaves value and gradient as well. */
  #narrow(near: Near, before: number, after: number, first: number, isInside: boolean): void {
    const { hit } = this;
    const { pixel, growth } = this.#ray;
    const close = CLOSE * (pixel + growth * first);
    let [low, high, t] = [before, after, first];
    for (let i = 0; i < NARROWINGS; i++) {
      this.#put(t);
      near.evaluate(...hit.at, value);
      const step = -value[0]! / this.#slope();
      if (Math.abs(step) <= close) {
        this.#put(t + step);
        return;
      }
      if (value[0]! > 0 === isInside) low = t;
      else high = t;
      t = t + step > low && t + step < high ? t + step : 0.5 * (low + high);
    }
  }

  /** Onto the surface of all skels, where what the near list misses might show. */
  #polish(near: Near): void {
    const { hit } = this;
    const slope = Math.abs(this.#slope());
    const enough = MISSED * this.#size * slope;
    if (near.error <= enough || near.errorAt(...hit.at) <= enough) return;
    // a ray that only just touches the body may pass by all of it
    const most = (2 * near.error) / slope;
    for (let i = 0; i < POLISHES; i++) {
      this.#put(hit.t);
      this.#whole.evaluate(...hit.at, value);
      const step = -value[0]! / this.#slope();
      if (!(Math.abs(step) <= most)) return;
      hit.t += step;
      if (Math.abs(step) < POLISHED * this.#size) break;
    }
    this.#put(hit.t);
  }

  /** A millimetre along the ray. */
  #slope(): number {
    const { along } = this.#ray;
    return value[1]! * along[0] + value[2]! * along[1] + value[3]! * along[2];
  }

  #normal(): void {
    const { normal } = this.hit;
    const length = -Math.sqrt(value[1]! * value[1]! + value[2]! * value[2]! + value[3]! * value[3]!);
    for (let axis = 0; axis < 3; axis++) normal[axis] = length < 0 ? value[axis + 1]! / length : 0;
  }

  #put(t: number): void {
    const { from, along } = this.#ray;
    this.hit.t = t;
    for (let axis = 0; axis < 3; axis++) this.hit.at[axis] = from[axis]! + t * along[axis]!;
  }

  #valueAt(near: Near, t: number): number {
    return near.value(...this.#place(t));
  }

  #place(t: number): [number, number, number] {
    const { from, along } = this.#ray;
    return [from[0] + t * along[0], from[1] + t * along[1], from[2] + t * along[2]];
  }
}
