/**
 * What a skel's field may be within a ball: an interval, and a centred form, whose gradients a sum adds up before it takes
 * their lengths. Both hold for the values as computed: MARGIN of the largest that the skel can have there is put on either side.
 *
 * Theory: kernel/change.ts, and kernel/most.ts for balls that reach the skel. A form whose rest is larger than half the interval
 * says less than the interval, and is replaced by it: the middle, no gradient, half the width. So one near skel does not spoil
 * a sum of far ones.
 */
import { type AbsoluteChange, type RelativeChange, Step } from '../kernel/change.ts';
import { halfPower } from '../kernel/halfPower.ts';
import type { Kernel } from '../kernel/kernel.ts';
import { mostOfLine, mostOfPlate, mostOfPower } from '../kernel/most.ts';
import { type Smooth, smoothness } from '../kernel/smooth.ts';
import { type Ahead, BEND, FIRST, LOOSE, MASS, POWER, SECOND, WIDTH } from './ahead.ts';
import type { Ball } from './ball.ts';
import { Choice, type Sources } from './gaussSources.ts';
import { type Extent, type See, Sight } from './sight.ts';
import type { FieldValue, Spread } from './skeleton.ts';
import type { Taylor } from './taylor.ts';
import { POINT, WITH_GRADIENT } from './work.ts';

/** of the largest field there; values are good to 1e-12 of it */
const MARGIN = 4e-12;
/** where that underflows */
const LEAST = 1e-300;
/** of distances: rounding of a box's size and of distances themselves */
const ROUNDING = 1e-14;
/** √floor over distance times n and a safe 2: what the clamp of singular lines changes beyond their ends */
const CLAMPED = 12;

/** Boxes from which the field is less than so often the largest in them need no bound for what is nearer, if w is even. */
const FAR = 3;
const EVEN = 100;

/** what sources may be off by, in parts of what their polynomial leaves out */
const SOURCES = 0.1;

interface Adding {
  add(x: number, y: number, z: number, factor: number, out: FieldValue): void;
}

const sight = new Sight();
const step = new Step();
const choice = new Choice();
const centre = new Float64Array(4);
/** [low, high, rest] of one skel */
const range = new Float64Array(3);

/** What `step` and `sight` are of. */
class Last {
  spreader: Spreader | null = null;
  x = 0.5;
  y = 0.5;
  z = 0.5;
  radius = 0.5;
  isNothing = false;
  /** whether `choice` is made */
  isChosen = false;
}

export class Spreader {
  readonly #kernel: Kernel;
  readonly #exponent: number;
  readonly #extent: Extent;
  /** kernel units of a millimetre */
  readonly #per: number;
  readonly #least: number;
  /** of powers: what is added to r², n, and the field of a line without end at distance 1; 0 where that is not all there is to it */
  readonly #core: number;
  readonly #power: number;
  readonly #line: number;
  readonly #see: See;
  readonly #sources: Sources | null;
  readonly #smooth: Smooth;

  /** `sources`: what stands for the skel from afar; skels that have none are replaced by value and gradient. */
  constructor(
    kernel: Kernel,
    exponent: number,
    extent: Extent,
    per: number,
    see: See,
    sources: Sources | null = null,
  ) {
    this.#sources = sources;
    this.#see = see;
    this.#kernel = kernel;
    this.#exponent = exponent;
    this.#extent = extent;
    this.#per = per;
    const { floor2 } = kernel;
    this.#least = Math.sqrt(extent.dimension === 2 ? floor2.plate : floor2.line);
    const { change, wholeLine } = kernel;
    const isPower = change.type === 'relative';
    this.#core = isPower ? change.core : 0;
    this.#power = isPower ? change.power(exponent) : 0;
    this.#smooth = smoothness(this.#core, this.#power);
    const isLine = isPower && extent.dimension === 1;
    this.#line = isLine && wholeLine ? wholeLine(1 - this.#core, exponent) : 0;
  }

