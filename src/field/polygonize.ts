/**
 * The surface of a field as a mesh: marching cubes on a regular lattice, with exact values where the surface may be and proven signs
 * elsewhere (culledSampling.ts): watertight, with vertices on the surface and the field's own normals. Simple in that the
 * lattice itself is dense, that each value takes all skels, and that nothing is kept from one body to the next.
 *
 * The steps are generators that yield the share done of the step they are at, so that a worker may pause or give up between
 * them; `polygonize` runs all of them at once.
 */

import type { Box } from '../skeleton/skeleton.ts';
import { culledSampling } from './culledSampling.ts';
import { crossed, fitting } from './fitBox.ts';
import { type Lattice, type LatticeValues, latticeAround, latticeOver } from './lattice.ts';
import type { FieldMesh } from './latticeMesh.ts';
import { meshing } from './latticeMesh.ts';
import type { TreeField } from './treeField.ts';

export interface Polygonized {
  readonly mesh: FieldMesh;
  readonly lattice: Lattice;
  /** values, slopes and colours taken of the field; those from elsewhere are not among them */
  readonly evaluations: number;
}

/** Where lattice values come from; `Wait` is what a step may have to wait for. */
export type Sampler<Wait = never> = (
  field: TreeField,
  lattice: Lattice,
) => Generator<number | Wait, LatticeValues>;

/** mm to all sides of the origin: what is seen of bodies without end, such as half-spaces */
export const PAGE = 100;

/** A body that still leaves its lattice after so many rounds is cut off there. */
const ROUNDS = 6;

/** Runs to the end; see `polygonizing`. */
export function polygonize(field: TreeField, resolution: number, box: Box | null = field.box): Polygonized {
  const work = polygonizing(field, resolution, culledSampling, box);
  for (;;) {
    const { done, value } = work.next();
    if (done) return value;
  }
}

/**
 * `resolution` cells along the longest side of the body in `box`, which is fitted to the body, and grown where the body leaves
 * it. Without a box the body has no end, and is cut off at `PAGE`. FieldError for a box of no finite numbers.
 */
export function* polygonizing<Wait>(
  field: TreeField,
  resolution: number,
  sampler: Sampler<Wait>,
  box: Box | null = field.box,
): Generator<number | Wait, Polygonized> {
  const counted = new Counted(field);
  // a lattice where nothing is makes an empty mesh
  let around = box && ((yield* fitting(counted, box)) ?? box);
  for (let round = 0; ; round++) {
    const lattice = around ? latticeAround(around, resolution) : latticeOver(PAGE, resolution);
    const values = yield* sampler(counted, lattice);
    const larger = around && round < ROUNDS ? crossed(around, lattice, values) : null;
    if (!larger) {
      const mesh = yield* meshing(counted, lattice, values);
      return { mesh, lattice, evaluations: counted.evaluations };
    }
    around = larger;
  }
}

/** A field that counts what is asked of it. */
class Counted implements TreeField {
  evaluations = 0;
  readonly box: Box | null;
  readonly #field: TreeField;

  constructor(field: TreeField) {
    this.#field = field;
    this.box = field.box;
  }

  value(x: number, y: number, z: number): number {
    this.evaluations++;
    return this.#field.value(x, y, z);
  }

  evaluate(x: number, y: number, z: number, out: Float64Array): void {
    this.evaluations++;
    this.#field.evaluate(x, y, z, out);
  }

  colour(x: number, y: number, z: number, out: Float64Array): number {
    this.evaluations++;
    return this.#field.colour(x, y, z, out);
  }

  range(x: number, y: number, z: number, half: number, out: Float64Array): void {
    this.evaluations++;
    this.#field.range(x, y, z, half, out);
  }

  boxAbove(level: number): Box | null {
    return this.#field.boxAbove(level);
  }
}
