/** A body on the field page, wherever its mesh was made and lies. */
import type { FieldMesh } from '../../field/brickMesh.ts';
import type { Lattice } from '../../field/lattice.ts';
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
  readonly milliseconds: number;
  /** who made it, in words */
  readonly maker: string;
}
