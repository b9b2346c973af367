/** What every node of a tree becomes: a field that also knows its colour. */
import type { Field } from '../shape/shape.ts';

export interface TreeField extends Field {
  /** Writes red, green, blue (0–1, linear) and returns the value. Anywhere, though only the surface shows it. */
  colour(x: number, y: number, z: number, out: Float64Array): number;
}
