/**
 * Parametric surfaces from strokes. A new one is a file that makes a sheet from curves, and a line in the list.
 * Menus, documents and tests read the list.
 */
import { emptyMesh, gridMesh } from '../mesh/grid.ts';
import type { Mesh } from '../mesh/mesh.ts';
import type { Curve } from '../stroke/curve.ts';
import type { Plane } from '../stroke/stroke.ts';
import { crossSectionSheet } from './crossSection.ts';
import { type BendInput, deform } from './deform.ts';
import { round } from './joined.ts';
import { type PatchOptions, patchSheet } from './patch.ts';
import { rotationalSheet } from './rotational.ts';
import type { Sheet } from './sheet.ts';
import { tubeSheet } from './tube.ts';
import type { PlacedOutline } from './weave.ts';

export type { PlacedOutline };

export type SurfaceKind = 'tube' | 'rotational' | 'crossSection' | 'bspline';

/** What surfaces are made of, all of it in the coordinates of the drawing plane, mm. */
export interface SurfaceInput {
  /** construction curves */
  readonly curves: readonly Curve[];
  /** u ascending, all open or all closed; of kinds without sections they are left alone */
  readonly sections: readonly PlacedOutline[];
  /** one after the other */
  readonly bends: readonly BendInput[];
}

export interface SurfaceOptions {
  /** of tubes, mm, above 0 */
  readonly radius: number;
  /** tubes: the pen's pressure changes the radius */
  readonly pressure: boolean;
  /** ends are closed: on one stroke by domes, between two flat */
  readonly caps: boolean;
  /** quads along the strokes (about) */
  readonly u: number;
  /** quads around, or across (about) */
  readonly v: number;
  /** of patches; without them they have about u × v quads */
  readonly patch?: PatchOptions;
}

interface Counts {
  readonly least: number;
  readonly most: number;
}

export interface Surface {
  readonly id: SurfaceKind;
  readonly label: string;
  /** of how many strokes it is made */
  readonly strokes: Counts;
  /** as it is without bends; null when the strokes enclose nothing */
  sheet(input: SurfaceInput, options: SurfaceOptions): Sheet | null;
}

const crossSection: Surface['sheet'] = ({ curves, sections }, options) =>
  crossSectionSheet(
    { ...options, curves, caps: options.caps ? 'round' : 'none' },
    sections[0]?.outline ?? round,
    options,
  );

export const surfaces: Readonly<Record<SurfaceKind, Surface>> = {
  tube: {
    id: 'tube',
    label: 'Tube',
    strokes: { least: 1, most: 1 },
    sheet: ({ curves: [curve] }, options) =>
      tubeSheet(curve!, { ...options, caps: options.caps ? 'round' : 'none' }),
  },
  rotational: {
    id: 'rotational',
    label: 'Rotational surface',
    strokes: { least: 2, most: 2 },
    sheet: ({ curves: [left, right] }, options) => rotationalSheet(left!, right!, options),
  },
  crossSection: {
    id: 'crossSection',
    label: 'Section surface',
    strokes: { least: 1, most: 2 },
    sheet: crossSection,
  },
  bspline: {
    id: 'bspline',
    label: 'Patch',
    strokes: { least: 1, most: 2 },
    sheet: (input, options) => {
      if (input.sections.length === 0) return crossSection(input, options);
      const { curves, sections } = input;
      const source = { ...options, curves, caps: options.caps ? 'round' : 'none' } as const;
      return patchSheet(source, sections, options.patch ?? quarters(options));
    },
  },
};

/** A patch of u × v quads: quarters of its control spans. */
function quarters({ u, v }: Pick<SurfaceOptions, 'u' | 'v'>): PatchOptions {
  return {
    between: 'cubic',
    rows: Math.ceil(u / 4),
    columns: Math.ceil(v / 4),
    subdivisions: { u: 2, v: 2 },
  };
}

/**
 * A surface with its bends, in the coordinates of the drawing plane; null where the strokes enclose nothing.
 * Throws RangeError when the number of curves does not fit the kind, or an option is out of its range.
 */
export function buildSheet(kind: SurfaceKind, input: SurfaceInput, options: SurfaceOptions): Sheet | null {
  const surface = surfaces[kind];
  if (!surface) throw new RangeError(`surface: unknown kind '${kind}'`);
  const { least, most } = surface.strokes;
  const count = input.curves.length;
  if (count < least || count > most) {
    const wanted = least === most ? most : `${least} to ${most}`;
    throw new RangeError(`surface '${kind}' takes ${wanted} stroke${most === 1 ? '' : 's'}, got ${count}`);
  }
  const sheet = surface.sheet(input, options);
  return sheet && input.bends.reduce(deform, sheet);
}

/** The mesh of a sheet; without triangles where there is none. */
export function sheetMesh(sheet: Sheet | null, plane: Plane): Mesh {
  const mesh = sheet ? gridMesh(sheet.rows, sheet.columns, plane) : emptyMesh();
  return mesh.indices.length > 0 ? mesh : emptyMesh();
}

/** The outward mesh of a surface, closed with `caps` unless its sections are open. Throws as buildSheet does. */
export function buildSurface(
  kind: SurfaceKind,
  input: SurfaceInput,
  plane: Plane,
  options: SurfaceOptions,
): Mesh {
  return sheetMesh(buildSheet(kind, input, options), plane);
}
