/**
 * A skel as plain data, and what it becomes when a kernel is chosen: a field that adds itself into a sum. The work that
 * does not depend on the point is done once, in `bind`.
 */

import type { Kernel, KernelParams } from '../kernel/kernel.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Ahead } from './ahead.ts';
import type { Ball } from './ball.ts';
import type { Taylor } from './taylor.ts';

/** [value, ∂x, ∂y, ∂z], mm and 1/mm; mutable: evaluators add to it. */
export type FieldValue = Float64Array;

/**
 * What a field may be within a ball: [middle, ∂x, ∂y, ∂z, rest, low, high], |F − middle − ∂·v| ≤ rest, v from the centre of the
 * ball, and low ≤ F ≤ high; as computed, rounding included. Mutable: skels add to it.
 */
export type Spread = Float64Array;

/** numbers of a Spread */
export const SPREAD = 7;

export interface Box {
  readonly min: Vec3;
  readonly max: Vec3;
}

export interface SkelField {
  value(x: number, y: number, z: number): number;
  /** Adds `factor` times value and gradient. */
  add(x: number, y: number, z: number, factor: number, out: FieldValue): void;
  /** Adds `factor` times the spread within the ball; exactly nothing beyond a support. */
  spread(ball: Ball, factor: number, out: Spread): void;
  /**
   * A bound on what the stand-in misses within the ball, without an evaluation; Infinity where none is known or it is surely above
   * `most`, 0 beyond a support.
   */
  missed(ball: Ball, most: number): number;
  /**
   * Adds `factor` times what may stand for the field within the ball, about its centre: a polynomial of the second
   * degree (points, segments), of the first (polygons), or nothing (kernels that are no powers). Says what it took (work.ts).
   */
  standIn(ball: Ball, factor: number, out: Taylor): number;
  /** whether what the stand-in misses falls as the third power of the distance from the centre of the ball, nearly */
  readonly isCubic: boolean;
  /** By how much the field may differ from that of a skel that was moved or weighted a little otherwise, within the ball; Infinity where that is not known. */
  apart(other: SkelField, ball: Ball): number;
  /** Adds `factor` times value and gradient at the centre, and what bounds the field in the ball ahead of there (ahead.ts). */
  ahead(ball: Ball, factor: number, out: Ahead): void;
  /** of the skel itself, without its field */
  readonly box: Box;
  /** mm from the skel beyond which |value| < `threshold`; 0 when it is nowhere larger (docs/fields.md, “In print”: Zhu et al. 2011 (17)–(19)) */
  offset(threshold: number): number;
}

/** One kind of skel. `S` is its data. */
export interface Skeleton<S> {
  readonly name: string;
  /** Checks what types cannot say and prepares; throws FieldError for what has no field (see docs/fields.md). */
  bind(skel: S, kernel: Kernel, params: KernelParams): SkelField;
}

/** What cannot be built, in words, with the place in the tree. */
export class FieldError extends Error {
  override readonly name = 'FieldError';
}