  /** The largest |F| at that squared distance or farther. */
  most(r2: number): number {
    if (this.#line === 0) return this.#mostElse(r2);
    const { size, most } = this.#extent;
    const at = this.#core + Math.max(r2, this.#least * this.#least);
    return most * mostOfPower(at, this.#power, size, this.#line);
  }

  #mostElse(r2: number): number {
    const { dimension, size, turns, most } = this.#extent;
    const n = this.#exponent;
    if (dimension === 1) return most * mostOfLine(this.#kernel, r2, size, n);
    if (dimension === 2) return most * mostOfPlate(this.#kernel, r2, size, turns, n);
    return most * this.#kernel.value(Math.max(r2, this.#least * this.#least), n);
  }

  /** Adds `factor` times the spread of `field` within the ball. */
  add(field: Adding, ball: Ball, factor: number, out: Spread): void {
    if (this.#isNothing(ball)) return;
    for (let i = 0; i < 4; i++) centre[i] = 0;
    field.add(ball.x, ball.y, ball.z, 1, centre);
    const { change } = this.#kernel;
    if (change.type === 'relative') this.#relative(change);
    else this.#absolute(change);
    write(out, factor);
  }

  /** What `ahead` of SkelField says. */
  ahead(field: Adding, ball: Ball, factor: number, out: Ahead): void {
    if (this.#isNothing(ball)) return;
    const before = out[0]!;
    field.add(ball.x, ball.y, ball.z, factor, out);
    const per2 = this.#per * this.#per;
    const size = Math.abs(factor);
    const { change } = this.#kernel;
    if (change.type === 'absolute') {
      out[BEND] = out[BEND]! + size * per2 * this.#bendAhead(change);
      return;
    }
    const m2 = (change.core + step.r * step.r) / per2;
    const whole = this.#extent.sign === 0 ? size * this.most(step.r * step.r) : Math.abs(out[0]! - before);
    out[LOOSE] = out[LOOSE]! + (whole + size * sight.slack) / m2;
    out[WIDTH] = Math.min(out[WIDTH]!, Math.sqrt(m2));
    out[POWER] = change.power(this.#exponent);
    out[MASS] = out[MASS]! + whole + size * sight.slack;
    out[FIRST] = Math.max(out[FIRST]!, this.#smooth.first * this.#per);
    out[SECOND] = Math.max(out[SECOND]!, this.#smooth.second * per2);
  }

  /** The most that second derivatives come to in the ball of the step. */
  #bendAhead(change: AbsoluteChange): number {
    const { dimension, size, turns, most, sign } = this.#extent;
    change.slopes(step, 0);
    let { bend } = step;
    if (dimension > 0) {
      change.slopes(step, dimension);
      bend = Math.min(size * bend, turns * step.bend);
    }
    return (sign === 0 ? 2 * most : most) * bend;
  }

  /** What `missed` of SkelField says. */
  missed(ball: Ball, most: number): number {
    if (this.#isNothing(ball)) return 0;
    const { change } = this.#kernel;
    const { near } = step;
    if (change.type === 'absolute') {
      return (near < this.#kernel.support ? this.most(near * near) : 0) * (1 + MARGIN) + sight.slack;
    }
    if (!sight.isClear || near < this.#least) return Infinity;
    const whole = this.most(step.r * step.r);
    if (this.#sources) change.cubic(step);
    else change.factors(step);
    if (whole * step.bend > most) return Infinity;
    let off = 0;
    if (this.#sources) {
      choose(this.#sources, whole);
      off = choice.off;
    }
    return (whole + off) * step.bend + off + MARGIN * whole + sight.slack;
  }

  /**
   * By how much the field may change within the ball when its places move by `shift` and its mass by `mass`, kernel units: the
   * sources of M^−n move by θ = shift/M and take it to at most (1 − θ)^−n of itself.
   */
  apart(ball: Ball, shift: number, mass: number): number {
    const { change } = this.#kernel;
    this.#isNothing(ball);
    const { near } = step;
    if (change.type === 'absolute' || !sight.isClear || near - shift < this.#least) return Infinity;
    const n = change.power(this.#exponent);
    const theta = shift / Math.sqrt(change.core + near * near);
    if (!(theta < 1)) return Infinity;
    const left = Math.max(near - shift, 0);
    const moved = this.most(near * near) * (halfPower((1 - theta) * (1 - theta), n) - 1);
    return (moved + mass * this.#kernel.value(left * left, this.#exponent)) * (1 + MARGIN) + 2 * sight.slack;
  }

  /** What `standIn` of SkelField says. */
  standIn(field: Adding, ball: Ball, factor: number, out: Taylor): number {
    const { change } = this.#kernel;
    if (this.#isNothing(ball) || change.type === 'absolute') return 0;
    const sources = this.#sources;
    if (!sources) {
      field.add(ball.x, ball.y, ball.z, factor, out);
      return WITH_GRADIENT;
    }
    if (!last.isChosen) {
      change.cubic(step);
      choose(sources, this.most(step.r * step.r));
    }
    const { count } = choice;
    sources.add(ball, factor, count, out);
    return count * POINT;
  }

  /** Sees to the step and the sight; whether the ball is beyond the support. */
  #isNothing(ball: Ball): boolean {
    const { x, y, z, radius } = ball;
    // what is missed too much is asked for its spread next
    if (last.spreader === this && last.x === x && last.y === y && last.z === z && last.radius === radius) {
      return last.isNothing;
    }
    last.isNothing = this.#look(ball);
    last.isChosen = false;
    last.spreader = this;
    last.x = x;
    last.y = y;
    last.z = z;
    last.radius = radius;
    return last.isNothing;
  }

  #look(ball: Ball): boolean {
    this.#see(ball, sight);
    const { distance, slack } = sight;
    const by = ball.radius * this.#per * (1 + ROUNDING);
    const near = Math.max(distance - by - ROUNDING * (distance + by), 0);
    step.r = Math.max(distance * (1 - ROUNDING), this.#least);
    step.by = by;
    step.near = near;
    step.exponent = this.#exponent;
    return this.#extent.most === 0 || (near >= this.#kernel.support && slack === 0);
  }

  #relative(change: RelativeChange): void {
    const { isClear, slack } = sight;
    const { sign, dimension, evenness } = this.#extent;
    change.factors(step);
    const up = Math.min(step.most, 1e300);
    const { near } = step;
    if (sign === 0) {
      // whatever the signs, both parts of the field are within this
      const whole = this.most(step.r * step.r);
      const swing = whole * Math.max(up - 1, 1 - step.least);
      range[0] = centre[0]! - swing;
      range[1] = centre[0]! + swing;
      range[2] = whole * step.bend;
    } else {
      const size = Math.max(sign * centre[0]!, 0);
      const low = Math.max(size - slack, 0) * step.least;
      const high = (size + slack) * up;
      range[0] = sign > 0 ? low : -high;
      range[1] = sign > 0 ? high : -low;
      range[2] = (size + slack) * step.bend;
      if (up < FAR && evenness < EVEN && isClear) {
        this.#cut(evenness * high);
        return;
      }
    }
    const cap = this.most(near * near);
    if (!isClear || near < this.#least) {
      const isBeyond = dimension === 1 && near > this.#least;
      range[2] = isBeyond ? range[2]! + (CLAMPED * cap * this.#least) / near : Infinity;
    }
    this.#cut(cap);
  }

  #absolute(change: AbsoluteChange): void {
    const { dimension, size, turns, most, sign } = this.#extent;
    change.slopes(step, 0);
    let { slope, bend } = step;
    if (dimension > 0) {
      change.slopes(step, dimension);
      slope = Math.min(size * slope, turns * step.slope);
      bend = Math.min(size * bend, turns * step.bend);
    }
    // weights of both signs may add up what both parts come to
    const by = (sign === 0 ? 2 * most : most) * step.by;
    range[0] = centre[0]! - by * slope;
    range[1] = centre[0]! + by * slope;
    range[2] = 0.5 * by * step.by * bend;
    const { near } = step;
    this.#cut(near < this.#kernel.support ? this.most(near * near) : 0);
  }

  /** No more than the skel can have, and the margins. */
  #cut(cap: number): void {
    const { sign } = this.#extent;
    const margin = MARGIN * cap + sight.slack + LEAST;
    range[0] = Math.max(range[0]!, sign > 0 ? 0 : -cap) - margin;
    range[1] = Math.min(range[1]!, sign < 0 ? 0 : cap) + margin;
    range[2] = range[2]! + margin;
  }
}

/** As many sources as what the polynomial leaves out allows. */
function choose(sources: Sources, whole: number): void {
  choice.near = step.near;
  choice.enough = SOURCES * step.bend * whole;
  sources.choose(choice);
  last.isChosen = true;
}

function write(out: Spread, factor: number): void {
  const low = range[0]!;
  const high = range[1]!;
  const rest = range[2]!;
  const size = Math.abs(factor);
  const half = 0.5 * (high - low);
  if (rest < half) {
    out[0] = out[0]! + factor * centre[0]!;
    out[1] = out[1]! + factor * centre[1]!;
    out[2] = out[2]! + factor * centre[2]!;
    out[3] = out[3]! + factor * centre[3]!;
    out[4] = out[4]! + size * rest;
  } else {
    out[0] = out[0]! + factor * (low + half);
    out[4] = out[4]! + size * half;
  }
  out[5] = out[5]! + factor * (factor > 0 ? low : high);
  out[6] = out[6]! + factor * (factor > 0 ? high : low);
}

const last = new Last();
