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
import { FieldError, type SkelField } from '../skeleton/skeleton.ts';
import type { Skel } from '../skeleton/skels.ts';
import { type Extrusion, extrusion } from './extrusion.ts';
import { type PolarProfile, polarProfile } from './polarProfile.ts';
import { ROUND, type Section } from './section.ts';
import { type SuperQuadric, superQuadric } from './superQuadric.ts';
import { type Frame, Warped } from './warped.ts';

export type { Frame } from './warped.ts';

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
