/**
 * A skel with a cross section of its own (Tai et al. (10)–(12)): the point is brought into the skel's frame, the scalings
 * are undone first and the section after them, then the plain skel is evaluated there. Gradient Jᵀ ∇F. The skel is bound
 * in its own frame, so that coordinates far from the origin cost nothing.
 *
 * Frames (x, y, z): a segment's z runs along it, y is `up` as far as it stands across; a point's z is `along`; a polygon's y
 * is its normal and z its u.
 */
import { cross3, dot3, length3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import {
  type Box,
  FieldError,
  type FieldValue,
  type SkelField,
  SPREAD,
  type Spread,
} from '../skeleton/skeleton.ts';
import type { Skel } from '../skeleton/skels.ts';
import { type Affine, mappedBox } from './affine.ts';
import { type Extrusion, extrusion } from './extrusion.ts';
import { type PolarProfile, polarProfile } from './polarProfile.ts';
import { ROUND, type Section } from './section.ts';
import { type SuperQuadric, superQuadric } from './superQuadric.ts';

export interface Warp {
  readonly section: { readonly type: 'round' } | SuperQuadric | Extrusion | PolarProfile;
  /** β_x, β_y: how much wider the section is, above 0 */
  readonly scale: readonly [x: number, y: number];
  /** of segments and points: where the section's y points; any length, not along the skel */
  readonly up?: Vec3;
  /** of points: across the section, any length */
  readonly along?: Vec3;
}

/**
 * `bind` makes the plain field of the skel in its own frame. FieldError for numbers out of range and for a frame that `up`
 * does not determine.
 */
export function bindWarped(skel: Skel, warp: Warp, bind: (local: Skel) => SkelField): SkelField {
  const [bx, by] = warp.scale;
  if (warp.scale.length !== 2) throw new FieldError(`scale must be 2 numbers, got ${warp.scale.length}`);
  for (const [i, scale] of warp.scale.entries()) {
    if (!(scale > 0 && scale < Infinity)) throw new FieldError(`scale[${i}] must be above 0, got ${scale}`);
  }
  const { frame, local } = framed(skel, warp);
  return new Warped(bind(local), frame, bindSection(warp.section), bx, by);
}

function bindSection(section: Warp['section']): Section {
  switch (section.type) {
    case 'round':
      return ROUND;
    case 'superQuadric':
      return superQuadric(section);
    case 'extrusion':
      return extrusion(section);
    case 'polar':
      return polarProfile(section);
    default:
      throw new FieldError(`unknown section '${(section as { type: string }).type}'`);
  }
}

export interface Frame {
  readonly origin: Vec3;
  readonly x: Vec3;
  readonly y: Vec3;
  readonly z: Vec3;
}

export function framed(skel: Skel, { up, along }: Warp): { readonly frame: Frame; readonly local: Skel } {
  switch (skel.type) {
    case 'segment': {
      const axis = sub3(skel.b, skel.a);
      const frame = across(skel.a, axis, up);
      return { frame, local: { ...skel, a: [0, 0, 0], b: [0, 0, length3(axis)] } };
    }
    case 'point':
      return { frame: across(skel.at, along, up), local: { ...skel, at: [0, 0, 0] } };
    case 'polygon': {
      const frame = across(skel.origin, skel.u, cross3(skel.u, skel.v));
      return { frame, local: { ...skel, origin: [0, 0, 0], u: [0, 0, 1], v: [1, 0, 0] } };
    }
  }
}

/** z along `axis`, y as near to `up` as it can be. */
function across(origin: Vec3, axis: Vec3 | undefined, up: Vec3 | undefined): Frame {
  const z = direction(axis, 'a warped skel has no direction along');
  const towards = direction(up, 'a warped skel needs up');
  const y = direction(perpendicular(towards, z), 'up must not point along the skel');
  return { origin, x: cross3(y, z), y, z };
}

function perpendicular(v: Vec3, unit: Vec3): Vec3 {
  const rest = sub3(v, scale3(unit, dot3(v, unit)));
  return length3(rest) > 1e-6 ? rest : [0, 0, 0];
}

function direction(v: Vec3 | undefined, message: string): Vec3 {
  const length = v ? length3(v) : 0;
  if (!v || !(length > 0 && length < Infinity)) throw new FieldError(message);
  return scale3(v, 1 / length);
}

/** of coordinates */
const ROUNDING = 4e-15;

class Warped implements SkelField {
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

  spread(x: number, y: number, z: number, radius: number, factor: number, out: Spread): void {
    const { origin, x: ex, y: ey, z: ez } = this.#frame;
    const dx = x - origin[0];
    const dy = y - origin[1];
    const dz = z - origin[2];
    const qx = (ex[0] * dx + ex[1] * dy + ex[2] * dz) / this.#bx;
    const qy = (ey[0] * dx + ey[1] * dy + ey[2] * dz) / this.#by;
    const stretch = this.#stretch;
    this.#section.evaluate(qx, qy, stretch);
    const m = stretch[0]!;
    const by = radius + ROUNDING * (Math.abs(dx) + Math.abs(dy) + Math.abs(dz));
    this.#section.move(qx, qy, m, by / this.#bx, by / this.#by, this.#move);
    const across = this.#move[0]!;
    const bend = this.#move[1]!;
    // a map without a bend takes balls to ellipsoids
    const reach = bend === 0 ? Math.max(across, by) : Math.sqrt(across * across + by * by) * (1 + ROUNDING);
    const local = this.#spread.fill(0);
    this.#skel.spread(m * qx, m * qy, ez[0] * dx + ez[1] * dy + ez[2] * dz, reach, factor, local);
    if (local[4] === 0 && local[5] === local[6]) return;
    const gx = local[1]!;
    const gy = local[2]!;
    const gz = local[3]!;
    const swing = reach * Math.sqrt(gx * gx + gy * gy + gz * gz) + local[4]!;
    const low = Math.max(local[5]!, local[0]! - swing);
    const high = Math.min(local[6]!, local[0]! + swing);
    const half = 0.5 * (high - low);
    const slope = Math.sqrt(gx * gx + gy * gy);
    const rest = local[4]! + (slope > 0 ? slope * bend : 0);
    out[5] = out[5]! + low;
    out[6] = out[6]! + high;
    out[4] = out[4]! + Math.min(rest, half);
    out[0] = out[0]! + (rest < half ? local[0]! : low + half);
    if (rest >= half) return;
    const radial = gx * qx + gy * qy;
    const wx = (m * gx + radial * stretch[1]!) / this.#bx;
    const wy = (m * gy + radial * stretch[2]!) / this.#by;
    for (let i = 0; i < 3; i++) out[i + 1] = out[i + 1]! + ex[i]! * wx + ey[i]! * wy + ez[i]! * gz;
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
