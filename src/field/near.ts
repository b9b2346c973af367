/**
 * A field as it is within a cube: what its values may be there, and evaluators that ask only what matters there. An octree hands
 * it down from cubes to the cubes within them, so that a small one never looks at all skels.
 */

import type { Vec3 } from '../math/vec.ts';
import type { FieldValue } from '../skeleton/skeleton.ts';
import type { Taylor } from '../skeleton/taylor.ts';
import type { BoundTerm } from './boundTerm.ts';
import type { Colour } from './node.ts';
import type { Numbers } from './numbered.ts';

/**
 * Counts what is asked, in values of one skel (skeleton/work.ts), and numbers the nodes of a tree: leaves and sets, as numbered.ts does.
 * One for a whole tree.
 */
export class Tally {
  work = 0;
  /** that were numbered */
  leaves = 0;
  sets = 0;
  /** of a tree that was edited; null: leaves 0, 1, …, sets −1, −2, … */
  numbers: Numbers | null = null;

  leaf(): number {
    const at = this.leaves++;
    return this.numbers?.leaves[at] ?? at;
  }

  set(): number {
    const at = this.sets++;
    return this.numbers?.sets[at] ?? -1 - at;
  }
}

/** faces of a shape at most */
const FACES = 8;

/** The number of a smooth field: of a node, or of a face of one. */
export const branchOf = (node: number, face = 0): number => FACES * node + face;
/** Whether it is a face of that node. */
export const isFaceOf = (node: number, branch: number): boolean => Math.floor(branch / FACES) === node;

/** The unit direction of a ray. */
export type Ray = Vec3;

export interface Near {
  /** all values in the cube lie between them */
  readonly low: number;
  readonly high: number;
  /** by how much values may be off in the cube */
  readonly error: number;
  /** the same at a place in it, nearly: polynomials miss little near their centres */
  errorAt(x: number, y: number, z: number): number;
  /** skels that a value asks */
  readonly asked: number;
  /** how many smooth fields its values come from; they change at creases */
  readonly branches: number;
  /** its number in the tree, which it keeps through edits */
  readonly node: number;
  /** the colour that it has everywhere; null where that is not known */
  readonly plain: Colour | null;
  value(x: number, y: number, z: number): number;
  evaluate(x: number, y: number, z: number, out: FieldValue): void;
  /** Writes red, green, blue and returns the value. */
  colour(x: number, y: number, z: number, out: Float64Array): number;
  /** The number of the smooth field that the value is from, or would be from if it were 0. */
  branch(x: number, y: number, z: number): number;
  /** Whether that is one of its smooth fields. */
  holds(branch: number): boolean;
  /** Value and gradient of that field, also beyond the crease. */
  onBranch(branch: number, x: number, y: number, z: number, out: FieldValue): void;
  /** Looks along a ray from a point in the cube on, as far as `reach` mm: returns the value there. What was seen is kept till the next look. */
  look(ray: Ray, x: number, y: number, z: number, reach: number): number;
  /** How far from there on the value surely keeps its sign, mm. */
  clear(): number;
  /** How far it is from there on at most until the sign changes, Infinity where that is not known; `clear`: what `clear` said. */
  reached(clear: number): number;
  /** How far from there to all sides the value surely keeps its sign, mm; 0 where that is not known. */
  around(): number;
  /** Writes [low, high] of the values from there on over t mm, at most `reach`. */
  ahead(t: number, out: Float64Array): void;
  /** In a cube within this one, about (x, y, z) with edges of 2 `half`; surfaces may be off by `missed` mm, nearly. */
  within(x: number, y: number, z: number, half: number, missed: number): Near;
  /**
   * Writes the values at the 125 corners of a brick's cells, interpolated between its nodes where that is possible, and says by
   * how much they may be off for that, as far as the nodes tell.
   */
  corners(nodes: BrickCorners, out: Float64Array): number;
  /** of its values near the surface, a millimetre, nearly */
  readonly steep: number;
  /** mm: by how much the surface may be off at most, however large cells are; more would make intervals wider */
  readonly mostMissed: number;
  /**
   * By how much changes may move its values in the cube, at most; Infinity where that is not known. `newer`: the same tree after them, in a
   * cube around. What earlier changes have moved them by comes on top.
   */
  effect(newer: Near, changes: Changes, x: number, y: number, z: number, half: number): number;
  /** Every leaf of the tree once, also those that were left out. */
  eachLeaf(visit: (leaf: NearLeaf) => void): void;
  /** All leaves so that the whole is far above or below 0. */
  eachDropped(way: Way, visit: (leaf: NearLeaf) => void): void;
}

/** The corners of one brick's cells, for the leaves of its tree (brickNodes.ts). */
export interface BrickCorners {
  /** of nodes, which are every second corner, mm */
  readonly apart: number;
  /** whether the sign is enough where a leaf is surely not 0 */
  roughly: boolean;
  /** Each writes 125 values and says by how much they may be off: from nodes, */
  interpolated(near: Near, leaf: number, out: Float64Array): number;
  /** by the list of the brick, */
  exact(near: Near, out: Float64Array): number;
  /** by lists of its halves, which may miss as much; where they are culled a rough value of the right sign. */
  halved(near: Near, missed: number, out: Float64Array): number;
}

/** What became of nodes, by their numbers; those that are not there are as they were. Sets are there if anything within them is. */
export type Changes = ReadonlyMap<number, LeafChange>;

/** Terms of a sum that went and terms that came; null: it is another leaf, or a set. */
export type LeafChange = {
  readonly removed: readonly BoundTerm[];
  readonly added: readonly BoundTerm[];
} | null;

export type Way = 'low' | 'high';

/** A sum or a shape as it is within a cube. */
export interface NearLeaf {
  /** its number, without edits in the order of the tree */
  readonly leaf: number;
  /** far from 0, so that others decide; null where it counts */
  readonly dropped: Way | null;
  /** numbers of the terms that are asked, ascending; null for shapes */
  readonly terms: readonly number[] | null;
  readonly far: Far | null;
  /** of sums, told where all of it is asked for: of the field about its surface, nearly, a millimetre */
  readonly steep?: number;
}

/** All other terms of a sum together, less T, in the frame of the leaf. */
export interface Far {
  readonly centre: Vec3;
  readonly taylor: Taylor;
  /** what they weigh in the mean of colours at the centre, and red, green, blue times that; nothing where all are of one colour */
  readonly colour: Float64Array;
}

/** The most that values of the one may differ from those of the other. */
export const rangesApart = (a: Pick<Near, 'low' | 'high'>, b: Pick<Near, 'low' | 'high'>): number =>
  Math.max(a.high - b.low, b.high - a.low);
