/** The field of a skel with a cross section: see warp.ts. The point is mapped, the plain skel evaluated there, the gradient brought back. */

import { scale3 as scaled } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import {
  AHEAD,
  type Ahead,
  BEND,
  clearAhead,
  FIRST,
  LIMIT,
  LOOSE,
  MASS,
  POWER,
  SECOND,
  WIDTH,
} from '../skeleton/ahead.ts';
import { Ball } from '../skeleton/ball.ts';
import { type Box, type FieldValue, type SkelField, SPREAD, type Spread } from '../skeleton/skeleton.ts';
import { addMapped, TAYLOR, type Taylor } from '../skeleton/taylor.ts';
import { type Affine, mappedBox } from './affine.ts';
import type { Section } from './section.ts';

export interface Frame {
  readonly origin: Vec3;
  readonly x: Vec3;
  readonly y: Vec3;
  readonly z: Vec3;
}

/** of coordinates */
const ROUNDING = 4e-15;

/** A ball in the frame of the plain skel. Mutable; the numbers say that these are doubles. */
class Seen {
  readonly ball = new Ball();
  /** how far its points are from there at most, and how far from where the derivatives take them */
  reach = 0.5;
  bend = 0.5;
  isLinear = false;
  /** across the skel, before the section */
  qx = 0.5;
  qy = 0.5;
}

const seen = new Seen();

export class Warped implements SkelField {
  readonly #skel: SkelField;
  readonly #frame: Frame;
  readonly #section: Section;
  readonly #bx: number;
  readonly #by: number;
  readonly #stretch = new Float64Array(3);
  readonly #scratch = new Float64Array(4);
  readonly #spread = new Float64Array(SPREAD);
  readonly #move = new Float64Array(2);
  readonly box: Box;
  readonly isCubic = false;
  readonly #local = new Float64Array(TAYLOR);
  readonly #ahead = new Float64Array(AHEAD);
  readonly #ball = new Ball();

  constructor(skel: SkelField, frame: Frame, section: Section, bx: number, by: number) {
    this.#skel = skel;
    this.#frame = frame;
    this.#section = section;
    this.#bx = bx;
    this.#by = by;
    this.box = this.#boxAt(0);
  }

  value(x: number, y: number, z: number): number {
    const { origin, x: ex, y: ey, z: ez } = this.#frame;
    const dx = x - origin[0];
    const dy = y - origin[1];
    const dz = z - origin[2];
    const qx = (ex[0] * dx + ex[1] * dy + ex[2] * dz) / this.#bx;
    const qy = (ey[0] * dx + ey[1] * dy + ey[2] * dz) / this.#by;
    const m = this.#section.value(qx, qy);
    return this.#skel.value(m * qx, m * qy, ez[0] * dx + ez[1] * dy + ez[2] * dz);
  }

  add(x: number, y: number, z: number, factor: number, out: FieldValue): void {
    const { origin, x: ex, y: ey, z: ez } = this.#frame;
    const dx = x - origin[0];
    const dy = y - origin[1];
    const dz = z - origin[2];
    const qx = (ex[0] * dx + ex[1] * dy + ex[2] * dz) / this.#bx;
    const qy = (ey[0] * dx + ey[1] * dy + ey[2] * dz) / this.#by;
    const stretch = this.#stretch;
    this.#section.evaluate(qx, qy, stretch);
    const m = stretch[0]!;
    const local = this.#scratch.fill(0);
    this.#skel.add(m * qx, m * qy, ez[0] * dx + ez[1] * dy + ez[2] * dz, factor, local);
    const radial = local[1]! * qx + local[2]! * qy;
    const gx = (m * local[1]! + radial * stretch[1]!) / this.#bx;
    const gy = (m * local[2]! + radial * stretch[2]!) / this.#by;
    const gz = local[3]!;
    out[0]! += local[0]!;
    out[1]! += ex[0] * gx + ey[0] * gy + ez[0] * gz;
    out[2]! += ex[1] * gx + ey[1] * gy + ez[1] * gz;
    out[3]! += ex[2] * gx + ey[2] * gy + ez[2] * gz;
  }

