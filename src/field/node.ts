/**
 * The tree of a field as plain data: what documents hold and commands change. Lengths in mm. Inside is where the value is
 * positive; convolution bodies come in as F − T.
 */
import type { KernelParams } from '../kernel/kernel.ts';
import type { Shape } from '../shape/index.ts';
import type { Affine } from './affine.ts';
import type { BlendAmounts } from './blendUnion.ts';
import type { AnySkel } from './expand.ts';
import type { Warp } from './warp.ts';

/** Light: red, green, blue, 0–1, linear. */
export type Colour = readonly [red: number, green: number, blue: number];

/** One term of a sum. */
export interface Term {
  readonly skel: AnySkel;
  /** of the kernel, in place of the body's: thick and thin limbs of one sum have each the width that suits them */
  readonly params?: KernelParams;
  /** λ; below 0 it carves softly. 1 when left out */
  readonly factor?: number;
  /** of its cross section; plain skels pay nothing */
  readonly warp?: Warp;
  /** the body's when left out */
  readonly colour?: Colour;
}

/** Σ λ_i F_i − T: a convolution body. */
export interface SkelsNode {
  readonly type: 'skels';
  readonly kernel: string;
  readonly params: KernelParams;
  /** T, above 0 */
  readonly threshold: number;
  readonly skels: readonly Term[];
  readonly colour?: Colour;
}

export interface ShapeNode {
  readonly type: 'shape';
  readonly shape: Shape;
  readonly colour?: Colour;
}

/** Of all parts, from the first to the last; subtraction takes all others from the first. */
export interface SetNode {
  readonly type: 'union' | 'intersection' | 'subtraction';
  /** hard: max and min, with sharp edges; smooth: R-functions, the same surface, differentiable off those edges */
  readonly form: 'hard' | 'smooth';
  readonly parts: readonly FieldNode[];
}

/** The blending union of two: see blendUnion.ts. */
export interface BlendNode extends BlendAmounts {
  readonly type: 'blend';
  readonly a: FieldNode;
  readonly b: FieldNode;
}

/** Metamorphosis: `from` at t = 0, `to` at t = 1. */
export interface MorphNode {
  readonly type: 'morph';
  readonly from: FieldNode;
  readonly to: FieldNode;
  readonly t: number;
}

/**
 * `node` mapped by a matrix. It goes down to the leaves: a shape's value is multiplied by the matrix' least stretch, so that
 * it stays the distance under similarities and never exceeds it under others; F − T keeps its value. A tree that is placed
 * or scaled is thus the tree that was built there.
 */
export interface AffineNode {
  readonly type: 'affine';
  readonly matrix: Affine;
  readonly node: FieldNode;
}

export type FieldNode = SkelsNode | ShapeNode | SetNode | BlendNode | MorphNode | AffineNode;

/** The one that all have, if they do. */
export function commonColour(colours: readonly (Colour | null)[]): Colour | null {
  const first = colours[0] ?? null;
  return first && colours.every((colour) => colour?.every((x, i) => x === first[i])) ? first : null;
}
