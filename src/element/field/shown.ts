/** A body on the field page, wherever its mesh was made and lies. */
import type { FieldMesh } from '../../field/brickMesh.ts';
import type { Lattice } from '../../field/lattice.ts';
import type { Thin } from '../../field/thin.ts';
import type { DeviceMesh } from '../../scene/deviceMesh.ts';

export interface Shown {
  /** of the wish */
  readonly id: number;
  readonly draft: boolean;
  readonly mesh: FieldMesh | DeviceMesh;
  readonly vertices: number;
  readonly triangles: number;
  readonly lattice: Lattice;
  readonly evaluations: number;
  /** from the change to the mesh: drafts, whoever else was waited for, and the way to the page, too */
  readonly milliseconds: number;
  /** where it is thinner than its cells; null: nowhere; left out: nobody looked, for it lies on the device */
  readonly thin?: Thin | null;
  /** who made it, in words */
  readonly maker: string;
}