  spread(ball: Ball, factor: number, out: Spread): void {
    const local = this.#spread.fill(0);
    this.#skel.spread(this.#see(ball), factor, local);
    if (local[4]! > 0) this.#back(local, out);
  }

  /** The map keeps quadratics only where it is linear; elsewhere what is missed but beyond a support is not known. */
  missed(ball: Ball, most: number): number {
    const missed = this.#skel.missed(this.#see(ball), most);
    return seen.isLinear || missed === 0 ? missed : Infinity;
  }

  /** By what derivatives and bends of the map come to, up to half the way to the axis. */
  ahead({ x, y, z, radius: along }: Ball, factor: number, out: Ahead): void {
    const ball = this.#ball;
    this.#see(ball.set(x, y, z, 0));
    const rho = Math.sqrt(seen.qx * seen.qx + seen.qy * seen.qy);
    const reach = Math.min(along, 0.5 * rho * Math.min(this.#bx, this.#by));
    const within = this.#see(ball.set(x, y, z, reach));
    this.add(x, y, z, factor, out);
    const by = this.#steepest() + (seen.bend > 0 ? seen.bend / reach : 0);
    if (!(reach > 0 && by < Infinity)) {
      out[WIDTH] = 0;
      out[LIMIT] = 0;
      return;
    }
    const local = this.#ahead;
    clearAhead(local);
    within.radius = by * reach;
    this.#skel.ahead(within, factor, local);
    const across = Math.sqrt(local[1]! * local[1]! + local[2]! * local[2]!);
    out[LOOSE] = out[LOOSE]! + local[LOOSE]! * by * by;
    out[BEND] = out[BEND]! + local[BEND]! * by * by + (2 * across * seen.bend) / (reach * reach);
    out[WIDTH] = Math.min(out[WIDTH]!, local[WIDTH]! / by, reach < along ? reach : Infinity);
    if (local[LOOSE]! > 0) out[POWER] = local[POWER]!;
    out[MASS] = out[MASS]! + local[MASS]!;
    out[FIRST] = Math.max(out[FIRST]!, by * local[FIRST]!);
    // maps that bend told less by such bounds than by Taylor's remainder
    out[SECOND] = Math.max(out[SECOND]!, seen.isLinear ? by * by * local[SECOND]! : Infinity);
    out[LIMIT] = Math.min(out[LIMIT]!, reach < along ? reach : Infinity);
  }

  /** How far the map stretches at the place seen, at most. */
  #steepest(): number {
    const [m, mx, my] = [this.#stretch[0]!, this.#stretch[1]!, this.#stretch[2]!];
    const { qx, qy } = seen;
    const x = [(m + qx * mx) / this.#bx, (qx * my) / this.#by];
    const y = [(qy * mx) / this.#bx, (m + qy * my) / this.#by];
    return Math.max(Math.sqrt([...x, ...y].reduce((sum, d) => sum + d * d, 0)), 1);
  }

  apart(): number {
    return Infinity;
  }

  standIn(ball: Ball, factor: number, out: Taylor): number {
    const local = this.#local.fill(0);
    const within = this.#see(ball);
    const m = this.#stretch[0]!;
    const work = this.#skel.standIn(within, factor, local);
    const { x: ex, y: ey, z: ez } = this.#frame;
    if (work > 0) addMapped(local, [...scaled(ex, m / this.#bx), ...scaled(ey, m / this.#by), ...ez], out);
    return work;
  }

  /** Adds a spread of the plain skel: with its gradient brought back, or where the map bends too much for that without one. */
  #back(local: Spread, out: Spread): void {
    const { qx, qy, reach, bend } = seen;
    const { x: ex, y: ey, z: ez } = this.#frame;
    const [gx, gy, gz] = [local[1]!, local[2]!, local[3]!];
    const across = Math.sqrt(gx * gx + gy * gy);
    const swing = reach * Math.sqrt(gx * gx + gy * gy + gz * gz) + local[4]!;
    const low = Math.max(local[5]!, local[0]! - swing);
    const high = Math.min(local[6]!, local[0]! + swing);
    const half = 0.5 * (high - low);
    const rest = local[4]! + (across > 0 ? across * bend : 0);
    out[5] = out[5]! + low;
    out[6] = out[6]! + high;
    out[4] = out[4]! + Math.min(rest, half);
    out[0] = out[0]! + (rest < half ? local[0]! : low + half);
    if (rest >= half) return;
    const stretch = this.#stretch;
    const radial = gx * qx + gy * qy;
    const wx = (stretch[0]! * gx + radial * stretch[1]!) / this.#bx;
    const wy = (stretch[0]! * gy + radial * stretch[2]!) / this.#by;
    for (let i = 0; i < 3; i++) out[i + 1] = out[i + 1]! + ex[i]! * wx + ey[i]! * wy + ez[i]! * gz;
  }

  /** The ball in the frame of the plain skel, which holds all that the map takes there. */
  #see({ x, y, z, radius }: Ball): Ball {
    const { origin, x: ex, y: ey, z: ez } = this.#frame;
    const dx = x - origin[0];
    const dy = y - origin[1];
    const dz = z - origin[2];
    const qx = (ex[0] * dx + ex[1] * dy + ex[2] * dz) / this.#bx;
    const qy = (ey[0] * dx + ey[1] * dy + ey[2] * dz) / this.#by;
    this.#section.evaluate(qx, qy, this.#stretch);
    const m = this.#stretch[0]!;
    const off = ROUNDING * (Math.abs(dx) + Math.abs(dy) + Math.abs(dz) + radius);
    const by = radius + off;
    this.#section.move(qx, qy, m, by / this.#bx, by / this.#by, this.#move);
    const across = this.#move[0]!;
    // a map without a bend takes balls to ellipsoids
    seen.isLinear = this.#move[1] === 0;
    seen.reach = seen.isLinear ? Math.max(across, by) : Math.sqrt(across * across + by * by) * (1 + ROUNDING);
    seen.bend = this.#move[1]! + off;
    seen.qx = qx;
    seen.qy = qy;
    return seen.ball.set(m * qx, m * qy, ez[0] * dx + ez[1] * dy + ez[2] * dz, seen.reach);
  }

  offset(threshold: number): number {
    const reach = this.#skel.offset(threshold);
    if (!(reach > 0)) return 0;
    const box = this.#boxAt(reach);
    const out = [0, 1, 2].flatMap((i) => [this.box.min[i]! - box.min[i]!, box.max[i]! - this.box.max[i]!]);
    return Math.max(...out);
  }

  /** Holds all points that are mapped to within `reach` of the plain skel's box. */
  #boxAt(reach: number): Box {
    const { min, max } = this.#skel.box;
    const [hx, hy] = this.#halfSizes(reach);
    const local: Box = { min: [-hx, -hy, min[2] - reach], max: [hx, hy, max[2] + reach] };
    const { origin: o, x, y, z } = this.#frame;
    const toWorld: Affine = [x[0], y[0], z[0], o[0], x[1], y[1], z[1], o[1], x[2], y[2], z[2], o[2]];
    return mappedBox(toWorld, local);
  }

  /** Of that box across the skel. What is flat stays flat: points are moved towards the axis or away from it only. */
  #halfSizes(reach: number): readonly [x: number, y: number] {
    const { min, max } = this.#skel.box;
    const far = (i: 0 | 1) => Math.max(-min[i], max[i]);
    const [wide, high] = [far(0), far(1)];
    const [hx, hy] = this.#section.extent(Math.sqrt(wide * wide + high * high) + reach);
    return [wide + reach === 0 ? 0 : this.#bx * hx, high + reach === 0 ? 0 : this.#by * hy];
  }
}
