/**
 * What every parametric surface is before it is a mesh: rows of points along u, each across at one u, and the spine on
 * which its sections stand. Bends (deform.ts) move rows section by section, and stack.
 *
 * All in the coordinates of the drawing plane: x, y on it, z = x × y towards the person who drew, mm.
 */
import type { Vec3 } from '../math/vec.ts';
import type { Columns, Row } from '../mesh/grid.ts';

/** How a section stands and moves at one u; derivatives are by u. */
export interface Station {
  readonly centre: Vec3;
  /** c′(u) */
  readonly rate: Vec3;
  /** unit normal of the section's plane, along u */
  readonly normal: Vec3;
  /** angular velocity ω of the plane: its point p moves with c′ + ω × (p − c), scaling within the plane aside */
  readonly spin: Vec3;
}

export interface Spine {
  /** u = 1 is u = 0 */
  readonly closed: boolean;
  /** ascending from 0 to 1; the spine is smooth between them */
  readonly stops: readonly number[];
  /** `side`: at a stop, the station before (−1) or after (1) it */
  at(u: number, side: -1 | 1): Station;
}

/** Where a row belongs: it is bent as the section there is. */
export interface RowAt {
  readonly u: number;
  readonly side: -1 | 1;
  /** a cap's: it moves with the end, stiffly */
  readonly rigid?: true;
}

export interface SheetRow extends Row {
  readonly at: RowAt;
}

export interface Sheet {
  readonly rows: readonly SheetRow[];
  readonly columns: Columns;
  readonly spine: Spine;
}
