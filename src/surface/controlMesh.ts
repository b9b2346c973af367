/** The control mesh of a patch for people to look at (thesis figs 3.7, 5.16): the very net that is subdivided, bent as the surface is. */

import type { Vec3 } from '../math/vec.ts';
import { evenColumns } from '../mesh/grid.ts';
import type { SectionSource } from './crossSection.ts';
import { type BendInput, deform } from './deform.ts';
import type { Net } from './net.ts';
import type { PatchOptions } from './patch.ts';
import type { SheetRow } from './sheet.ts';
import { sourceOf } from './source.ts';
import { type PlacedOutline, weaveOf } from './weave.ts';
import { controlNets } from './woven.ts';

/** Rows of control points of one smooth piece, in the coordinates of the drawing plane, mm. */
export interface ControlNet {
  readonly rows: readonly (readonly Vec3[])[];
  /** each row goes round */
  readonly closed: boolean;
}

/** One for each piece between creases. Throws as `patchSheet` does. */
export function controlMesh(
  input: SectionSource,
  sections: readonly PlacedOutline[],
  { between, rows, columns }: PatchOptions,
  bends: readonly BendInput[],
): readonly ControlNet[] {
  const source = sourceOf(input);
  if (!(source.length > 0)) return [];
  const weave = weaveOf(source, sections, between, { rows, columns });
  return controlNets(weave).flatMap((nets, i) =>
    nets.map((net) => {
      const straight = {
        rows: rowsOf(net, weave.along[i]!),
        columns: evenColumns(Math.max(1, net.columns - 1)),
        spine: source.spine,
      };
      const bent = bends.reduce(deform, straight).rows.map(({ points }) => pointsOf(points));
      return { rows: bent, closed: weave.alike.seamless };
    }),
  );
}

/** A control row belongs about where it lies along its piece. */
function rowsOf({ rows, columns, points }: Net, { from, to }: { from: number; to: number }): SheetRow[] {
  const width = 3 * columns;
  const up = Float64Array.from({ length: width }, (_, k) => (k % 3 === 2 ? 1 : 0));
  return Array.from({ length: rows }, (_, r) => ({
    points: points.slice(width * r, width * (r + 1)),
    normals: up,
    joined: r > 0,
    at: { u: from + ((to - from) * r) / Math.max(1, rows - 1), side: r === 0 ? 1 : -1 },
  }));
}

const pointsOf = (flat: Float64Array): Vec3[] =>
  Array.from({ length: flat.length / 3 }, (_, k) => [flat[3 * k]!, flat[3 * k + 1]!, flat[3 * k + 2]!]);
