/** What every node of a tree becomes: a field that also knows its colour. */
import type { Field, ShapeField } from '../shape/shape.ts';
import type { LeafFrame } from './leafFrame.ts';
import type { Near, Tally } from './near.ts';

export interface TreeField extends Field {
  /** Writes red, green, blue (0–1, linear) and returns the value. Anywhere, though only the surface shows it. */
  colour(x: number, y: number, z: number, out: Float64Array): number;
  /** Writes [low, high]: the value lies between them everywhere in the cube about (x, y, z) with edges of 2 `half`. */
  range(x: number, y: number, z: number, half: number, out: Float64Array): void;
  /** The field for those who go from cubes into cubes within them. */
  near(tally: Tally): Near;
}

/** A leaf of the tree, in its own frame. */
export interface LeafField extends TreeField, ShapeField {
  /** Where a matrix has put it, `field` being what it is there. */
  nearIn(frame: LeafFrame, field: TreeField, tally: Tally): Near;
}
